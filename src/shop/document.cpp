#include "shop/document.hpp"

#include <toml++/toml.h>

#include <algorithm>

#include "base/codes.hpp"
#include "base/text.hpp"

namespace obrys::shop {

namespace {

/// Turns the library's lines and columns (characters) into bytes of the source text.
class Places {
public:
    Places(std::uint32_t file, const base::Sources& sources) : file_(file), source_(sources[file]) {
        starts_.push_back(0);
        for (std::size_t i = 0; i < source_.text.size(); ++i)
            if (source_.text[i] == '\n') starts_.push_back(i + 1);
    }

    [[nodiscard]] base::Span span(const toml::source_region& region) const {
        const std::uint32_t begin = offset(region.begin);
        return {file_, begin, std::max(offset(region.end), begin)};
    }

private:
    [[nodiscard]] std::uint32_t offset(const toml::source_position& p) const {
        if (p.line == 0 || p.line > starts_.size()) return static_cast<std::uint32_t>(source_.text.size());
        std::size_t at = starts_[p.line - 1];
        for (std::size_t column = 1; column < p.column && at < source_.text.size(); ++column) {
            ++at;
            while (source_.utf8 && at < source_.text.size() && (static_cast<unsigned char>(source_.text[at]) & 0xC0) == 0x80) ++at;
        }
        return static_cast<std::uint32_t>(at);
    }

    std::uint32_t file_;
    const base::Source& source_;
    std::vector<std::size_t> starts_;
};

Value convert(const toml::node& node, const Places& places);

void convert_table(const toml::table& table, const Places& places, Value& out) {
    out.kind = ValueKind::table;
    for (const auto& [key, node] : table)
        out.entries.push_back({std::string(key.str()), places.span(key.source()), convert(node, places)});
    std::sort(out.entries.begin(), out.entries.end(),
              [](const Entry& a, const Entry& b) { return a.where.begin < b.where.begin; });
}

Value convert(const toml::node& node, const Places& places) {
    Value out;
    out.where = places.span(node.source());
    if (const auto* table = node.as_table()) {
        convert_table(*table, places, out);
    } else if (const auto* array = node.as_array()) {
        out.kind = ValueKind::array;
        for (const toml::node& item : *array) out.items.push_back(convert(item, places));
    } else if (const auto* text = node.as_string()) {
        out.kind = ValueKind::text;
        out.text = text->get();
    } else if (const auto* integer = node.as_integer()) {
        out.kind = ValueKind::integer;
        out.integer = integer->get();
        out.number = static_cast<double>(out.integer);
    } else if (const auto* number = node.as_floating_point()) {
        out.kind = ValueKind::number;
        out.number = number->get();
    } else if (const auto* boolean = node.as_boolean()) {
        out.kind = ValueKind::boolean;
        out.boolean = boolean->get();
    } else {
        out.kind = ValueKind::date;
    }
    return out;
}

}  // namespace

const Entry* find(const Value& table, std::string_view key) {
    for (const Entry& e : table.entries)
        if (e.key == key) return &e;
    return nullptr;
}

std::optional<Value> parse_toml(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    const Places places(file, sources);
    try {
        const std::string text = base::as_utf8(sources[file].text);
        const toml::table table = toml::parse(std::string_view(text));
        Value out;
        out.where = {file, 0, 0};
        convert_table(table, places, out);
        return out;
    } catch (const toml::parse_error& error) {
        base::Diagnostic d;
        d.code = base::codes::job_file;
        d.where = places.span(error.source());
        d.text = "this is not valid TOML: " + std::string(error.description());
        diagnostics.add(std::move(d));
        return std::nullopt;
    }
}

}  // namespace obrys::shop
