#include "write/post_magazine.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "base/codes.hpp"

namespace obrys::write {

namespace {

constexpr std::int64_t most_places = 1000, most_offset = 100'000, most_number = 100'000'000;

std::optional<std::uint32_t> count_of_key(shop::Section& s, std::string_view key, std::int64_t least,
                                          std::int64_t most) {
    const auto n = s.integer(key, least, most);
    return n ? std::optional(static_cast<std::uint32_t>(*n)) : std::nullopt;
}

/// One, two or four.
std::optional<std::uint32_t> offsets_of(shop::Section& s) {
    const auto n = count_of_key(s, "offsets", 1, 4);
    if (n && *n == 3) s.error(base::codes::job_value, place(s, "offsets"), "a tool has one, two or four offsets");
    return n;
}

void read_tool(const shop::Value& table, MagazineForm& form, shop::Section& of) {
    shop::Section s(table, "[[magazine.tool]]", of.diagnostics());
    MagazineTool tool;
    tool.number = count_of_key(s, "number", 1, most_number).value_or(0);
    if (tool.number == 0) s.error(base::codes::job_value, table.where, "'number' must be said: of which tool");
    tool.place = count_of_key(s, "place", 1, form.places).value_or(0);
    tool.offsets = offsets_of(s).value_or(0);
    const auto same_place = [&](const MagazineTool& t) { return tool.place != 0 && t.place == tool.place; };
    if (std::any_of(form.tools.begin(), form.tools.end(), same_place))
        s.error(base::codes::job_value, table.where, "another tool stands at place " + std::to_string(tool.place));
    s.finish();
    form.tools.push_back(tool);
}

/// A whole number and nothing else.
std::optional<std::int64_t> whole_number(std::string_view text) {
    std::int64_t n = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (fault != std::errc{} || end != text.data() + text.size() || n < 0) return std::nullopt;
    return n;
}

/// A letter and a number, or two with a hyphen between them.
std::optional<FunctionNumbers> numbers_of(std::string_view text) {
    if (text.empty() || text.front() < 'A' || text.front() > 'Z') return std::nullopt;
    const std::string_view numbers = text.substr(1);
    const std::size_t hyphen = numbers.find('-');
    const auto first = whole_number(numbers.substr(0, hyphen));
    const auto last = hyphen == std::string_view::npos ? first : whole_number(numbers.substr(hyphen + 1));
    if (!first || !last || *last < *first) return std::nullopt;
    return FunctionNumbers{text.front(), *first, *last};
}

std::vector<FunctionNumbers> list_of(shop::Section& s, std::string_view key) {
    std::vector<FunctionNumbers> out;
    for (const shop::Value* value : s.text_values(key)) {
        if (const auto numbers = numbers_of(value->text))
            out.push_back(*numbers);
        else
            s.error(base::codes::job_value, value->where, "'" + value->text + "' is no function of a machine",
                    "M29, or M89-150");
    }
    return out;
}

}  // namespace

void read_functions(shop::Section& table, Post& post) {
    post.function_letters = table.text("letters").value_or("");
    post.functions_refused = list_of(table, "refused");
    post.functions_with_speed = list_of(table, "with_speed");
}

void read_magazine(shop::Section& file, Post& post) {
    const shop::Entry* table = file.sub_table("magazine");
    if (table == nullptr) return;
    shop::Section s(table->value, "[magazine]", file.diagnostics());
    MagazineForm form;
    form.places = count_of_key(s, "places", 1, most_places).value_or(0);
    if (shop::find(table->value, "places") == nullptr)
        file.error(base::codes::job_value, table->value.where, "'places' must be said: how many the magazine has");
    form.balanced = s.boolean("balanced").value_or(form.balanced);
    form.offsets = offsets_of(s).value_or(form.offsets);
    form.first_offset = count_of_key(s, "first_offset", 1, most_offset).value_or(form.first_offset);
    form.last_offset = count_of_key(s, "last_offset", form.first_offset, most_offset)
                           .value_or(std::max(form.last_offset, form.first_offset));
    for (const shop::Value* tool : s.tables("tool")) read_tool(*tool, form, s);
    s.finish();
    post.magazine = std::move(form);
}

}  // namespace obrys::write
