#include "shop/files/obrys/machine_edit.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "base/text.hpp"
#include "shop/files/section.hpp"

namespace obrys::shop {
namespace {

struct Edit {
    std::size_t begin = 0, end = 0;
    std::string text;
};

class Editor {
public:
    Editor(const Value& root, std::string_view text) : root_(root), text_(text) {}

    void set(const NewValue& v) {
        const std::size_t dot = v.name.find('.'), last = v.name.rfind('.');
        const std::string key = dot == std::string::npos ? v.name : v.name.substr(last + 1);
        if (dot == std::string::npos)
            set_root(key, v.value);
        else if (dot == last)
            set_in(v.name.substr(0, dot), key, v.value);
        else if (const Value* axis = axis_of(v.name.substr(dot + 1, last - dot - 1)))
            set_key(*axis, key, v.value);
        else
            return;
        set_in("origin", "\"" + v.name + "\"", quoted(v.origin), v.name);
    }

    [[nodiscard]] std::string done() {
        for (const auto& [table, lines] : new_tables_) behind_ += "\n[" + table + "]\n" + lines;
        // Of one place the first that was asked for comes first.
        std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
        std::string out;
        std::size_t at = 0;
        for (const Edit& e : edits_) {
            out += text_.substr(at, e.begin - at);
            out += e.text;
            at = e.end;
        }
        out += text_.substr(at);
        if (!behind_.empty() && !out.ends_with('\n')) out += '\n';
        return out + behind_;
    }

private:
    static std::string quoted(const std::string& text) {
        std::string out = "\"";
        for (const char c : text) {
            if (c == '"' || c == '\\') out += '\\';
            out += c;
        }
        return out + "\"";
    }

    [[nodiscard]] const Value* axis_of(const std::string& name) const {
        const Entry* axes = find(root_, "axis");
        if (axes == nullptr) return nullptr;
        for (const Value& v : axes->value.items) {
            const Entry* of = find(v, "name");
            if (of != nullptr && base::equals_ignoring_case(of->value.text, name)) return &v;
        }
        return nullptr;
    }

    /// In the place of the one there, or in a line of its own below the head of the table.
    void set_key(const Value& table, const std::string& key, const std::string& value, const std::string& plain = {}) {
        if (const Entry* e = find(table, plain.empty() ? key : plain)) {
            edits_.push_back({e->value.where.begin, e->value.where.end, value});
            return;
        }
        const std::size_t line_end = text_.find('\n', head(table).end);
        if (line_end == std::string::npos)
            edits_.push_back({text_.size(), text_.size(), "\n" + key + " = " + value});
        else
            edits_.push_back({line_end + 1, line_end + 1, key + " = " + value + "\n"});
    }

    void set_in(const std::string& table, const std::string& key, const std::string& value,
                const std::string& plain = {}) {
        if (const Entry* e = find(root_, table))
            set_key(e->value, key, value, plain);
        else
            new_tables_[table] += key + " = " + value + "\n";
    }

    /// Keys of the file itself stand before the first table.
    void set_root(const std::string& key, const std::string& value) {
        if (const Entry* e = find(root_, key)) {
            edits_.push_back({e->value.where.begin, e->value.where.end, value});
            return;
        }
        const Entry* kind = find(root_, "kind");  // without which it is no machine file
        const std::size_t from = kind != nullptr ? text_.find('\n', kind->value.where.end) : std::string::npos;
        const std::size_t at = from == std::string::npos ? 0 : from + 1;
        edits_.push_back({at, at, key + " = " + value + "\n"});
    }

    const Value& root_;
    std::string_view text_;
    std::vector<Edit> edits_;
    std::map<std::string, std::string> new_tables_;
    std::string behind_;
};

}  // namespace

std::optional<std::string> with_values(std::uint32_t file, const base::Sources& sources,
                                       std::span<const NewValue> values) {
    base::Diagnostics unused;
    const std::optional<Value> root = parse_toml(file, sources, unused);
    if (!root) return {};
    Editor editor(*root, sources[file].text);
    for (const NewValue& v : values) editor.set(v);
    return editor.done();
}

}  // namespace obrys::shop
