#include "interp/capture.hpp"

#include "base/text.hpp"

namespace obrys::interp {

namespace {

constexpr std::size_t most_statements = 100'000;  ///< of a contour, loops counted
constexpr std::size_t most_ahead = 500;           ///< statements looked at for the next element

}  // namespace

struct Rehearsal::Saved {
    std::vector<Captured>* capture;
    std::vector<Activation> calls;
    Parameters parameters;
    ModalState modal;
    BlockWords block;
    ToolState tool;
    SpindleState spindle;
    double feed;
    bool coolant_on, feed_valid, feed_dropped, moved, datum_emitted, datum_known, frame_is_identity, stopped;
    Ending ending;
    std::uint64_t blocks;
    geom::Vec3 position, programmed_position;
    geom::Frame frame;
    geom::Vec3 tool_axis;
    std::uint32_t reference_datum;
    std::unordered_map<std::string, double> extra_axes;
    geom::Vec2 last_direction;
    ActiveCycle cycle;
    std::vector<std::string> contour_labels;
    std::string last_message;
    const program::Statement* statement;
    std::shared_ptr<FreeContour> free_contour;
    ActiveCycle contour_data, contour_train_data;
    const Unit* contour_unit;
    CallPattern pattern;
    std::vector<ContourChoice> contour_choices;
    std::string datum_table, open_table;
    Offsets offsets;
    CannedState canned;
    bool mist, flood, probed;
    Overrides overrides;
    std::map<std::pair<int, program::CycleRole>, double> cycle_store;
    Scope globals;
    /// What the variables hold: calls and scopes share them with what is run ahead.
    std::vector<std::pair<std::shared_ptr<Array>, Array>> values;
};

namespace {

std::vector<std::pair<std::shared_ptr<Array>, Array>> values_of(const Run& run) {
    std::vector<std::pair<std::shared_ptr<Array>, Array>> values;
    const auto keep = [&](const Scope& scope) {
        for (const Binding& b : scope.bindings()) values.emplace_back(b.array, *b.array);
    };
    keep(run.globals);
    for (const Activation& a : run.calls) keep(a.locals);
    return values;
}

}  // namespace

Rehearsal::Rehearsal(Run& r)
    : run_(r),
      saved_(new Saved{r.capture,
                       r.calls,
                       r.parameters,
                       r.modal,
                       r.block,
                       r.tool,
                       r.spindle,
                       r.feed,
                       r.coolant_on,
                       r.feed_valid,
                       r.feed_dropped,
                       r.moved,
                       r.datum_emitted,
                       r.datum_known,
                       r.frame_is_identity,
                       r.stopped,
                       r.ending,
                       r.blocks,
                       r.position,
                       r.programmed_position,
                       r.frame,
                       r.tool_axis,
                       r.reference_datum,
                       r.extra_axes,
                       r.last_direction,
                       r.cycle,
                       r.contour_labels,
                       r.last_message,
                       r.statement,
                       r.free_contour,
                       r.contour_data,
                       r.contour_train_data,
                       r.contour_unit,
                       r.pattern,
                       r.contour_choices,
                       r.datum_table,
                       r.open_table,
                       r.offsets,
                       r.canned,
                       r.mist,
                       r.flood,
                       r.probed,
                       r.overrides,
                       r.cycle_store,
                       r.globals,
                       values_of(r)}) {
    run_.capture = &elements_;
    run_.free_contour.reset();  // its solver would go on with blocks that are only tried
}

Rehearsal::~Rehearsal() {
    Saved& s = *saved_;
    run_.capture = s.capture;
    run_.calls = std::move(s.calls);
    run_.parameters = std::move(s.parameters);
    run_.modal = std::move(s.modal);
    run_.block = std::move(s.block);
    run_.tool = std::move(s.tool);
    run_.spindle = s.spindle;
    run_.feed = s.feed;
    run_.coolant_on = s.coolant_on;
    run_.feed_valid = s.feed_valid;
    run_.feed_dropped = s.feed_dropped;
    run_.moved = s.moved;
    run_.datum_emitted = s.datum_emitted;
    run_.datum_known = s.datum_known;
    run_.frame_is_identity = s.frame_is_identity;
    run_.stopped = s.stopped;
    run_.ending = s.ending;
    run_.blocks = s.blocks;
    run_.position = s.position;
    run_.programmed_position = s.programmed_position;
    run_.frame = s.frame;
    run_.tool_axis = s.tool_axis;
    run_.reference_datum = s.reference_datum;
    run_.extra_axes = std::move(s.extra_axes);
    run_.last_direction = s.last_direction;
    run_.cycle = std::move(s.cycle);
    run_.contour_labels = std::move(s.contour_labels);
    run_.last_message = std::move(s.last_message);
    run_.statement = s.statement;
    run_.free_contour = std::move(s.free_contour);
    run_.contour_data = std::move(s.contour_data);
    run_.contour_train_data = std::move(s.contour_train_data);
    run_.contour_unit = s.contour_unit;
    run_.pattern = std::move(s.pattern);
    run_.contour_choices = std::move(s.contour_choices);
    run_.datum_table = std::move(s.datum_table);
    run_.open_table = std::move(s.open_table);
    run_.offsets = s.offsets;
    run_.canned = s.canned;
    run_.mist = s.mist;
    run_.flood = s.flood;
    run_.probed = s.probed;
    run_.overrides = s.overrides;
    run_.cycle_store = std::move(s.cycle_store);
    run_.globals = std::move(s.globals);
    for (auto& [array, value] : s.values) *array = std::move(value);
}

std::optional<Captured> next_element(Run& run, const geom::Vec3& from) {
    const Rehearsal rehearsal(run);
    run.programmed_position = from;
    run.position = geom::apply(run.frame, from);
    for (std::size_t n = 0; n < most_ahead && !run.stopped; ++n) {
        step(run);
        for (const Captured& c : rehearsal.elements())
            if (path::moves_in_plane(c.element)) return c;
    }
    return std::nullopt;
}

std::optional<std::vector<Captured>> elements_of_label(Run& run, const Unit& unit, const std::string& label) {
    const auto found = unit.labels.find(run.env.names.id(base::to_upper(label)));
    if (found == unit.labels.end()) return std::nullopt;
    const Rehearsal rehearsal(run);
    const std::size_t depth = run.calls.size();
    Activation contour;
    contour.unit = &unit;
    contour.stack = run.stacks.push(run.top().stack, run.here());
    contour.pc = found->second.front();
    contour.labels.push_back({static_cast<std::uint32_t>(unit.statements.size()), contour.stack});
    run.calls.push_back(std::move(contour));
    for (std::size_t n = 0; n < most_statements; ++n) {
        if (run.stopped) return std::nullopt;
        const bool ended = run.calls.size() == depth + 1 && run.top().labels.empty();
        if (ended || run.calls.size() <= depth) return rehearsal.elements();
        step(run);
    }
    return std::nullopt;
}

std::optional<std::vector<Captured>> elements_of_turned_contour(Run& run, const Unit& unit, geom::Vec3 from) {
    const bool before = run.turned_contour;
    run.turned_contour = true;
    auto elements = elements_of_program(run, unit, from);
    run.turned_contour = before;
    return elements;
}

BlockRehearsal elements_of_blocks(Run& run, std::uint32_t first, std::uint32_t last) {
    BlockRehearsal out;
    const Rehearsal rehearsal(run);
    run.silenced = &out.complaints;
    const std::size_t depth = run.calls.size();
    run.top().pc = first;
    run.top().sections.clear();
    for (std::size_t n = 0; n < most_statements && !run.stopped; ++n) {
        const bool outside = run.calls.size() != depth || run.top().pc < first || run.top().pc > last;
        out.ended = run.calls.size() == depth && run.top().pc == last + 1;
        if (outside) break;
        step(run);
    }
    run.silenced = nullptr;
    out.elements = rehearsal.elements();
    return out;
}

std::optional<std::vector<Captured>> elements_of_program(Run& run, const Unit& unit, std::optional<geom::Vec3> from) {
    const Rehearsal rehearsal(run);
    if (from) arrive(run, *from);
    // The contour of a turning cycle begins with lines, whatever is in force where the cycle stands.
    if (run.turned_contour && run.modal.motion == Modal::canned_off) run.modal.motion = Modal::linear;
    const std::size_t depth = run.calls.size();
    enter(run, unit, nullptr, run.here());
    if (run.calls.size() == depth) return std::nullopt;
    for (std::size_t n = 0; n < most_statements; ++n) {
        if (run.calls.size() <= depth || (run.stopped && run.ending == Ending::regular)) return rehearsal.elements();
        if (run.stopped) return std::nullopt;
        step(run);
    }
    return std::nullopt;
}

}  // namespace obrys::interp
