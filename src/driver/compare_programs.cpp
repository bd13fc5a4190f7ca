#include "driver/compare_programs.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "cl/text.hpp"
#include "driver/control.hpp"
#include "driver/stream_file.hpp"
#include "shop/home.hpp"

namespace obrys::driver {

namespace {

/// Records of a session, a few at a time.
class Records {
public:
    Records(Session& session, std::function<void(const cl::Record&)> sink) : session_(session), sink_(std::move(sink)) {
        if (may_repeat_from_a_block())
            sink_ = [this, to = std::move(sink_)](const cl::Record& record) { note(record), to(record); };
        if (session.main != nullptr)
            run_.emplace(session, sink_);
        else
            text_.emplace(session);
    }
    /// False behind the last.
    bool step() {
        if (run_ ? run_->step() : text_->step(sink_)) return true;
        if (!run_) return false;
        const interp::Outcome outcome = run_->finish();
        repeats_ = outcome.repeats;
        const auto at = std::lower_bound(noted_.begin(), noted_.end(), outcome.repeats_from,
                                         [](const Noted& n, std::uint32_t byte) { return n.byte < byte; });
        repeats_at_ = outcome.repeats_from == 0 ? 0 : at != noted_.end() ? at->moves : moves_;
        return false;
    }
    /// The program begins anew then, without end …
    [[nodiscard]] bool repeats() const { return repeats_; }
    /// … behind so many of its moves.
    [[nodiscard]] std::size_t repeats_at() const { return repeats_at_; }

private:
    [[nodiscard]] bool may_repeat_from_a_block() const {
        if (session_.main == nullptr) return false;
        const std::vector<program::Jump>& jumps = session_.main->jumps;
        return std::any_of(jumps.begin(), jumps.end(),
                           [](const program::Jump& j) { return j.direction == program::JumpDirection::again; });
    }
    /// How many moves stand before the first record of each place of the main program.
    void note(const cl::Record& record) {
        const std::vector<base::Span> sites = session_.stacks.sites(record.stack);
        const std::uint32_t byte = (sites.empty() ? record.from : sites.back()).begin;
        if (noted_.empty() || byte > noted_.back().byte) noted_.push_back({byte, moves_});
        if (cl::is_move(record.step)) ++moves_;
    }

    struct Noted {
        std::uint32_t byte = 0;
        std::size_t moves = 0;
    };
    Session& session_;
    std::function<void(const cl::Record&)> sink_;
    std::optional<Interpretation> run_;
    std::optional<StreamReader> text_;
    std::vector<Noted> noted_;
    std::size_t moves_ = 0, repeats_at_ = 0;
    bool repeats_ = false;
};

/// Places of the machine that a program leads to, by how it says them.
class SaidPlaces {
public:
    void take(const cl::Record& record) {
        const auto* place = std::get_if<cl::MachinePlace>(&record.step);
        if (place == nullptr || place->kind == cl::PlaceKind::frame) return;
        kinds_.push_back(place->kind);
        if (place->kind == cl::PlaceKind::home && !first_home_) first_home_ = record;
        if (place->kind == cl::PlaceKind::home)
            for (std::size_t k = 0; k < axes_.size(); ++k) axes_[k] = axes_[k] || place->axes[k];
    }
    /// What one says by its reference point the other says by coordinates. If nobody has given home, they are the same
    /// place as far as that is taken for granted.
    static std::vector<std::string> assumed(const SaidPlaces& a, const SaidPlaces& b, const Session& of_a,
                                            const Session& of_b) {
        std::vector<std::string> out;
        if (a.kinds_ == b.kinds_) return out;
        tell(a, of_a, out);
        tell(b, of_b, out);
        return out;
    }

private:
    static void tell(const SaidPlaces& said, const Session& session, std::vector<std::string>& out) {
        std::string axes;
        for (std::size_t k = 0; k < said.axes_.size(); ++k) {
            const std::string name(1, "XYZ"[k]);
            if (said.axes_[k] && shop::home_of(session.job.machine, name, session.homes_at_zero).is_assumed)
                axes += (axes.empty() ? "" : ", ") + name;
        }
        if (axes.empty()) return;
        const base::Position at = session.sources.position(said.first_home_->from);
        out.push_back(std::string(session.sources[said.first_home_->from.file].name) + ":" + std::to_string(at.line) +
                      ": no home of " + axes +
                      " is given: machine coordinate 0, to which the other goes, is taken for it, as on most machines "
                      "(home in the machine file)");
    }

    std::vector<cl::PlaceKind> kinds_;
    std::array<bool, 3> axes_{};
    std::optional<cl::Record> first_home_;
};

/// `step_a` and `step_b` give a few records of theirs to the comparison; false behind the last.
template <class StepA, class StepB>
compare::Result compare_steps(compare::Comparison& comparison, const StepA& step_a, const StepB& step_b) {
    using Side = compare::Comparison::Side;
    for (bool more_a = true, more_b = true; more_a || more_b;) {
        const Side side = comparison.waits_for();
        bool& more = side == Side::a ? more_a : more_b;
        do more = side == Side::a ? step_a() : step_b();
        while (more && !comparison.is_ahead(side));
        if (!more) comparison.end(side);
        comparison.advance();
    }
    return comparison.finish();
}

/// One of two that make the same moves begins anew behind them.
compare::Difference begins_anew(bool a_does, std::string_view word, const compare::Result& moves) {
    const std::string anew = "begins anew without end (" + std::string(word) + ")";
    compare::Difference d;
    d.aspect = compare::Aspect::events;
    d.what = a_does ? "it " + anew + "; the other ends" : "it ends; the other " + anew;
    d.move = moves.moves_a;
    return d;
}

/// Both begin anew, each at another place of what they do alike.
compare::Difference begins_anew_elsewhere(const Records& a, const Records& b, const compare::Result& moves) {
    compare::Difference d;
    d.aspect = compare::Aspect::events;
    d.what = "it begins anew without end at move " + std::to_string(a.repeats_at()) + "; the other at move " +
             std::to_string(b.repeats_at());
    d.move = moves.moves_a;
    return d;
}

}  // namespace

cl::Recording recording_of(Session& session) {
    cl::Recording out;
    static_cast<void>(interpret(session, [&](const cl::Record& record) { out.take(record); }));
    return out;
}

bool run_anew(const Session& session, const Request& request, cl::Sink sink) {
    Session own;
    Request again = request;
    again.prints_nowhere = true;  // it has been run before
    if (session.main == nullptr) again.input = session.program;
    const bool opened = session.main == nullptr ? open_stream(again, own) : open(again, own);
    if (!opened) return false;
    Records records(own, sink);
    while (records.step()) {
    }
    return true;
}

compare::Result compare_sessions(Session& a, Session& b, compare::Tolerance tolerance) {
    using Side = compare::Comparison::Side;
    const bool is_stream = a.main == nullptr || b.main == nullptr;
    const bool one_control = !a.control.empty() && a.control == b.control;
    // A stream says all in words of its own: what the other says otherwise is no other control's way to say it.
    tolerance.same_control = is_stream || one_control;
    tolerance.joins_freely = one_control && !is_stream && joins_freely(a.control);
    a.homes_at_zero = b.homes_at_zero = true;
    compare::Comparison comparison(tolerance);
    SaidPlaces places_a, places_b;
    Records in_a(a, [&](const cl::Record& record) { places_a.take(record), comparison.take(Side::a, record); });
    Records in_b(b, [&](const cl::Record& record) { places_b.take(record), comparison.take(Side::b, record); });
    compare::Result out = compare_steps(
        comparison, [&] { return in_a.step(); }, [&] { return in_b.step(); });
    out.assumed = SaidPlaces::assumed(places_a, places_b, a, b);
    if (in_a.repeats() != in_b.repeats())  // which is more than an end that one of them alone says
        std::erase_if(out.first,
                      [](const compare::Difference& d) { return d.aspect == compare::Aspect::events && !d.is_done; });
    if (in_a.repeats() != in_b.repeats() && out.of(compare::Aspect::events) == nullptr)
        out.first.push_back(begins_anew(in_a.repeats(), (in_a.repeats() ? a : b).main->traits->repeats_program, out));
    const bool elsewhere = in_a.repeats() && in_b.repeats() && in_a.repeats_at() != in_b.repeats_at();
    if (elsewhere && out.of(compare::Aspect::events) == nullptr)
        out.first.push_back(begins_anew_elsewhere(in_a, in_b, out));
    return out;
}

compare::Result compare_with(const cl::Recording& a, Session& b, const compare::Tolerance& tolerance) {
    using Side = compare::Comparison::Side;
    compare::Comparison comparison(tolerance);
    cl::Recording::Playback in_a(a);
    Records in_b(b, [&](const cl::Record& record) { comparison.take(Side::b, record); });
    const auto to_a = [&](const cl::Record& record) { comparison.take(Side::a, record); };
    return compare_steps(
        comparison, [&] { return in_a.step(to_a); }, [&] { return in_b.step(); });
}

void warn_of(Session& s, const compare::Difference& d, std::string text, std::string remedy) {
    base::Diagnostic out;
    out.severity = base::Severity::warning;
    out.code = base::codes::unknown_value;
    if (d.in_a) out.where = *d.in_a;
    out.stack = s.stacks.sites(d.stack_a);
    out.text = std::move(text);
    out.remedy = std::move(remedy);
    s.diagnostics.add(std::move(out));
}

void complain_of_turns(Session& s, const compare::Result& result) {
    if (result.turns)
        warn_of(s, *result.turns, result.turns->what + ": whether they turn alike is not known",
                "name a machine with its rotary axes (chain, docs/machine-file.md), or say in both which one");
}

bool joins_freely(std::string_view control) {
    const Control* known = find_control(control);
    return known != nullptr && known->joins_freely;
}

std::size_t block_stops(const Session& session) {
    std::size_t count = 0;
    if (session.programs == nullptr) return count;
    for (const auto& unit : session.programs->units())
        for (const program::Ignored& word : unit->ignored)
            if (base::equals_ignoring_case(word.text, "G9") || base::equals_ignoring_case(word.text, "G09"))
                count += word.count;
    return count;
}

}  // namespace obrys::driver
