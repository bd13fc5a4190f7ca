/// obrys translate.

#include "driver/translate.hpp"

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

base::Diagnostic complaint(const write::Note& note, const driver::Session& s) {
    base::Diagnostic d;
    const bool lost = note.fate == write::Fate::lost;
    d.severity = lost ? base::Severity::error : base::Severity::note;
    d.code = lost ? base::codes::not_written : base::codes::written_by_moves;
    d.where = note.from;
    d.stack = s.stacks.sites(note.stack);
    d.text = "line " + std::to_string(note.line) + ": " + note.what +
             (lost ? " is not written" : " is written by its moves");
    return d;
}

/// What the written program does otherwise, at the place of the program that it comes from.
void complain(driver::Session& s, const driver::Proof& proof) {
    for (const compare::Difference& difference : proof.result->first) {
        const bool done = compare::is_done(difference.aspect);
        base::Diagnostic d;
        d.severity = done ? base::Severity::error : base::Severity::note;
        d.code = done ? base::codes::runs_otherwise : base::codes::written_by_moves;
        if (difference.in_a) d.where = *difference.in_a;
        if (difference.in_a) d.stack = s.stacks.sites(difference.stack_a);
        const std::string line =
            difference.in_b ? "line " + std::to_string(proof.session.sources.position(*difference.in_b).line) + ": "
                            : "";
        d.text = line + std::string(compare::name_of(difference.aspect)) + " first differs at move " +
                 std::to_string(difference.move) + ": " + difference.what;
        s.diagnostics.add(std::move(d));
    }
}

/// A control would stop at something, or a run found something else that is wrong, besides what is not written.
bool has_findings(const driver::Session& s) {
    return std::any_of(s.diagnostics.all().begin(), s.diagnostics.all().end(), [](const base::Diagnostic& d) {
        return base::kind_of(d.code) == base::CodeKind::finding && d.code != base::codes::not_written;
    });
}

/// Exit code of what was written, run again: 0 it does the same, 1 it does not, 3 it could not be held to it.
int proved(driver::Session& s, const driver::Translated& t, const write::Post& post, const Arguments& a) {
    compare::Tolerance tolerance;
    tolerance.length = a.same_place;
    const auto proof = driver::prove(t, post, with_outputs(a), s, tolerance);
    if (proof == nullptr || !proof->result) {
        std::fputs(proof == nullptr ? "not compared: the post names no control that can be read\n"
                                    : "not compared: what was written could not be run\n",
                   stderr);
        if (proof != nullptr) print_diagnostics(proof->session, base::Severity::warning);
        return 3;
    }
    const bool stops = has_findings(proof->session) && !has_findings(s);
    complain(s, *proof);
    const compare::Result& r = *proof->result;
    bool same = !stops;
    for (const compare::Difference& d : r.first) same = same && !compare::is_done(d.aspect);
    const int run = run_exit_code(proof->session);
    if (stops || (run == 3 && run_exit_code(s) != 3)) print_diagnostics(proof->session, base::Severity::warning);
    std::fprintf(stderr, "%s: %zu moves, run again as %s, within %g mm\n",
                 same ? "does the same" : "does not do the same", r.moves_b, post.control.c_str(), a.same_place);
    return run == 3 ? 3 : same ? 0 : 1;
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
    const auto note = [&](const write::Note& n) { s.diagnostics.add(complaint(n, s)); };
    const driver::Translated t = driver::translate(s, *post, program_name(s.program), a.same_place, note);
    const int proof = proved(s, t, *post, a);
    print_diagnostics(s);
    driver::OutputFile out(a.output);
    out.write(t.text);
    const bool written = may_write(a, s) && deliver(a.output, out) && !s.files->failed();
    const int run = run_exit_code(s);
    return !written || run == 2 ? 2 : run == 3 || proof == 3 ? 3 : std::max(run, proof);
}

}  // namespace obrys::cli
