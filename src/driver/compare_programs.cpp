#include "driver/compare_programs.hpp"

#include "cl/text.hpp"
#include "driver/stream_file.hpp"

namespace obrys::driver {

namespace {

/// Records of a session, a few at a time.
class Records {
public:
    Records(Session& session, std::function<void(const cl::Record&)> sink) : sink_(std::move(sink)) {
        if (session.main != nullptr)
            run_.emplace(session, sink_);
        else
            text_.emplace(session.sources, 0, session.diagnostics);
    }
    /// False behind the last.
    bool step() {
        if (run_ ? run_->step() : text_->step(sink_)) return true;
        if (run_) repeats_ = run_->finish().repeats;
        return false;
    }
    /// The program begins anew then, without end.
    [[nodiscard]] bool repeats() const { return repeats_; }

private:
    std::function<void(const cl::Record&)> sink_;
    std::optional<Interpretation> run_;
    std::optional<cl::TextReader> text_;
    bool repeats_ = false;
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
    tolerance.same_control = !a.control.empty() && a.control == b.control;
    compare::Comparison comparison(tolerance);
    Records in_a(a, [&](const cl::Record& record) { comparison.take(Side::a, record); });
    Records in_b(b, [&](const cl::Record& record) { comparison.take(Side::b, record); });
    compare::Result out = compare_steps(
        comparison, [&] { return in_a.step(); }, [&] { return in_b.step(); });
    if (in_a.repeats() != in_b.repeats() && out.of(compare::Aspect::events) == nullptr)
        out.first.push_back(begins_anew(in_a.repeats(), (in_a.repeats() ? a : b).main->traits->repeats_program, out));
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

}  // namespace obrys::driver
