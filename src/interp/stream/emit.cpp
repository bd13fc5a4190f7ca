/// Records out of the run.

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/codes.hpp"
#include "interp/stream/path_stage.hpp"
#include "interp/stream/stream.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// The run's record comes from where the run is.
void place_record(Telling& run) {
    run.record.from = run.along != nullptr ? run.along->where : run.here();
    run.record.stack = run.along != nullptr ? run.along->stack : run.top().stack;
}

void send_record(Telling& run) {
    place_record(run);
    if (run.path->holds() && !cl::is_move(run.record.step))
        run.path->hold(run.record);
    else
        send_plain(run, run.record);
}

}  // namespace

void emit(Telling& run, cl::Step step) {
    if (run.capture != nullptr) return;
    run.record.step = std::move(step);
    send_record(run);
}

void emit_line(Telling& run, bool rapid) {
    if (run.capture != nullptr) return;
    cl::Linear& line = step_as<cl::Linear>(run.record.step);
    line.to = run.position;
    line.axis = run.tool_axis;
    line.rapid = rapid;
    line.seek = cl::Seek::nothing;
    line.ends.clear();
    place_record(run);
    send_plain(run, run.record);
}

void begin_part(Telling& run, cl::PartKind kind, std::string name, std::uint64_t pass, std::uint64_t passes,
                std::vector<cl::PartArgument> arguments) {
    emit(run, cl::PartBegin{kind, std::move(name), pass, passes, std::move(arguments)});
}

void end_part(Telling& run) { emit(run, cl::PartEnd{}); }

void flush_path(Telling& run) {
    if (run.capture == nullptr && run.path->active()) run.path->flush(run);
}

cl::AxisEnd axis_end(std::string_view name, double to, bool is_rotary, bool counted) {
    cl::AxisEnd axis;
    for (std::size_t i = 0; i < name.size() && i + 1 < axis.name.size(); ++i) axis.name[i] = name[i];
    axis.to = to;
    axis.rotary = is_rotary;
    axis.counted = counted;
    return axis;
}

void take_along(Telling& run, const cl::AxisEnd& axis) {
    if (run.capture == nullptr) run.ends.push_back(axis);
}

void send_with_ends(Telling& run, cl::Record record) {
    *cl::ends_of(record.step) = std::exchange(run.ends, {});
    send(run, record);
}

geom::Vec3 stream_origin(const Reckoning& run) {
    geom::Vec3 origin{unknown_number, unknown_number, unknown_number};
    const auto& known = run.env.machine.datums;
    if (const auto found = known.find(run.reference_datum); found != known.end())
        origin = found->second;
    else if (run.reference_datum == program::no_datum && run.traits->datum.none_is_machine_zero && !known.empty())
        origin = {};  // the machine's own zero
    for (int k = 0; k < 3 && keeps_offsets(run); ++k)
        if (is_datum_given(run, static_cast<std::size_t>(k)) && run.offsets.given[static_cast<std::size_t>(k)])
            coordinate(origin, k) = run.offsets.reference[static_cast<std::size_t>(k)];
    if (run.env.machine.datum_rotations.contains(run.reference_datum)) origin.x = origin.y = unknown_number;
    return origin;
}

geom::Vec3 selected_origin(const Reckoning& run) {
    geom::Vec3 origin{unknown_number, unknown_number, unknown_number};
    if (!run.datum_known) return origin;
    for (int k = 0; k < 3 && keeps_offsets(run); ++k)
        if (is_datum_given(run, run.modal.datum, static_cast<std::size_t>(k)))
            coordinate(origin, k) = run.offsets.datum[static_cast<std::size_t>(k)];
    if (!keeps_offsets(run)) origin = datum_origin(run);
    const bool turned = run.offsets.rotation != 0 || run.env.machine.datum_rotations.contains(run.modal.datum);
    if (turned) origin.x = origin.y = unknown_number;
    return origin;
}

namespace {

/// The job says where zero offsets lie, and that of the first move is none of them: the stock lies in one that it
/// names.
void say_foreign_datum(Reckoning& run) {
    const auto& known = run.env.machine.datums;
    const bool numbered = run.traits->datum.none_is_machine_zero && run.traits->datum.first == 0;
    if (keeps_offsets(run) ? is_datum_given(run) : !numbered) return;
    if (known.empty() || known.contains(run.reference_datum) || run.env.stored != nullptr) return;
    const std::string active = program::datum_name(*run.traits, run.reference_datum);
    unchecked(run, codes::unknown_value, run.here(),
              "the program moves in " + active + ", which the job does not give, though it gives " +
                  program::datum_name(*run.traits, known.begin()->first) + ": where the stock lies in it is not known",
              "program the zero offset that the job means, or give " +
                  program::datum_key(*run.traits, run.reference_datum) + " in [datum] of the job");
}

}  // namespace

namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same(const cl::FramePart& a, const cl::FramePart& b) {
    const auto& l = a.frame.linear;
    const geom::Vec3 p = a.frame.origin, q = b.frame.origin;
    return a.kind == b.kind && a.turn == b.turn && same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z) &&
           std::equal(l.begin(), l.end(), b.frame.linear.begin(), [](double x, double y) { return same(x, y); });
}

/// G500 selects none, which is not the same as no word: what holds then is the control's own.
bool is_none_by_word(const Reckoning& run, std::uint32_t number) {
    constexpr std::uint32_t none = 500;
    return number == none && run.modal.datum == none && run.modal.datum_said;
}

/// Where a zero lies elsewhere by nobody knows how much, the tool stands at a place of it that nobody has said.
void forget_places(Telling& run, const geom::Vec3& from, const geom::Vec3& to) {
    const geom::Vec3 way = to - from;
    const bool lathe = run.env.machine.kind == shop::MachineKind::lathe;
    const std::array lost{std::isnan(way.x), std::isnan(way.y) && !lathe, std::isnan(way.z)};
    for (std::size_t k = 0; k < lost.size(); ++k) run.unsaid_since_change[k] = run.unsaid_since_change[k] || lost[k];
}

/// The first zero is that in which the run reckons.
void emit_datum(Telling& run) {
    StreamFrame& told = run.told;
    if (!told.begun) {
        told.begun = true;
        say_foreign_datum(run);
        told.first = told.datum = {run.reference_datum, stream_origin(run), is_none_by_word(run, run.reference_datum)};
        emit(run, told.first);
        if (run.modal.datum == program::no_datum) told.datum.number = run.modal.datum;
    }
    const cl::Datum selected{run.modal.datum, selected_origin(run), is_none_by_word(run, run.modal.datum)};
    const bool again = selected.number == told.datum.number && selected.selected == told.datum.selected &&
                       cl::way(told.datum, selected) == geom::Vec3{};
    if (again) return;
    // Where no zero was selected before, it is taken to be that of the stream.
    const bool is_first = told.datum.number == program::no_datum && selected.number == told.first.number;
    if (!is_first) forget_places(run, told.datum.origin, selected.origin);
    told.datum = selected;
    emit(run, selected);
}

}  // namespace

void emit_frame(Telling& run) {
    if (run.told.current) return;
    run.told.current = true;
    emit_datum(run);
    std::vector<cl::FramePart> parts = frame_parts(run);
    const auto alike = [](const cl::FramePart& a, const cl::FramePart& b) { return same(a, b); };
    if (std::equal(parts.begin(), parts.end(), run.told.parts.begin(), run.told.parts.end(), alike)) return;
    run.told.parts = std::move(parts);
    emit(run, cl::Frame{run.told.parts});
}

}  // namespace obrys::interp
