#include "driver/choose.hpp"

#include "base/codes.hpp"
#include "driver/machine_guess.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/nearest.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

void assume(Session& s, std::string text, std::string remedy = {}) {
    s.diagnostics.add({base::Severity::note, codes::assumption, nowhere, std::move(text), std::move(remedy), {}, {}});
}

std::string read_as(const Guess& guess) {
    std::string text = "read as " + std::string(guess.control->name);
    for (std::size_t i = 0; i < guess.signs.size() && i < 4; ++i) text += (i == 0 ? ": " : ", ") + guess.signs[i];
    if (guess.next != nullptr && guess.next_likelihood > 0) text += "; next likely: " + std::string(guess.next->name);
    return text;
}

/// What speaks for the control that is taken, and what would be different with another one.
void say_guess(Session& s, const Guess& guess, const base::Span& where, int certain) {
    const std::string remedy = "name the control with --control or in the job", name(guess.control->name);
    const auto doubt = [&](std::string text) {
        s.diagnostics.add({base::Severity::warning, codes::unknown_value, where, std::move(text), remedy, {}, {}});
    };
    if (!guess.foreign.empty())
        doubt("this looks like a program of " + guess.foreign + ", which obrys does not read: it is " + read_as(guess));
    else if (guess.likelihood < certain)
        doubt("nothing in this text says for which control it is: it is " + read_as(guess));
    else if (!guess.difference.empty())
        doubt("this text does not say for certain for which control it is: it is " + read_as(guess) + "; " +
              guess.difference);
    else if (!guess.by_suffix)
        assume(s, "no control is named: " + read_as(guess), remedy);
}

}  // namespace

bool known_control(Session& s, const std::string& name, const base::Span& where) {
    if (name.empty() || find_control(name) != nullptr) return true;
    complain(s.diagnostics, codes::job_value, where, "there is no control \"" + name + "\"",
             shop::words_remedy(name, controls(), "controls that can be read"));
    return false;
}

const Control* choose_control(Session& s, const Request& request, std::uint32_t file, std::optional<bool> turns) {
    constexpr int foreign = 3,
                  certain = 30;  // of 100: corpus programs of other controls reach 29, own ones 53 and more
    s.control = !request.control.empty() ? request.control : s.job.control;
    if (!s.control.empty()) return find_control(s.control);
    const base::Source& source = s.sources[file];
    const Guess guess = guess_control(source.text, source.name, turns);
    s.control = guess.control->name;
    const base::Span where{file, 0, 0};
    if (guess.likelihood < foreign) {
        complain(s.diagnostics, codes::job_value, where,
                 "this looks like a program for another control than can be read",
                 "controls that can be read: " + shop::joined(controls()) + "; --control NAME reads it all the same");
        return nullptr;
    }
    say_guess(s, guess, where, certain);
    return guess.control;
}

void choose_machine(Session& s, const Request& request) {
    const MachineGuess guess = guess_machine(*s.main);
    const bool lathe_job = s.job.machine.kind == shop::MachineKind::lathe;
    const bool told = s.has_job && (lathe_job || s.job.solid_stock || s.job.solid_part);
    const bool drives_lathes = s.main->traits->guessed_machine != program::GuessedMachine::mill;
    const bool turning = told ? lathe_job && drives_lathes : guess.turning;
    const std::string generic = turning ? "lathe-generic" : "mill-generic";
    shop::use_machine(s.job, *shop::shipped_machine(generic));
    s.job.machine.more_axes = true;
    const bool diameters = turning && !s.main->traits->radius_at_start, words = s.main->traits->has_diameter_words;
    const std::string others = told ? "" : list_of_signs(guess.against, s.sources);
    const std::string signs = !told && (turning || !others.empty()) ? list_of_signs(guess.signs, s.sources) : "";
    const std::string for_it = signs.empty() ? "" : " for " + signs;
    const std::string against = others.empty() ? "" : " in spite of " + others;
    assume(s,
           "no machine is named: " + generic + " is taken" + for_it + against +
               (diameters ? ", X words are diameters" + std::string(words ? " until DIAMOF" : "") : ""),
           "name one with --machine or in the job");
    const bool told_x = request.diameter || s.job.defaults.diameter_programming;
    if (told || told_x || guess.doubtful == base::Span{}) return;
    s.diagnostics.add({base::Severity::warning,
                       codes::unknown_value,
                       guess.doubtful,
                       "whether X is a diameter or not depends on the machine, and the program does not say which it "
                       "is for: X words are taken as " +
                           std::string(diameters ? "diameters" : "they stand"),
                       std::string("name the machine with --machine or in a job") +
                           (words ? ", or write DIAMON or DIAMOF before the first X" : ""),
                       {},
                       {}});
}

void settle_diameters(Session& s, const Request& request) {
    bool& diameters = s.job.machine.defaults.diameter_programming;
    const program::Traits& t = *s.main->traits;
    const bool lathe = s.job.machine.kind == shop::MachineKind::lathe;
    if (!diameters || (lathe && !t.radius_at_start)) return;
    const std::string asked = request.diameter ? "--diameter" : "diameter_programming";
    if (t.has_diameter_words)
        return assume(s, asked + " on a mill: X words are taken as diameters, half of each is run",
                      "leave it out where X of this mill is a length");
    diameters = false;
    const bool here = request.diameter.has_value() || s.job.defaults.diameter_programming.has_value();
    if (t.radius_at_start && !here) return;  // the machine file is for other controls, too
    if (t.radius_at_start)
        return assume(s,
                      asked + " does not apply: this control begins with radii, X words are diameters behind G7 only",
                      "write G7 in the program");
    assume(s, asked + " does not apply: it is for lathes, and the machine is a mill; X words are run as they stand");
}

}  // namespace obrys::driver
