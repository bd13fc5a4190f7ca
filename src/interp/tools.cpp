/// Tools, spindle, feed and machine functions of a block.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

const shop::Tool* find_tool(const Run& run, const ToolState& t) {
    for (const shop::Tool& tool : run.env.tools) {
        const bool same =
            t.number != 0 ? tool.number == t.number : !t.name.empty() && base::equals_ignoring_case(tool.name, t.name);
        if (same && (tool.edge == t.edge || t.edge == 0)) return &tool;
    }
    return nullptr;
}

void tool_into_spindle(Run& run) {
    run.tool.number = run.tool.prepared;
    run.tool.name = run.tool.prepared_name;
    run.tool.waiting = false;
    if (run.tool.number == 0) {  // T="NAME": the list may know its number
        ToolState any = run.tool;
        any.edge = 0;
        if (const shop::Tool* known = find_tool(run, any)) run.tool.number = known->number;
    }
    run.tool.edge = 1;  // MD20270 CUTTING_EDGE_DEFAULT as delivered
}

bool changes_on_m6(const Run& run) { return run.env.machine.kind == shop::MachineKind::mill; }

void emit_tool(Run& run) {
    flush_path(run);
    run.tool.data = find_tool(run, run.tool);
    emit(run, cl::ToolChange{run.tool.number, run.tool.edge, run.tool.name});
}

void emit_spindle(Run& run) {
    cl::Spindle s;
    s.speed = run.spindle.speed;
    s.mode = run.modal.surface_speed ? cl::SpindleMode::surface : cl::SpindleMode::rpm;
    s.direction = static_cast<std::int8_t>(run.spindle.direction);
    s.limit = run.modal.surface_speed ? run.spindle.limit : 0;
    emit(run, s);
}

bool spindle_words(Run& run) {
    BlockWords& b = run.block;
    bool changed = false;
    if (b.has(Code::spindle) && b.special != Modal::dwell && std::isnan(b.get(Code::spindle))) {
        unchecked(run, codes::unknown_value, run.here(),
                  "the spindle speed depends on a value that is not known: the last one is kept");
    } else if (b.has(Code::spindle) && b.special != Modal::dwell) {
        const double s = b.get(Code::spindle);
        run.spindle.speed = std::abs(s);
        changed = true;
    }
    if (b.has(Code::speed_limit)) {
        run.spindle.limit = b.get(Code::speed_limit);
        changed = true;
    }
    for (const int m : b.m) {
        if (m == 3 || m == 4) {
            run.spindle.direction = m == 3 ? 1 : -1;
            changed = true;
        }
    }
    if (b.has(Code::spindle_position)) {
        run.spindle.direction = 0;
        changed = true;
    }
    return changed;
}

void feed_word(Run& run) {
    if (!run.block.has(Code::feed) || run.block.special == Modal::dwell) return;
    double f = run.block.get(Code::feed);
    if (run.modal.inch_feed && run.modal.feed_mode != cl::FeedMode::inverse_time) f *= 25.4;
    if (std::isnan(f)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "the feed depends on a value that is not known: the last one is kept");
        return;
    }
    if (f < 0) {
        alarm(run, codes::value_range, run.here(), "the feed F is negative");
        return;
    }
    if (run.feed_valid && f == run.feed) return;
    run.feed = f;
    run.feed_valid = f > 0;
    flush_path(run);
    emit(run, cl::Feed{f, run.modal.feed_mode});
}

void coolant(Run& run, int m) {
    const auto state = m == 7 ? cl::CoolantState::mist : m == 8 ? cl::CoolantState::flood : cl::CoolantState::off;
    emit(run, cl::Coolant{state});
}

/// M functions the control itself knows; others go to the machine and are listed.
bool is_standard(int m) {
    return (m >= 0 && m <= 9) || m == 17 || m == 30 || m == 19 || m == 70 || (m >= 40 && m <= 45);
}

void machine_functions(Run& run) {
    for (const int m : run.block.m) {
        if (m == 7 || m == 8) coolant(run, m);
        if (is_standard(m)) continue;
        emit(run, cl::Auxiliary{'M', m});
        assume(
            run, run.here(),
            "M" + std::to_string(m) + " is a function of the machine builder: taken as having no effect on the path");
    }
    for (const int h : run.block.h) emit(run, cl::Auxiliary{'H', h});
}

}  // namespace

void select_tool(Run& run) {
    BlockWords& b = run.block;
    bool changed = false;
    if (b.has(Code::tool)) {
        const double t = b.get(Code::tool);
        if (!b.tool_named && std::isnan(t)) {
            unchecked(run, codes::unknown_value, run.here(), "which tool this is depends on a value that is not known");
            return;
        }
        if (!b.tool_named && (t < 0 || t > 4294967295.0 || t != std::floor(t))) {
            alarm(run, codes::value_range, run.here(), "T" + printed(Value::real(t)) + " is no tool number");
            return;
        }
        run.tool.prepared = b.tool_named ? 0 : static_cast<std::uint32_t>(t);
        run.tool.prepared_name = b.tool_named ? b.tool_name : std::string{};
        run.tool.waiting = true;
        if (!changes_on_m6(run)) {
            tool_into_spindle(run);
            changed = true;
        }
    }
    if (std::find(b.m.begin(), b.m.end(), 6) != b.m.end() && run.tool.waiting) {
        tool_into_spindle(run);
        changed = true;
    }
    if (b.has(Code::edge)) {
        const double d = b.get(Code::edge);
        if (std::isnan(d)) {
            unchecked(run, codes::unknown_value, run.here(),
                      "which cutting edge this is depends on a value that is not known");
            return;
        }
        if (!(d >= 0 && d <= 32000)) {
            alarm(run, codes::value_range, run.here(), "D" + printed(Value::real(d)) + " is no cutting edge");
            return;
        }
        const auto edge = static_cast<std::uint32_t>(d);
        changed = changed || edge != run.tool.edge;
        run.tool.edge = edge;
    }
    if (changed) emit_tool(run);
}

void technology(Run& run) {
    BlockWords& b = run.block;
    constexpr auto bit = [](Code c) { return std::uint64_t{1} << static_cast<unsigned>(c); };
    constexpr std::uint64_t words = bit(Code::feed) | bit(Code::spindle) | bit(Code::speed_limit) | bit(Code::tool) |
                                    bit(Code::edge) | bit(Code::spindle_position) | bit(Code::round_modal) |
                                    bit(Code::corner_feed_modal);
    if ((b.present & words) == 0 && b.m.empty() && b.h.empty()) return;
    if (b.has(Code::round_modal))
        run.modal.round_modal = b.get(Code::round_modal) * (run.modal.inch_geometry ? 25.4 : 1);
    if (b.has(Code::corner_feed_modal)) run.modal.corner_feed_modal = b.get(Code::corner_feed_modal);
    select_tool(run);
    if (run.stopped) return;
    if (spindle_words(run)) emit_spindle(run);
    feed_word(run);
    if (!run.stopped) machine_functions(run);
}

void after_motion(Run& run) {
    if (run.block.m.empty()) return;
    const std::vector<int> functions = run.block.m;
    for (const int m : functions) {
        if (run.stopped) return;
        if (m == 5 || m == 19) {
            run.spindle.direction = 0;
            emit_spindle(run);
        } else if (m == 9) {
            coolant(run, m);
        } else if (m == 0 || m == 1) {
            flush_path(run);
            emit(run, cl::Stop{m == 0 ? cl::StopKind::program : cl::StopKind::optional});
        } else if (m == 2 || m == 30 || m == 17) {
            flush_path(run);
            if (run.calls.size() == 1) emit(run, cl::Stop{cl::StopKind::end});
            leave(run);
            return;
        }
    }
}

}  // namespace obrys::interp
