#include "write/post_staircase.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/codes.hpp"

namespace obrys::write {

namespace {

/// Tables with whose words moves along one axis of the workpiece would be others again, or none.
bool moves_otherwise(const CommandName& c) {
    constexpr std::array<std::string_view, 3> tables{"compensation", "corner", "lead"};
    if (std::find(tables.begin(), tables.end(), c.table) != tables.end()) return true;
    if (c.table == "frame")
        return !c.key.starts_with("shift") && !c.key.starts_with("mirror") && !c.key.starts_with("scaling");
    return c.table == "motion" &&
           (c.key.starts_with("arc") || c.key.starts_with("helix") || c.key.starts_with("spline"));
}

}  // namespace

void read_staircase(shop::Section& file, Post& post) {
    const shop::Entry* table = file.sub_table("staircase");
    if (table == nullptr) return;
    shop::Section s(table->value, "[staircase]", file.diagnostics());
    StaircaseForm form;
    const auto roughness = s.number("roughness", shop::Range::positive);
    if (!roughness && shop::find(table->value, "roughness") == nullptr)
        file.error(base::codes::job_value, table->value.where, "'roughness' must be said: the highest ridge, mm");
    form.roughness = roughness.value_or(1);
    form.deviation = s.number("deviation", shop::Range::positive).value_or(form.roughness);
    form.tool_diameter = s.number("tool_diameter", shop::Range::positive).value_or(0);
    form.away = s.number("away", shop::Range::positive).value_or(0);
    const NumberStyle& word = post.styles.front();  // of lengths
    form.units = std::abs(word.factor) * std::pow(10.0, word.decimals);
    if (const auto part = s.choice("part", {"not-known", "left", "right"}))
        form.part = static_cast<StaircaseForm::Part>(*part);
    if (form.part != StaircaseForm::Part::not_known && form.tool_diameter == 0)
        file.error(base::codes::job_value, table->value.where,
                   "'part' needs 'tool_diameter': how wide the tool is that follows it");
    s.finish();
    for (const CommandName& c : command_names())
        if (moves_otherwise(c) && post.has(c.command))
            file.error(base::codes::job_value, table->value.where,
                       "a post with [staircase] cannot have " + std::string(c.name) +
                           ": its control moves along one axis at a time");
    post.staircase = form;
}

}  // namespace obrys::write
