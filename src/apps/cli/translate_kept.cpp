#include "translate_kept.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/number.hpp"
#include "driver/keep.hpp"
#include "session.hpp"
#include "translated.hpp"

namespace obrys::cli {

namespace {

int code_of(driver::Proof p) { return p == driver::Proof::same ? 0 : p == driver::Proof::differs ? 1 : 3; }

std::string listed(const std::vector<std::string>& set) {
    std::string out;
    for (const std::string& one : set) out += (out.empty() ? "" : " ") + one;
    return out;
}

/// The written program with its own values and with others; the worst of all.
driver::Proof proved_with_all(driver::Session& s, const driver::Kept& kept, const write::Post& post, const Arguments& a,
                              std::vector<driver::KeptRun>& runs) {
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
        std::string within;
        if (p.increment > 0)
            within = "within " + base::shortest(std::round(p.within * 1e7) / 1e7) + " mm" + of_increments(p) + ", ";
        std::fprintf(stderr, "%s: %zu moves, %s%s%s%s\n", verdict_of(p), p.moves, within.c_str(),
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

}  // namespace

int translate_kept(driver::Session& s, const write::Post& post, const Arguments& a, const std::string& name) {
    const auto language = driver::find_language(a.to, s);
    if (!language) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    const Target target = target_of(a, name, post);
    const driver::Kept kept = driver::keep(s, *language, name);
    for (const rewrite::Note& note : kept.rewritten.notes) s.diagnostics.add(driver::complaint_of(note));
    const bool lost = kept.rewritten.loses();
    std::vector<driver::KeptRun> runs;
    driver::Proof proof = driver::Proof::not_compared;
    if (!lost || a.accept_loss) {
        print_names(kept);
        proof = proved_with_all(s, kept, post, a, runs);
    }
    const bool refused = (lost || proof == driver::Proof::differs) && !a.accept_loss;
    print_diagnostics(s);
    const int run = driver::exit_code_of_translation(s);
    report::Ledger ledger = driver::ledger(s, kept, name_of(target), runs);
    ledger.post = post.name.empty() ? post.title : post.name;
    ledger.post_control = post.control;
    ledger.proof = driver::name_of(proof);
    ledger.written = !refused && run != 2;
    std::fprintf(stderr, "ledger: %s\n", report::summary(ledger).c_str());
    if (refused)
        std::fputs("obrys: nothing is written, since something is lost or differs; --accept-loss writes it\n", stderr);
    // Beside the program, where nobody says where: compare finds it there.
    const bool beside = a.ledger.empty() && ledger.written && !driver::is_standard_output(target.main);
    const std::string path = beside ? driver::ledger_beside(target.main) : a.ledger;
    if (!may_write_all(a, s, target, kept.translated, path)) return 2;
    if (!deliver_all(target, kept.translated, path, ledger) || s.files->failed() || run == 2) return 2;
    if (refused) return run == 3 ? 3 : 1;
    return run == 3 ? 3 : std::max({run, code_of(proof), lost ? 1 : 0});
}

}  // namespace obrys::cli
