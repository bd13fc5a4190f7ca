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

/// Exit code of what was written, run again: 0 it does the same, 1 it does not, 3 it could not be held to it.
int proved(driver::Session& s, const driver::Translated& t, const write::Post& post, const Arguments& a) {
    compare::Tolerance tolerance;
    tolerance.length = a.same_place;
    const driver::Proved proved = driver::prove(t, post, with_outputs(a), s, tolerance);
    if (!proved.why_not.empty()) std::fprintf(stderr, "not compared: %s\n", proved.why_not.c_str());
    if (proved.run != nullptr && (proved.run_complains || !proved.why_not.empty()))
        print_diagnostics(*proved.run, base::Severity::warning);
    using driver::Proof;
    if (proved.why_not.empty())
        std::fprintf(stderr, "%s: %zu moves, run again as %s, within %g mm\n",
                     proved.differs                ? "does not do the same"
                     : proved.proof == Proof::same ? "does the same"
                                                   : "not fully compared",
                     proved.moves, post.control.c_str(), a.same_place);
    return proved.proof == Proof::same ? 0 : proved.proof == Proof::differs ? 1 : 3;
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
