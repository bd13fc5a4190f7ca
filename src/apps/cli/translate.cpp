/// obrys translate.

#include "driver/translate.hpp"

#include <cstdio>

#include "base/number.hpp"
#include "commands.hpp"
#include "driver/stream_file.hpp"
#include "session.hpp"
#include "translate_kept.hpp"
#include "translated.hpp"

namespace obrys::cli {

namespace {

/// "PART" of "subs/PART.MPF".
std::string program_name(const std::string& path) { return driver::fs::path(path).stem().string(); }

/// How it went, for people.
void print(const driver::Settled& settled, const write::Post& post, double chord) {
    const auto& [t, proved] = settled;
    if (!proved.why_not.empty()) std::fprintf(stderr, "not compared: %s\n", proved.why_not.c_str());
    if (proved.run != nullptr && (proved.run_complains || !proved.why_not.empty()))
        print_diagnostics(*proved.run, base::Severity::warning);
    const std::string chords =
        t.chords.empty() ? "" : " but for curves as straight lines within " + base::shortest(chord) + " mm";
    if (proved.why_not.empty())
        std::fprintf(stderr, "%s%s%s: %zu moves, run again as %s, within %g mm%s%s%s%s\n",
                     t.ledger.has_lost() && !proved.differs ? "what is written " : "", verdict_of(proved),
                     t.stairs.empty() ? chords.c_str() : " as the staircases", proved.moves, post.control.c_str(),
                     proved.within, of_increments(proved).c_str(),
                     proved.planes_rounded ? ", tilted planes as the words of their angles hold them" : "",
                     proved.feeds_rounded ? ", feeds as their words hold them" : "",
                     proved.speeds_rounded ? ", speeds as their words hold them" : "");
}

report::Ledger ledger_of(const driver::Session& s, const driver::Translated& t, const write::Post& post,
                         const Target& target, const driver::Proved& proved, int run) {
    report::Ledger ledger = driver::shown(t.ledger, s, name_of(target));
    ledger.post = post.name.empty() ? post.title : post.name;
    ledger.post_control = post.control;
    const bool known = proved.proof == driver::Proof::same && run != 3;
    ledger.proof = driver::name_of(proved.differs ? driver::Proof::differs
                                   : known        ? driver::Proof::same
                                                  : driver::Proof::not_compared);
    return ledger;
}

int translate_by_motion(driver::Session& s, const write::Post& post, const Arguments& a, const std::string& name) {
    const Target target = target_of(a, name, post);
    compare::Tolerance tolerance;
    tolerance.length = a.same_place;
    const driver::Settled settled =
        driver::translate(s, post, with_outputs(a), {name, target.folder, a.chord}, tolerance);
    const driver::Translated& t = settled.translated;
    const driver::Proved& proof = settled.proved;
    std::fputs(t.tools.c_str(), stderr);
    if (!t.stairs.empty()) std::fprintf(stderr, "%s\n", t.stairs.c_str());
    print(settled, post, a.chord);
    print_diagnostics(s);
    const int run = driver::exit_code_of_translation(s);
    const bool lost = t.ledger.has_lost() || proof.differs, refused = lost && !a.accept_loss;
    report::Ledger ledger = ledger_of(s, t, post, target, proof, run);
    ledger.written = !refused && run != 2;
    if (shows_texts(a.ledger)) {
        std::vector<driver::WrittenFile> outputs{{ledger.output, *t.text}};
        outputs.insert(outputs.end(), t.files.begin(), t.files.end());
        add_texts(ledger, t.ledger, s, std::move(outputs));
    }
    std::fprintf(stderr, "ledger: %s\n", report::summary(ledger).c_str());
    if (refused)
        std::fputs("obrys: nothing is written, since something is lost or differs; --accept-loss writes it\n", stderr);
    if (!may_write_all(a, s, target, t, a.ledger)) return 2;
    if (!deliver_all(target, t, a.ledger, ledger) || (s.files != nullptr && s.files->failed()) || run == 2) return 2;
    if (refused) return 1;
    return run == 3 || proof.proof == driver::Proof::not_compared ? 3 : run == 1 || lost ? 1 : 0;
}

}  // namespace

/// A program, or a CL stream in its text form; false, with what is wrong printed, where it cannot be read.
static bool opened(const Arguments& a, driver::Session& s) {
    if (!driver::is_stream(a.request.input)) return open(a, s);
    if (a.keep)
        return std::fputs("obrys: --keep writes statements, and a CL stream has none: leave it out\n", stderr), false;
    if (driver::open_stream(a.request, s)) return true;
    print_diagnostics(s, base::Severity::warning);
    return false;
}

int translate(const Arguments& arguments) {
    Arguments a = arguments;
    a.into_folder = is_folder(a.output);
    a.request.keeps_remarks = a.to != "canon";
    driver::Session s;
    if (!opened(a, s)) return 2;
    const std::optional<write::Post> post =
        driver::find_post(a.to, s, a.keep ? driver::PostFor::statements : driver::PostFor::moves);
    if (!post) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    if (post->is_canon && s.main == nullptr) {
        std::fputs("obrys: canonical calls follow the words of a program, and a CL stream has none\n", stderr);
        return 2;
    }
    if (a.keep && (post->staircase || post->tape != write::Tape::none)) {
        std::fputs("obrys: --keep writes statements, neither staircases nor punched tape: leave it out\n", stderr);
        return 2;
    }
    const std::string name = driver::said_name_in(*post, program_name(s.program), s);
    return a.keep ? translate_kept(s, *post, a, name) : translate_by_motion(s, *post, a, name);
}

}  // namespace obrys::cli
