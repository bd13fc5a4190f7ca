/// Datums by number: presets, rows of a datum table, and a datum that the program sets itself.
/// Source: iTNC 530 User's Manual Cycle Programming, "Datum shift with datum tables (cycle 7)", "Datum setting (cycle
/// 247)"; User's Manual Conversational Programming, "FN 25: PRESET".

#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr double highest_preset = 99'999;

bool is_row(double n, double most) { return n >= 0 && n <= most && n == std::floor(n); }

const DatumTable* datum_table(Reckoning& run, const program::CycleDefinition& c) {
    const DatumTable* table = run.env.files == nullptr ? nullptr : run.env.files->datum_table(run.datum_table);
    if (table == nullptr)
        unchecked(run, codes::unknown_value, c.where,
                  c.name + ": the datum table " + run.datum_table + (run.datum_table.empty() ? "" : " ") +
                      "is not at hand: the shift is not known, the one before is kept",
                  "put the table (.D) beside the program, or name it in datum_tables of the job");
    return table;
}

}  // namespace

void shift_by_table(Telling& run, const program::CycleDefinition& c, double n) {
    const DatumTable* table = datum_table(run, c);
    if (table == nullptr) return;
    const auto row =
        is_row(n, 1e9) ? table->rows.find(base::clipped<std::uint32_t>(n, 0, 1'000'000'000)) : table->rows.end();
    if (row == table->rows.end()) {
        alarm(run, codes::value_range, c.where,
              c.name + ": the datum table " + table->name + " has no row " + printed(Value::real(n)));
        return;
    }
    const shop::DatumRow& datum = row->second;
    geom::Vec3 by;
    for (int k = 0; k < 3; ++k) {
        coordinate(by, k) = coordinate(datum.position, k);
        if (!std::isnan(coordinate(by, k))) continue;
        coordinate(by, k) = 0;
        assume(run, c.where,
               "row " + printed(Value::real(n)) + " of the datum table " + table->name + " has no value for " +
                   std::string(1, "XYZ"[k]) + ": taken as 0");
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (const double a = datum.rotary[k], u = datum.secondary[k]; (a == a && a != 0) || (u == u && u != 0))
            unchecked(run, codes::unsupported, c.where,
                      c.name + ": the datum table shifts a rotary or secondary axis, which is not run");
    set_shift(run, by);
}

void select_preset(Telling& run, const program::CycleDefinition& c, double n) {
    if (!is_row(n, highest_preset)) {
        alarm(run, codes::value_range, c.where, c.name + " needs the number of a preset");
        return;
    }
    flush_path(run);
    run.modal.datum_offset = {};
    const std::uint32_t datum = run.traits->datum.first + base::clipped<std::uint32_t>(n, 0, 99'999);
    const auto& known = run.env.machine.datums;
    const bool unknown = known.lower_bound(run.traits->datum.first) != known.end() && !known.contains(datum);
    if (unknown)
        unchecked(run, codes::unknown_value, c.where,
                  "preset " + printed(Value::real(n)) + " is not known, though others are: where it lies is not known",
                  "add it to the preset table, or give it in [datum] of the job");
    if (datum != run.modal.datum) run.modal.datum_before = datum_origin(run);
    set_datum(run, datum);
    run.datum_complained = run.datum_complained || unknown;
    keep_plane_alone(run);
}

void set_own_datum(Telling& run, const program::ProcedureCall& p) {
    const std::string axis = printed(evaluate(run, p.arguments[0]));
    const double unit = length_unit(run.modal);
    const double at = number(run, p.arguments[1]) * unit, becomes = number(run, p.arguments[2]) * unit;
    if (run.stopped) return;
    const auto k = axis.size() == 1 ? std::string_view("XYZ").find(axis[0]) : std::string_view::npos;
    bool straight = k != std::string_view::npos;
    for (const Transform& t : run.modal.transforms) straight = straight && t.kind == TransformKind::shift;
    if (!straight || std::isnan(at - becomes)) {
        unchecked(run, straight ? codes::unknown_value : codes::unsupported, p.where,
                  straight ? "this datum depends on a value that is not known: it is left out"
                           : "a datum of a rotary axis, or in a turned or scaled coordinate system, is not run");
        return;
    }
    flush_path(run);
    coordinate(run.modal.datum_offset, static_cast<int>(k)) += at - becomes;
    update_frame(run);
}

}  // namespace obrys::interp
