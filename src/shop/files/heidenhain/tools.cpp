// Columns: iTNC 530 User's Manual Conversational Programming (606 42x), "Entering tool data in the table"; names of
// newer controls (CUT for CUT., CUR_TIME) beside them. Names and numbers of TYP: TNC 640 User's Manual, "Available tool
// types"; the iTNC 530 has the same names.
#include <algorithm>
#include <array>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "shop/files/dropped.hpp"
#include "shop/files/heidenhain/cells.hpp"
#include "shop/files/heidenhain/views.hpp"
#include "shop/files/section.hpp"

namespace obrys::shop {

namespace {

constexpr std::uint32_t largest_t = 32'767, largest_index = 9;  // T 0 … 32767.9
constexpr std::uint32_t largest_pocket = 9'999;

/// Columns that a tool is made of.
constexpr std::array<std::string_view, 20> columns_taken{"T",    "NAME", "L",    "R",     "R2",    "DL",    "DR",
                                                         "DR2",  "TL",   "RT",   "LCUTS", "ANGLE", "PITCH", "T-ANGLE",
                                                         "CUT.", "CUT",  "NMAX", "TYP",   "TMAT",  "CDT"};

/// What a TYP stands for. Thread mills, turning tools, probes and back boring tools are not here: `other`.
struct TypRow {
    std::string_view name;
    int number;
    ToolKind kind;
};
constexpr std::array typ_rows{TypRow{"MILL", 0, ToolKind::end_mill},
                              TypRow{"DRILL", 1, ToolKind::drill},
                              TypRow{"TAP", 2, ToolKind::tap},
                              TypRow{"REAM", 3, ToolKind::reamer},
                              TypRow{"CENT", 4, ToolKind::centre_drill},
                              TypRow{"CSINK", 5, ToolKind::countersink},
                              TypRow{"TSINK", 6, ToolKind::end_mill},
                              TypRow{"BOR", 7, ToolKind::reamer},
                              TypRow{"MILL_R", 9, ToolKind::end_mill},
                              TypRow{"MILL_F", 10, ToolKind::end_mill},
                              TypRow{"MILL_RF", 11, ToolKind::end_mill},
                              TypRow{"MILL_FD", 12, ToolKind::end_mill},
                              TypRow{"MILL_FS", 13, ToolKind::end_mill},
                              TypRow{"MILL_FACE", 14, ToolKind::end_mill},
                              TypRow{"BALL", -1, ToolKind::ball},
                              TypRow{"TORUS", -1, ToolKind::bull_nose},
                              TypRow{"MILL_CHAMFER", -1, ToolKind::chamfer}};

ToolKind kind_of(std::string_view type) {
    const auto number = base::parse_integer(type);
    for (const TypRow& t : typ_rows)
        if (number ? t.number == *number : base::equals_ignoring_case(t.name, type)) return t.kind;
    return ToolKind::other;
}

/// The kind, and what it needs and the row does not say. A mill is end mill, bull nose or ball by its R2.
void take_kind(Tool& tool) {
    tool.kind = kind_of(tool.type);
    if (!(tool.radius > 0)) tool.kind = ToolKind::other;
    const bool mill =
        tool.kind == ToolKind::end_mill || tool.kind == ToolKind::ball || tool.kind == ToolKind::bull_nose;
    if (tool.kind == ToolKind::ball) tool.corner_radius = tool.radius;
    if (mill) {
        tool.kind = ToolKind::other;
        tool.kind = assumed_kind(tool);
    }
    if (tool.cutting_length && !(*tool.cutting_length > 0)) tool.cutting_length.reset();  // 0: nothing was entered
    if (tool.point_angle && !(*tool.point_angle > 0)) tool.point_angle.reset();
    const bool flat_angle =
        tool.kind == ToolKind::centre_drill || tool.kind == ToolKind::countersink || tool.kind == ToolKind::chamfer;
    if (tool.point_angle || (tool.kind != ToolKind::drill && !flat_angle)) return;
    tool.point_angle = flat_angle ? 90 : 118;
    assume(tool.assumed, "point angle " + base::shortest(*tool.point_angle) + " degrees");
}

void dimensions(Cells& row, Tool& tool) {
    const auto needed = [&](std::string_view column, std::string_view what) {
        const auto v = column == "R" ? row.radius(column) : row.length(column);
        if (!v && !row.filled(column)) assume(tool.assumed, std::string(what) + " 0 mm");
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
    if (const auto rt = row.integer("RT", 0, largest_t)) tool.replacement = static_cast<std::uint32_t>(*rt);
    tool.cutter_material = row.text("TMAT");
    tool.cutting_data = row.text("CDT");
}

/// Counts the filled cells of columns that nobody takes.
Dropped dropped_columns(const HeidenhainTable& table) {
    Dropped dropped;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        const std::string& name = table.columns[column].name;
        const auto same = [&](std::string_view t) { return base::equals_ignoring_case(t, name); };
        if (std::any_of(columns_taken.begin(), columns_taken.end(), same)) continue;
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            if (table.rows[row].data && !cell(table, row, column).empty())
                dropped.add(base::as_utf8(name), cell_span(table, row, column));
    }
    return dropped;
}

}  // namespace

std::vector<Tool> tools_of(const HeidenhainTable& table, base::Diagnostics& diagnostics) {
    std::vector<Tool> tools;
    Cells row(table, diagnostics);
    if (!row.need({"T", "L", "R"})) return tools;
    while (row.next()) {
        const auto number = row.number(largest_t, largest_index);
        if (!number) continue;
        Tool tool;
        tool.number = number->whole;
        tool.index = number->part;
        tool.edge = tool.index + 1;
        tool.where = row.where();
        properties(row, tool);
        dimensions(row, tool);
        take_kind(tool);
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
    const HeidenhainTable table = read_heidenhain_table(file, sources, found);
    std::vector<Tool> tools = tools_of(table, found);
    dropped_columns(table).report(found);
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
        if (const auto t = row.integer("T", 0, largest_t)) p.tool = static_cast<std::uint32_t>(*t);
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
