// What the lines of a LinuxCNC tool table mean as tools. The nose centre of a lathe tool as seen from the programmed
// point, (X, Z): Q1 (+,-), Q2 (+,+), Q3 (-,+), Q4 (-,-), Q5 (0,-), Q6 (+,0), Q7 (0,+), Q8 (-,0), Q9 none; I and J are
// the directions of the two edges from +Z towards +X (LinuxCNC documentation, "Lathe User Information", figure "Lathe
// Tool Orientations"; the tool shapes of its preview; its sample table lathe.tbl, whose nine tools agree with it).
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "geom/vec.hpp"
#include "shop/files/dropped.hpp"
#include "shop/files/linuxcnc/table.hpp"
#include "shop/orientation.hpp"

namespace obrys::shop {

namespace {

/// How a tool of orientation Q becomes one that cuts from outside and feeds towards -Z.
struct Turned {
    double turn = 0, sign = 1;  ///< degrees: an edge at angle a then lies at turn + sign * a
};
constexpr std::array<Turned, 10> turned_tools{
    {{0, 1}, {180, -1}, {0, 1}, {0, -1}, {180, 1}, {-90, 1}, {0, 1}, {90, -1}, {0, -1}, {0, 1}}};

double within_turn(double degrees) {
    const double d = std::fmod(degrees, 360);
    return d < 0 ? d + 360 : d;
}

/// Tip and entering angle from the directions of both edges; false where they make no insert.
bool take_angles(Tool& t, const TableTool& row) {
    const Turned& way = turned_tools[static_cast<std::size_t>(row.orientation)];
    const double a = within_turn(way.turn + way.sign * row.front_angle),
                 b = within_turn(way.turn + way.sign * row.back_angle);
    const double main = std::max(a, b), tip = main - std::min(a, b);
    if (!(tip > 0 && tip < 180 && main > 0 && main < 180)) return false;
    t.tip_angle = tip;
    t.entering_angle = 180 - main;
    return true;
}

/// Whole words of a comment, in capitals.
std::vector<std::string> words_of(const std::string& comment) {
    std::vector<std::string> out(1);
    for (const char c : base::to_upper(comment)) {
        if (base::is_letter(c))
            out.back() += c;
        else if (!out.back().empty())
            out.emplace_back();
    }
    return out;
}

/// What a comment plainly calls a tool; `other` where it says nothing of the kind, or several things.
ToolKind kind_of(const std::string& comment) {
    const std::vector<std::string> words = words_of(comment);
    const auto has = [&](std::initializer_list<std::string_view> any) {
        return std::any_of(words.begin(), words.end(),
                           [&](const std::string& w) { return std::find(any.begin(), any.end(), w) != any.end(); });
    };
    const bool mill = has({"ENDMILL", "EM"}) || (has({"MILL"}) && has({"END", "FLAT", "BALL"}));
    const bool spot = has({"SPOTDRILL", "CENTERDRILL"}) || (has({"DRILL"}) && has({"SPOT", "CENTER", "CENTRE"}));
    std::vector<ToolKind> found;
    if (has({"BALL", "BALLNOSE"}) && (mill || has({"NOSE", "END", "BALLNOSE"})))
        found.push_back(ToolKind::ball);
    else if (mill)
        found.push_back(ToolKind::end_mill);
    if (spot)
        found.push_back(ToolKind::centre_drill);
    else if (has({"DRILL"}))
        found.push_back(ToolKind::drill);
    if (has({"TAP"})) found.push_back(ToolKind::tap);
    if (has({"REAMER"})) found.push_back(ToolKind::reamer);
    if (has({"COUNTERSINK"})) found.push_back(ToolKind::countersink);
    if (has({"CHAMFER"})) found.push_back(ToolKind::chamfer);
    return found.size() == 1 ? found.front() : ToolKind::other;
}

/// A tool that turns about its axis: kind by the comment, radius by D.
void mill_shape(Tool& t, const TableTool& row) {
    t.radius = row.diameter / 2;
    if (t.radius > 0) t.kind = kind_of(t.name);
    if (t.kind == ToolKind::ball) t.corner_radius = t.radius;
    const bool right_angle =
        t.kind == ToolKind::centre_drill || t.kind == ToolKind::countersink || t.kind == ToolKind::chamfer;
    if (!right_angle && t.kind != ToolKind::drill) return;
    t.point_angle = right_angle ? 90 : 118;
    assume(t.assumed, "point angle " + base::shortest(*t.point_angle) + " degrees");
}

void shape(Tool& t, const TableTool& row) {
    t.length = row.offset[2];
    if (row.orientation == 0) return mill_shape(t, row);
    t.kind = ToolKind::turning;
    t.nose_radius = std::abs(row.diameter) / 2;
    t.orientation = mirrored_orientation(row.orientation);
    if (!take_angles(t, row)) {
        if (t.orientation >= 5) t.entering_angle = 90 - t.tip_angle / 2;
        t.assumed = "tip angle " + base::shortest(t.tip_angle) + " degrees, entering angle " +
                    base::shortest(t.entering_angle) + " degrees, ";
    }
    t.assumed += "edge length " + base::shortest(t.edge_length) + " mm";
}

TableTool row_of(const LinuxcncLine& line, double mm_per_unit) {
    TableTool row;
    row.pocket = base::clipped<std::int32_t>(value_of(line, 'P').value_or(0), 0, 2'147'483'647);
    constexpr std::string_view axes = "XYZABCUVW";
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const bool rotary = i >= 3 && i < 6;
        row.offset[i] = value_of(line, axes[i]).value_or(0) * (rotary ? 1 : mm_per_unit);
    }
    row.diameter = value_of(line, 'D').value_or(0) * mm_per_unit;
    row.front_angle = value_of(line, 'I').value_or(0);
    row.back_angle = value_of(line, 'J').value_or(0);
    return row;
}

/// Q, 0 where it is none of the table's orientations.
int orientation_of(const LinuxcncLine& line, std::uint32_t file, base::Diagnostics& diagnostics) {
    const double q = value_of(line, 'Q').value_or(0);
    if (const auto n = base::whole<int>(q, 0, 9)) return *n;
    base::Diagnostic d;
    d.code = base::codes::job_value;
    d.text = "the orientation Q of a lathe tool is 1 to 9, or 0 for none";
    for (const LinuxcncField& f : line.fields)
        if (f.letter == 'Q' && line.at != LinuxcncLine::no_place)
            d.where = {file, line.at + f.begin - 1, line.at + f.end};
    if (line.at == LinuxcncLine::no_place) d.where = {file, 0, 0};
    diagnostics.add(std::move(d));
    return 0;
}

}  // namespace

std::vector<Tool> tools_of(const LinuxcncTable& table, double mm_per_unit, base::Diagnostics& diagnostics) {
    std::vector<Tool> out;
    std::set<double> seen;
    std::uint32_t index = 0;  // the control counts every P, also of lines that it then passes over
    for (const LinuxcncLine& line : table.lines) {
        for (const LinuxcncField& f : line.fields)
            if (f.letter == 'P') ++index;
        const double number = value_of(line, 'T').value_or(0);
        if (line.form == LinuxcncLine::Form::none || number <= 0 || !seen.insert(number).second) continue;
        TableTool row = row_of(line, mm_per_unit);
        row.index = index;
        row.orientation = orientation_of(line, table.file, diagnostics);
        Tool& t = out.emplace_back();
        t.number = base::clipped<std::uint32_t>(number, 1, 2'147'483'647);
        t.name = comment_of(line);
        if (line.at == LinuxcncLine::no_place)
            t.where = {table.file, 0, 0};
        else
            t.where = {table.file, line.at, line.at + static_cast<std::uint32_t>(line.text.size())};
        shape(t, row);
        t.table = row;
    }
    return out;
}

std::vector<Tool> read_tbl(std::uint32_t file, const base::Sources& sources, double mm_per_unit,
                           base::Diagnostics& diagnostics) {
    return tools_of(read_linuxcnc_table(file, sources, diagnostics), mm_per_unit, diagnostics);
}

}  // namespace obrys::shop
