#include "shop/files/document.hpp"

#include <toml++/toml.h>

#include <algorithm>

#include "base/codes.hpp"
#include "base/slip.hpp"
#include "base/text.hpp"

namespace obrys::shop {

namespace {

/// Turns the library's lines and columns (characters) into bytes of the source text. The places of every 64th character
/// are kept, so that a place far into a long line costs no more than one at its start.
class Places {
public:
    Places(std::uint32_t file, const base::Sources& sources) : file_(file), source_(sources[file]) {
        lines_.push_back(0);
        std::size_t characters = 0;
        for (std::size_t at = 0; at < source_.text.size(); at = after(at), ++characters) {
            if (characters % apart == 0) marks_.push_back(at);
            if (source_.text[at] == '\n') lines_.push_back(characters + 1);
        }
    }

    [[nodiscard]] base::Span span(const toml::source_region& region) const {
        const std::uint32_t begin = offset(region.begin);
        return {file_, begin, std::max(offset(region.end), begin)};
    }

private:
    static constexpr std::size_t apart = 64;

    /// Where the character at a byte ends.
    [[nodiscard]] std::size_t after(std::size_t at) const {
        const std::string_view text = source_.text;
        ++at;
        while (source_.utf8 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
        return at;
    }
    [[nodiscard]] std::uint32_t offset(const toml::source_position& p) const {
        const std::size_t end = source_.text.size();
        if (p.line == 0 || p.line > lines_.size()) return static_cast<std::uint32_t>(end);
        const std::size_t character = lines_[p.line - 1] + std::max<std::size_t>(p.column, 1) - 1;
        if (character / apart >= marks_.size()) return static_cast<std::uint32_t>(end);
        std::size_t at = marks_[character / apart];
        for (std::size_t n = character % apart; n > 0 && at < end; --n) at = after(at);
        return static_cast<std::uint32_t>(at);
    }

    std::uint32_t file_;
    const base::Source& source_;
    std::vector<std::size_t> lines_;  ///< number of the first character of each line, counted in the whole text
    std::vector<std::size_t> marks_;  ///< byte of every `apart`-th character
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
        // Error places lie on the character that cannot be read, or just behind it.
        const std::string_view bytes = sources[file].text;
        d.remedy = base::slip_in_number(bytes, d.where.begin);
        if (d.remedy.empty() && d.where.begin > 0) d.remedy = base::slip_in_number(bytes, d.where.begin - 1);
        diagnostics.add(std::move(d));
        return std::nullopt;
    }
}

}  // namespace obrys::shop
