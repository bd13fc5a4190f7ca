#include "dialect/heidenhain/cycles.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "dialect/heidenhain/cycle_parameters.hpp"

namespace obrys::dialect::heidenhain {

namespace {

using Kind = cl::CycleKind;
using Use = Cycle::Use;

constexpr bool at_call = true, at_definition = false;
constexpr std::string_view old_form = "form of older controls, whose path is not simulated";
constexpr std::string_view no_cylinder = "machining on a cylinder surface is not simulated";

constexpr Cycle probe(int number, std::string_view name) {
    return {number, Kind::probe, name, at_definition, {}, Use::refused, "not simulated, its results come from the job"};
}

std::span<const Cycle> table() {
    // sizes: table
    using namespace parameters;
    static const Cycle cycles[] = {
        {1, Kind::peck, "PECKING", at_call, c1},
        {2, Kind::tap_floating_simple, "TAPPING", at_call, c2},
        {3, Kind::slot_simple, "SLOT MILLING", at_call, c3, Use::refused, old_form},
        {4, Kind::rectangular_pocket_simple, "POCKET MILLING", at_call, c4},
        {5, Kind::circular_pocket_simple, "CIRCULAR POCKET", at_call, c5},
        {6, Kind::rough_out_simple, "ROUGH-OUT", at_call, c6, Use::refused, old_form},
        {7, Kind::datum_shift, "DATUM SHIFT", at_definition, c7, Use::run, "rotary and secondary axes are refused"},
        {8, Kind::mirror, "MIRROR IMAGE", at_definition, c8},
        {9, Kind::dwell, "DWELL TIME", at_definition, c9},
        {10, Kind::rotation, "ROTATION", at_definition, c10},
        {11, Kind::scaling, "SCALING", at_definition, c11},
        {12, Kind::program_call, "PGM CALL", at_call, {}},
        {13, Kind::orientation, "ORIENTATION", at_definition, c13, Use::run,
         "says the angle to which M19 turns the spindle"},
        {14, Kind::contour_definition, "CONTOUR GEOMETRY", at_definition, c14},
        {15, Kind::pilot_drill_simple, "PILOT DRILLING", at_call, c15, Use::refused, old_form},
        {16, Kind::contour_mill_simple, "CONTOUR MILLING", at_call, c16, Use::refused, old_form},
        {17, Kind::tap_rigid_simple, "RIGID TAPPING", at_call, c17},
        {18, Kind::thread_cut, "THREAD CUTTING", at_call, c18},
        {19, Kind::working_plane, "WORKING PLANE", at_definition, c19, Use::run,
         "spatial angles; Q120 to Q122 follow from the machine's chain"},
        {20, Kind::contour_data, "CONTOUR DATA", at_definition, c20},
        {21, Kind::pilot_drill, "PILOT DRILLING", at_call, c21},
        {22, Kind::rough_out, "ROUGH-OUT", at_call, c22},
        {23, Kind::floor_finish, "FLOOR FINISHING", at_call, c23},
        {24, Kind::side_finish, "SIDE FINISHING", at_call, c24},
        {25, Kind::contour_train, "CONTOUR TRAIN", at_call, c25},
        {26, Kind::axis_scaling, "AXIS-SPEC. SCALING", at_definition, c26},
        {27, Kind::cylinder_surface, "CYLINDER SURFACE", at_call, c27, Use::refused, no_cylinder},
        {28, Kind::cylinder_slot, "CYLINDER SURFACE SLOT", at_call, c28, Use::refused, no_cylinder},
        {29, Kind::cylinder_ridge, "CYL SURFACE RIDGE", at_call, c29, Use::refused, no_cylinder},
        {30, Kind::point_data, "3-D DATA", at_call, {}, Use::refused, "machining of digitised points is not simulated"},
        {32, Kind::tolerance, "TOLERANCE", at_definition, c32, Use::run,
         "lets the control smooth the path within a tolerance"},
        {39, Kind::cylinder_contour, "CYL. SURFACE CONTOUR", at_call, c39, Use::refused, no_cylinder},
        {200, Kind::drill, "DRILLING", at_call, c200},
        {201, Kind::ream, "REAMING", at_call, c201},
        {202, Kind::bore, "BORING", at_call, c202},
        {203, Kind::universal_drill, "UNIVERSAL DRILLING", at_call, c203},
        {204, Kind::back_bore, "BACK BORING", at_call, c204},
        {205, Kind::universal_peck, "UNIVERSAL PECKING", at_call, c205},
        {206, Kind::tap_floating, "TAPPING NEW", at_call, c206},
        {207, Kind::tap_rigid, "RIGID TAPPING NEW", at_call, c207},
        {208, Kind::bore_mill, "BORE MILLING", at_call, c208},
        {209, Kind::tap_chip_breaking, "TAPPING W/ CHIP BRKG", at_call, c209},
        {210, Kind::slot_reciprocating, "SLOT RECIP. PLNG", at_call, c210},
        {211, Kind::round_slot_reciprocating, "CIRCULAR SLOT", at_call, c211},
        {212, Kind::rectangular_pocket_finish, "POCKET FINISHING", at_call, c212},
        {213, Kind::rectangular_stud_finish, "STUD FINISHING", at_call, c212},
        {214, Kind::circular_pocket_finish, "C. POCKET FINISHING", at_call, c214},
        {215, Kind::circular_stud_finish, "C. STUD FINISHING", at_call, c214},
        {220, Kind::pattern_circle, "POLAR PATTERN", at_definition, c220},
        {221, Kind::pattern_lines, "CARTESIAN PATTERN", at_definition, c221},
        {230, Kind::multipass, "MULTIPASS MILLING", at_call, c230},
        {231, Kind::ruled_surface, "RULED SURFACE", at_call, c231},
        {232, Kind::face_mill, "FACE MILLING", at_call, c232},
        {240, Kind::centre, "CENTERING", at_call, c240},
        {241, Kind::single_lip, "SINGLE-LIP D.H.DRLNG", at_call, c241},
        {247, Kind::preset, "DATUM SETTING", at_definition, c247, Use::run,
         "presets come from [datum] or preset_tables of the job"},
        {251, Kind::rectangular_pocket, "RECTANGULAR POCKET", at_call, c251},
        {252, Kind::circular_pocket, "CIRCULAR POCKET", at_call, c252},
        {253, Kind::slot, "SLOT MILLING", at_call, c253},
        {254, Kind::round_slot, "CIRCULAR SLOT", at_call, c254},
        {256, Kind::rectangular_stud, "RECTANGULAR STUD", at_call, c256},
        {257, Kind::circular_stud, "CIRCULAR STUD", at_call, c257},
        {262, Kind::thread_mill, "THREAD MILLING", at_call, c262},
        {263, Kind::thread_mill_countersink, "THREAD MLLNG/CNTSNKG", at_call, c263},
        {264, Kind::thread_mill_drill, "THREAD DRILLNG/MLLNG", at_call, c264},
        {265, Kind::thread_mill_helix, "HEL. THREAD DRLG/MLG", at_call, c265},
        {267, Kind::thread_mill_outside, "OUTSIDE THREAD MLLNG", at_call, c267},
        {270, Kind::contour_train_data, "CONTOUR TRAIN DATA", at_definition, c270},
        probe(400, "BASIC ROTATION"),
        probe(401, "ROT OF 2 HOLES"),
        probe(402, "ROT OF 2 STUDS"),
        probe(403, "ROT IN ROTARY AXIS"),
        probe(404, "SET BASIC ROTATION"),
        probe(405, "ROT IN C AXIS"),
        probe(408, "SLOT CENTER REF PT"),
        probe(409, "RIDGE CENTER REF PT"),
        probe(410, "DATUM INSIDE RECTAN."),
        probe(411, "DATUM OUTS. RECTAN."),
        probe(412, "DATUM INSIDE CIRCLE"),
        probe(413, "DATUM OUTSIDE CIRCLE"),
        probe(414, "DATUM OUTSIDE CORNER"),
        probe(415, "DATUM INSIDE CORNER"),
        probe(416, "DATUM CIRCLE CENTER"),
        probe(417, "DATUM IN TS AXIS"),
        probe(418, "DATUM FROM 4 HOLES"),
        probe(419, "DATUM IN ONE AXIS"),
        probe(420, "MEASURE ANGLE"),
        probe(421, "MEASURE HOLE"),
        probe(422, "MEAS. CIRCLE OUTSIDE"),
        probe(423, "MEAS. RECTAN. INSIDE"),
        probe(424, "MEAS. RECTAN. OUTS."),
        probe(425, "MEASURE INSIDE WIDTH"),
        probe(426, "MEASURE RIDGE WIDTH"),
        probe(427, "MEASURE COORDINATE"),
        probe(430, "MEAS. BOLT HOLE CIRC"),
        probe(431, "MEASURE PLANE"),
        probe(480, "CALIBRATE TT"),
        probe(481, "CAL. TOOL LENGTH"),
        probe(482, "CAL. TOOL RADIUS"),
        probe(483, "MEASURE TOOL"),
    };
    return cycles;
}

/// True where `word` is one of the spellings in `words`, which '|' parts.
bool is_one_of(std::string_view words, std::string_view word) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find('|'), words.size());
        if (words.substr(0, end) == word) return true;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return false;
}

}  // namespace

std::span<const Cycle> all_cycles() { return table(); }

const Cycle* find_cycle(int number) {
    const auto cycles = table();
    const auto found = std::lower_bound(cycles.begin(), cycles.end(), number,
                                        [](const Cycle& c, int wanted) { return c.number < wanted; });
    return found != cycles.end() && found->number == number ? &*found : nullptr;
}

const CycleParameter* find_parameter(const Cycle& cycle, int q) {
    if (q < 0) return nullptr;
    for (const CycleParameter& p : cycle.parameters)
        if (p.q == q) return &p;
    return nullptr;
}

const CycleParameter* find_parameter(const Cycle& cycle, int line, std::string_view word) {
    for (const CycleParameter& p : cycle.parameters)
        if (p.q < 0 && (p.line == line || p.line == 0) && is_one_of(p.word, base::trim(word))) return &p;
    return nullptr;
}

std::uint32_t needed_lines(const Cycle& cycle) {
    const bool named = !cycle.parameters.empty() && cycle.parameters.front().q >= 0;
    if (named || cycle.use == Cycle::Use::refused || cycle.kind == cl::CycleKind::probe) return 0;
    std::uint32_t lines = 0;
    if (cycle.call_active)
        for (const CycleParameter& p : cycle.parameters) lines |= p.line > 0 ? 1U << p.line : 0U;
    return lines == 0 ? 1U << 1 : lines;
}

const CycleParameter* find_parameter_at(const Cycle& cycle, int line, std::size_t n) {
    for (const CycleParameter& p : cycle.parameters)
        if (p.q < 0 && p.line == line && n-- == 0) return &p;
    return nullptr;
}

namespace {

/// iTNC 530 User's Manual Cycle Programming, "Program defaults for cycles".
struct GlobalValues {
    int number;
    std::string_view name;
    std::array<int, 4> parameters;
};
constexpr GlobalValues global_values[] = {
    {100, "GENERAL", {200, 204, 253, 208}},       {105, "DRILLING", {256, 210, 211, -1}},
    {110, "POCKET MILLING", {370, 351, 366, -1}}, {111, "CONTOUR MILLING", {2, 6, 7, 9}},
    {120, "PROBING", {320, 260, 301, -1}},        {125, "POSITIONING", {345, -1, -1, -1}},
};

const GlobalValues* find_global(int number) {
    for (const GlobalValues& g : global_values)
        if (g.number == number) return &g;
    return nullptr;
}

}  // namespace

bool is_global_value(int number, int q) {
    const GlobalValues* g = find_global(number);
    return g != nullptr && std::find(g->parameters.begin(), g->parameters.end(), q) != g->parameters.end();
}

std::string_view global_values_name(int number) {
    const GlobalValues* g = find_global(number);
    return g == nullptr ? std::string_view() : g->name;
}

std::optional<IsoCycle> find_iso_cycle(int g) {
    struct Pair {
        int g, cycle;
        double direction = 0;
    };
    static constexpr Pair pairs[] = {{4, 9},   {28, 8}, {36, 13},     {37, 14},    {39, 12},    {53, 7},    {54, 7},
                                     {56, 15}, {57, 6}, {58, 16, -1}, {59, 16, 1}, {60, 30},    {62, 32},   {72, 11},
                                     {73, 10}, {74, 3}, {75, 4, -1},  {76, 4, 1},  {77, 5, -1}, {78, 5, 1}, {80, 19},
                                     {83, 1},  {84, 2}, {85, 17},     {86, 18}};
    for (const Pair& p : pairs)
        if (p.g == g) return IsoCycle{p.cycle, p.direction};
    const bool contour = (g >= 120 && g <= 125) || (g >= 127 && g <= 129) || g == 139;
    if (contour) return IsoCycle{g - 100, 0};
    if (g >= 200 && find_cycle(g) != nullptr) return IsoCycle{g, 0};
    return std::nullopt;
}

const CycleParameter* find_iso_parameter(const Cycle& cycle, int p) {
    int number = 0, side_line = 0;
    for (const CycleParameter& parameter : cycle.parameters) {
        if (parameter.q >= 0 || parameter.role == cl::CycleRole::direction) continue;
        const bool side = parameter.word == "X" || parameter.word == "Y" || parameter.word == "Z";
        if (side && parameter.line == side_line) continue;
        side_line = side ? parameter.line : 0;
        if (++number == p) return &parameter;
    }
    return nullptr;
}

const CycleParameter* find_iso_parameter(const Cycle& cycle, std::string_view word) {
    using Role = cl::CycleRole;
    struct Letter {
        int cycle;
        std::string_view word;
        Role role;
    };
    static constexpr Letter letters[] = {{9, "F", Role::dwell},
                                         {10, "H", Role::angle},
                                         {11, "F", Role::factor},
                                         {13, "S", Role::spindle_angle},
                                         {19, "F", Role::feed_position},
                                         {19, "S", Role::setup_distance},
                                         {32, "T", Role::tolerance},
                                         {32, "P01", Role::tolerance_mode},
                                         {32, "P02", Role::tolerance_angle}};
    for (const Letter& l : letters)
        if (l.cycle == cycle.number && l.word == word)
            for (const CycleParameter& p : cycle.parameters)
                if (p.role == l.role) return &p;
    const bool by_letter =
        std::any_of(std::begin(letters), std::end(letters), [&](const Letter& l) { return l.cycle == cycle.number; });
    if (by_letter || word.size() != 3 || word[0] != 'P') return nullptr;
    return find_iso_parameter(cycle, (word[1] - '0') * 10 + (word[2] - '0'));
}

}  // namespace obrys::dialect::heidenhain
