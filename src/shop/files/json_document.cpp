#include "shop/files/json_document.hpp"

#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "base/codes.hpp"

namespace obrys::shop {

namespace {

constexpr std::size_t deepest = 64, most_values = 2'000'000;

/// Gives the library the bytes of a text and remembers how many it has taken: so each value is known to lie before
/// there.
struct Counted {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at = nullptr;
    const char** farthest = nullptr;

    reference operator*() const { return *at; }
    Counted& operator++() {
        *farthest = ++at;
        return *this;
    }
    Counted operator++(int) {
        const Counted before = *this;
        ++*this;
        return before;
    }
    bool operator==(const Counted& o) const { return at == o.at; }
};

/// Builds the values from the library's events. The names of its functions are the library's.
class Builder {
public:
    Builder(std::uint32_t file, std::string_view text, const char** farthest)
        : file_(file), text_(text), farthest_(farthest) {}

    bool null() { return step(), true; }
    bool boolean(bool v) {
        Value out = begin(ValueKind::boolean);
        out.boolean = v;
        return add(std::move(out));
    }
    bool number_integer(std::int64_t v) { return integer(v); }
    bool number_unsigned(std::uint64_t v) {
        return v > INT64_MAX ? number_float(static_cast<double>(v), {}) : integer(static_cast<std::int64_t>(v));
    }
    bool number_float(double v, const std::string&) {
        Value out = begin(ValueKind::number);
        out.number = v;
        return add(std::move(out));
    }
    bool string(std::string& v) {
        Value out = begin(ValueKind::text);
        out.text = v;
        return add(std::move(out));
    }
    bool binary(nlohmann::json::binary_t&) { return true; }
    bool key(std::string& v) {
        keys_.push_back({v, step(), {}});
        return true;
    }
    bool start_object(std::size_t) { return open(ValueKind::table); }
    bool start_array(std::size_t) { return open(ValueKind::array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool parse_error(std::size_t at, const std::string&, const nlohmann::json::exception& e) {
        const std::string text = e.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: …"
        const std::size_t cut = text.find(": ");
        problem = "this is not valid JSON: " + (cut == std::string::npos ? text : text.substr(cut + 2));
        const std::size_t byte = std::min(at == 0 ? 0 : at - 1, text_.size());
        where = {file_, static_cast<std::uint32_t>(byte), static_cast<std::uint32_t>(std::min(byte + 1, text_.size()))};
        return false;
    }

    std::optional<Value> root;
    std::string problem;
    base::Span where;

private:
    /// The place of the token that the library has just read: from behind the last one.
    base::Span step() {
        const auto taken = static_cast<std::size_t>(*farthest_ - text_.data());
        std::size_t first = last_;
        while (first < taken && std::string_view(" \t\r\n,:").find(text_[first]) != std::string_view::npos) ++first;
        std::size_t end = taken;
        // behind a number the library looks one byte ahead
        while (end > first + 1 && text_[first] != '"' &&
               std::string_view(" \t\r\n,:]}").find(text_[end - 1]) != std::string_view::npos)
            --end;
        last_ = end;
        return {file_, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)};
    }
    Value begin(ValueKind kind) {
        Value out;
        out.kind = kind;
        out.where = step();
        return out;
    }
    bool integer(std::int64_t v) {
        Value out = begin(ValueKind::integer);
        out.integer = v;
        out.number = static_cast<double>(v);
        return add(std::move(out));
    }
    bool fail(const base::Span& at, std::string text) {
        problem = std::move(text);
        where = at;
        return false;
    }
    bool open(ValueKind kind) {
        Value out = begin(kind);
        out.where.end = out.where.begin + 1;
        last_ = out.where.end;
        if (open_.size() >= deepest)
            return fail(out.where, "this JSON is nested too deep: at most " + std::to_string(deepest) + " levels");
        marks_.push_back(keys_.size());
        open_.push_back(std::move(out));
        return true;
    }
    bool close() {
        Value out = std::move(open_.back());
        open_.pop_back();
        out.where.end = step().end;
        keys_.resize(marks_.back());  // a key whose value was null is still there
        marks_.pop_back();
        return add(std::move(out));
    }
    bool add(Value v) {
        if (++count_ > most_values)
            return fail(v.where, "this JSON has more than " + std::to_string(most_values) + " values");
        if (open_.empty()) {
            root = std::move(v);
        } else if (open_.back().kind == ValueKind::array) {
            open_.back().items.push_back(std::move(v));
        } else {
            keys_.back().value = std::move(v);
            open_.back().entries.push_back(std::move(keys_.back()));
            keys_.pop_back();
        }
        return true;
    }

    std::uint32_t file_;
    std::string_view text_;
    const char** farthest_;
    std::size_t last_ = 0, count_ = 0;
    std::vector<Value> open_;
    std::vector<Entry> keys_;         ///< of the objects that are open, their value not yet there
    std::vector<std::size_t> marks_;  ///< how many keys there were when each open value began
};

}  // namespace

std::optional<Value> parse_json(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    const std::string_view text = sources[file].text;
    const char* farthest = text.data();
    Builder builder(file, text, &farthest);
    const Counted first{text.data(), &farthest}, end{text.data() + text.size(), &farthest};
    if (nlohmann::json::sax_parse(first, end, &builder) && builder.root) return std::move(builder.root);
    base::Diagnostic d;
    d.code = base::codes::job_file;
    d.where = builder.where;
    d.where.file = file;
    d.text = builder.problem.empty() ? "this is not valid JSON" : builder.problem;
    diagnostics.add(std::move(d));
    return std::nullopt;
}

}  // namespace obrys::shop
