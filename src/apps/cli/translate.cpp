/// obrys translate.

#include "driver/keep.hpp"

#include <algorithm>
#include <cstdio>

#include "base/codes.hpp"
#include "commands.hpp"
#include "milled.hpp"
#include "session.hpp"

namespace obrys::cli {

namespace {

/// "PART" of "subs/PART.MPF".
std::string program_name(const std::string& path) { return driver::fs::path(path).stem().string(); }

const char* verdict_of(const driver::Proved& p) {
    return p.differs ? "does not do the same" : p.proof == driver::Proof::same ? "does the same" : "not fully compared";
}

int code_of(driver::Proof p) { return p == driver::Proof::same ? 0 : p == driver::Proof::differs ? 1 : 3; }

/// Exit code of what was written, run again: 0 it does the same, 1 it does not, 3 it could not be held to it.
int proved(driver::Session& s, const driver::Translated& t, const write::Post& post, const Arguments& a) {
    compare::Tolerance tolerance;
    tolerance.length = a.same_place;
    const driver::Proved proved = driver::prove(t, post, with_outputs(a), s, tolerance);
    if (!proved.why_not.empty()) std::fprintf(stderr, "not compared: %s\n", proved.why_not.c_str());
    if (proved.run != nullptr && (proved.run_complains || !proved.why_not.empty()))
        print_diagnostics(*proved.run, base::Severity::warning);
    if (proved.why_not.empty())
        std::fprintf(stderr, "%s: %zu moves, run again as %s, within %g mm\n", verdict_of(proved), proved.moves,
                     post.control.c_str(), a.same_place);
    return code_of(proved.proof);
}

std::string listed(const std::vector<std::string>& set) {
    std::string out;
    for (const std::string& one : set) out += (out.empty() ? "" : " ") + one;
    return out;
}

/// The written program with its own values and with others; the worst of all.
driver::Proof proved_with_all(driver::Session& s, const driver::Kept& kept, const write::Post& post, const Arguments& a,
                              std::vector<driver::LedgerRun>& runs) {
    compare::Tolerance tolerance;
    tolerance.length = a.same_place;
    const driver::Request request = with_outputs(a);
    std::vector<std::vector<std::string>> sets{{}};
    for (auto& set : driver::other_values(s, kept.rewritten, static_cast<std::size_t>(a.sets)))
        sets.push_back(std::move(set));
    bool differs = false, unknown = false;
    for (const std::vector<std::string>& set : sets) {
        std::string what;
        const driver::Proved p = driver::prove_with(set, kept, post, request, tolerance, what);
        runs.push_back({set, p.proof});
        differs = differs || p.differs || p.proof == driver::Proof::differs;
        unknown = unknown || p.proof == driver::Proof::not_compared;
        const bool first = set.empty();
        if (p.run != nullptr && p.proof != driver::Proof::same && first)
            print_diagnostics(*p.run, base::Severity::warning);
        std::fprintf(stderr, "%s: %zu moves, %s%s%s\n", verdict_of(p), p.moves,
                     set.empty() ? "with the program's own values" : listed(set).c_str(), what.empty() ? "" : ": ",
                     what.c_str());
        if (!p.why_not.empty()) std::fprintf(stderr, "not compared: %s\n", p.why_not.c_str());
    }
    return differs ? driver::Proof::differs : unknown ? driver::Proof::not_compared : driver::Proof::same;
}

void print_names(const driver::Kept& kept) {
    for (const rewrite::Renamed& p : kept.rewritten.programs)
        std::fprintf(stderr, "%s is %s\n", p.from.c_str(), p.to.c_str());
    for (const rewrite::Renamed& n : kept.rewritten.names)
        std::fprintf(stderr, "%s%s%s is %s\n", n.from.c_str(), n.program.empty() ? "" : " of ", n.program.c_str(),
                     n.to.c_str());
}

int translate_kept(driver::Session& s, const write::Post& post, const Arguments& a) {
    const auto language = driver::find_language(a.to, s);
    if (!language) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    const driver::Kept kept = driver::keep(s, *language, program_name(s.program), a.same_place);
    for (const rewrite::Note& note : kept.rewritten.notes) s.diagnostics.add(driver::complaint_of(note));
    const bool lost = kept.rewritten.loses();
    std::vector<driver::LedgerRun> runs;
    driver::Proof proof = driver::Proof::differs;
    if (!lost || a.accept_loss) {
        print_names(kept);
        proof = proved_with_all(s, kept, post, a, runs);
    }
    print_diagnostics(s);
    const int run = driver::exit_code_of_run(s);
    if (lost && !a.accept_loss) {
        std::fprintf(stderr,
                     "nothing was written: it would lose what is named above (--accept-loss writes the rest)\n");
        return run == 2 ? 2 : run == 3 ? 3 : 1;
    }
    if (!may_write(a, s)) return 2;
    driver::OutputFile out(a.output);
    out.write(kept.rewritten.text);
    bool written = deliver(a.output, out) && !s.files->failed();
    if (const std::string path = ledger_of(a); written && !path.empty()) {
        driver::OutputFile ledger(path);
        ledger.write(driver::ledger(s, kept, post, a.output, proof, runs));
        written = deliver(path, ledger);
    }
    return !written || run == 2 ? 2 : run == 3 ? 3 : std::max({run, code_of(proof), lost ? 1 : 0});
}

}  // namespace

int translate(const Arguments& a) {
    driver::Session s;
    if (!open(a, s)) return 2;
    const std::optional<write::Post> post = driver::find_post(a.to, s);
    if (!post) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    if (a.keep) return translate_kept(s, *post, a);
    const auto note = [&](const write::Note& n) { s.diagnostics.add(driver::complaint_of(n, s)); };
    const driver::Translated t = driver::translate(s, *post, program_name(s.program), a.same_place, note);
    const int proof = proved(s, t, *post, a);
    print_diagnostics(s);
    driver::OutputFile out(a.output);
    out.write(t.text);
    const bool written = may_write(a, s) && deliver(a.output, out) && !s.files->failed();
    const int run = driver::exit_code_of_run(s);
    return !written || run == 2 ? 2 : run == 3 || proof == 3 ? 3 : std::max(run, proof);
}

}  // namespace obrys::cli
