// Columns: iTNC 530 User's Manual Conversational Programming (606 42x), "Entering tool data in the table"; names of
// newer controls (CUT for CUT., CUR_TIME) beside them.
#include <algorithm>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "shop/heidenhain_cells.hpp"
#include "shop/heidenhain_views.hpp"
#include "shop/section.hpp"

namespace obrys::shop {

namespace {

constexpr std::uint32_t largest_tool = 32'767, largest_index = 9;  // T 0 … 32767.9
constexpr std::uint32_t largest_pocket = 9'999;

void dimensions(Cells& row, Tool& tool) {
    const auto needed = [&](std::string_view column, std::string_view what) {
        const auto v = row.length(column);
        if (!v && !row.filled(column))
            tool.assumed += std::string(tool.assumed.empty() ? "" : ", ") + std::string(what) + " 0 mm";
        return v.value_or(0);
    };
    tool.length = needed("L", "length");
    tool.radius = needed("R", "radius");
    tool.corner_radius = row.length("R2").value_or(0);
    tool.delta_length = row.length("DL").value_or(0);
    tool.delta_radius = row.length("DR").value_or(0);
    tool.delta_corner_radius = row.length("DR2").value_or(0);
    tool.cutting_length = row.length("LCUTS");
    tool.pitch = row.length("PITCH");
    tool.plunge_angle = row.real("ANGLE");
    tool.point_angle = row.real("T-ANGLE");
}

void properties(Cells& row, Tool& tool) {
    tool.name = row.text("NAME");
    tool.type = row.text("TYP");
    tool.teeth = static_cast<int>(row.integer(row.has("CUT.") ? "CUT." : "CUT", 0, 99).value_or(0));
    tool.max_speed = row.real("NMAX");
    tool.locked = row.marked("TL");
    if (const auto rt = row.integer("RT", 0, largest_tool)) tool.replacement = static_cast<std::uint32_t>(*rt);
    tool.cutter_material = row.text("TMAT");
    tool.cutting_data = row.text("CDT");
}

}  // namespace

std::vector<Tool> tools_of(const HeidenhainTable& table, base::Diagnostics& diagnostics) {
    std::vector<Tool> tools;
    Cells row(table, diagnostics);
    if (!row.need({"T", "L", "R"})) return tools;
    while (row.next()) {
        const auto number = row.number(largest_tool, largest_index);
        if (!number) continue;
        Tool tool;
        tool.number = number->whole;
        tool.index = number->part;
        tool.edge = tool.index + 1;
        tool.where = row.where();
        properties(row, tool);
        dimensions(row, tool);
        if (!tool.assumed.empty()) tool.assumed = "tool " + std::to_string(tool.number) + ": " + tool.assumed;
        tools.push_back(std::move(tool));
    }
    std::stable_sort(tools.begin(), tools.end(), [](const Tool& a, const Tool& b) {
        return std::pair(a.number, a.edge) < std::pair(b.number, b.edge);
    });
    return tools;
}

std::vector<Tool> read_tool_t(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    base::Diagnostics found;
    std::vector<Tool> tools = tools_of(read_heidenhain_table(file, sources, found), found);
    add_in_order(found, diagnostics);
    return tools;
}

std::vector<Pocket> pockets_of(const HeidenhainTable& table, base::Diagnostics& diagnostics) {
    std::vector<Pocket> pockets;
    Cells row(table, diagnostics);
    if (!row.need({"P", "T"})) return pockets;
    while (row.next()) {
        const auto number = row.number(largest_pocket, largest_pocket);
        if (!number) continue;
        Pocket p;
        const bool has_magazine = row.text("P").find('.') != std::string::npos;
        p.magazine = has_magazine ? number->whole : 0;
        p.pocket = has_magazine ? number->part : number->whole;
        if (const auto t = row.integer("T", 0, largest_tool)) p.tool = static_cast<std::uint32_t>(*t);
        p.tool_name = row.text("TNAME");
        p.special = row.marked("ST");
        p.fixed = row.marked("F");
        p.locked = row.marked("L");
        p.where = row.where();
        pockets.push_back(std::move(p));
    }
    return pockets;
}

}  // namespace obrys::shop
