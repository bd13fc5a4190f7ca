/// What the run complains about. While blocks are only looked at it is kept for who looks: nothing is ever swallowed.

#include "interp/complaints.hpp"

#include "base/codes.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using base::Severity;

namespace {

std::vector<base::Span> stack_of(const Saying& run) {
    return run.calls.empty() ? std::vector<base::Span>{} : run.stacks->sites(run.calls.back().stack);
}

bool first_at_place(Saying& run, std::string_view code, const base::Span& where) {
    std::uint64_t key = std::hash<std::string_view>{}(code);
    key ^= (std::uint64_t{where.file} << 40) ^ (std::uint64_t{where.begin} << 8);
    return run.reported.insert(key).second;
}

/// False where it has been said.
bool is_new(Saying& run, const Complaint& c) {
    if (c.once_by_text && !run.assumed.insert(c.what.text).second) return false;
    return !c.once_by_place || first_at_place(run, c.what.code, c.what.where);
}

/// To the list, or to who looks ahead.
void hand_over(Saying& run, Complaint c) {
    if (run.complaints != nullptr) return run.complaints->add(std::move(c));
    if (is_new(run, c)) run.diagnostics->add(std::move(c.what));
}

/// As above; the calls that led here are added.
void hand_over_here(Saying& run, Complaint c) {
    if (run.complaints == nullptr && !is_new(run, c)) return;
    c.what.stack = stack_of(run);
    if (run.complaints != nullptr) return run.complaints->add(std::move(c));
    run.diagnostics->add(std::move(c.what));
}

void end_by_alarm(Saying& run) {
    run.stopped = true;
    run.ending = Ending::alarm;
}

}  // namespace

void Complaints::add(Complaint c) {
    if (c.once_by_text && !texts_.insert(c.what.text).second) return;
    if (c.once_by_place && !places_.insert({c.what.code, c.what.where.file, c.what.where.begin}).second) return;
    all_.push_back(std::move(c));
}

void say(Saying& run, const Complaints& complaints, const std::string& of) {
    for (Complaint c : complaints.all()) {
        if (run.stopped) return;
        if (c.ends_run && !of.empty()) c.what.text = of + ": " + c.what.text;
        if (c.ends_run) end_by_alarm(run);
        if (c.what.severity == Severity::warning) run.complained = true;
        hand_over(run, std::move(c));
    }
}

void raise(Saying& run, base::Diagnostic d) { hand_over(run, {std::move(d), false, false, false}); }

void alarm(Saying& run, std::string_view code, const base::Span& where, std::string text, std::string remedy) {
    if (run.stopped) return;
    end_by_alarm(run);
    hand_over_here(run,
                   {{Severity::error, code, where, std::move(text), std::move(remedy), {}, {}}, true, false, false});
}

std::string of_alarm(std::string_view number) {
    return number.empty() ? std::string() : " (alarm " + std::string(number) + ")";
}

void unchecked(Saying& run, std::string_view code, const base::Span& where, std::string text, std::string remedy) {
    run.complained = true;
    if (run.stopped) return;
    hand_over_here(run,
                   {{Severity::warning, code, where, std::move(text), std::move(remedy), {}, {}}, false, false, true});
}

void unchecked_once(Saying& run, std::string_view code, const base::Span& where, std::string text, std::string remedy) {
    run.complained = true;
    if (run.stopped) return;
    hand_over_here(run,
                   {{Severity::warning, code, where, std::move(text), std::move(remedy), {}, {}}, false, true, true});
}

void doubt(Saying& run, std::string_view code, const base::Span& where, std::string text, std::string remedy) {
    hand_over_here(run,
                   {{Severity::warning, code, where, std::move(text), std::move(remedy), {}, {}}, false, false, true});
}

void assume(Saying& run, const base::Span& where, std::string text, std::string remedy) {
    hand_over_here(
        run,
        {{Severity::note, codes::assumption, where, std::move(text), std::move(remedy), {}, {}}, false, true, false});
}

}  // namespace obrys::interp
