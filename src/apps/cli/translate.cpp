/// obrys translate.

#include "driver/translate.hpp"

#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "milled.hpp"
#include "session.hpp"

namespace obrys::cli {

namespace {

/// "PART" of "subs/PART.MPF".
std::string program_name(const std::string& path) { return driver::fs::path(path).stem().string(); }

/// Runs again what was written, and says how that went.
driver::Proved proved(driver::Session& s, const driver::Translated& t, const write::Post& post, const Arguments& a) {
    compare::Tolerance tolerance;
    tolerance.length = a.same_place;
    driver::Proved proved = driver::prove(t, post, with_outputs(a), s, tolerance);
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
    return proved;
}

/// Where the program and its subprograms go. In a folder, subprograms may stand in files of their own.
struct Target {
    bool folder = false;
    std::string main;  ///< path; empty: standard output
    [[nodiscard]] std::string of(const std::string& name) const {
        return (driver::fs::path(main).parent_path() / name).generic_string();
    }
};

bool is_folder(const std::string& output) {
    std::error_code error;
    return !output.empty() && (output.back() == '/' || driver::fs::is_directory(output, error));
}

Target target_of(const Arguments& a, const std::string& name, const write::Post& post) {
    if (!a.into_folder) return {false, a.output};
    return {true, (driver::fs::path(a.output) / (name + "." + post.suffix)).generic_string()};
}

/// Whether all the files may be written, now that they are known.
bool may_write_all(const Arguments& a, const driver::Session& s, const Target& target, const driver::Translated& t) {
    std::vector<driver::Wanted> wanted{{"--output", target.main.empty() ? "-" : target.main}};
    for (const driver::WrittenFile& file : t.files) wanted.push_back({"--output", target.of(file.name)});
    if (!a.ledger.empty()) wanted.push_back({"--ledger", a.ledger});
    const auto refused = driver::refusals(wanted, driver::inputs_of(s), a.request.force);
    for (const std::string& why : refused) std::fprintf(stderr, "obrys: %s\n", why.c_str());
    return refused.empty();
}

/// Each of them whole before any of them stands in its place.
bool deliver_all(const Target& target, const driver::Translated& t) {
    std::vector<std::pair<std::string, std::unique_ptr<driver::OutputFile>>> files;
    const auto add = [&](const std::string& path, const std::string& text) {
        files.emplace_back(path, std::make_unique<driver::OutputFile>(path));
        files.back().second->write(text);
    };
    add(target.main, t.text);
    for (const driver::WrittenFile& file : t.files) add(target.of(file.name), file.text);
    return std::all_of(files.begin(), files.end(), [](const auto& f) { return deliver(f.first, *f.second); });
}

report::Ledger ledger_of(const driver::Session& s, const driver::Translated& t, const write::Post& post,
                         const Target& target, const std::string& proof) {
    std::vector<driver::WrittenFile> outputs{
        {driver::is_standard_output(target.main) ? "-" : driver::fs::path(target.main).filename().string(), t.text}};
    outputs.insert(outputs.end(), t.files.begin(), t.files.end());
    report::Ledger ledger = driver::shown(t.ledger, s, std::move(outputs));
    ledger.post = post.name.empty() ? post.title : post.name;
    ledger.proof = proof;
    return ledger;
}

bool deliver_ledger(const std::string& path, const report::Ledger& ledger) {
    if (path.empty()) return true;
    return deliver(path, path.ends_with(".json")   ? report::ledger_json(ledger)
                         : path.ends_with(".html") ? report::ledger_html(ledger)
                                                   : report::ledger_text(ledger));
}

}  // namespace

int translate(const Arguments& arguments) {
    Arguments a = arguments;
    a.into_folder = is_folder(a.output);
    driver::Session s;
    if (!open(a, s)) return 2;
    const std::optional<write::Post> post = driver::find_post(a.to, s);
    if (!post) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    driver::TranslateOptions options;
    options.name = program_name(s.program);
    options.same_place = a.same_place;
    const Target target = target_of(a, options.name, *post);
    options.files = target.folder;
    const driver::Translated t = driver::translate(s, *post, options);
    const driver::Proved proof = proved(s, t, *post, a);
    print_diagnostics(s);
    const int run = driver::exit_code_of_run(s);
    const bool lost = t.ledger.has_lost() || proof.differs, refused = lost && !a.accept_loss;
    report::Ledger ledger = ledger_of(s, t, *post, target,
                                      proof.differs                                    ? "differs"
                                      : proof.proof == driver::Proof::same && run != 3 ? "equal"
                                                                                       : "not compared");
    ledger.written = !refused && run != 2;
    std::fprintf(stderr, "ledger: %s\n", report::summary(ledger).c_str());
    if (refused)
        std::fputs("obrys: nothing is written, since something is lost or differs; --accept-loss writes it\n", stderr);
    if (!may_write_all(a, s, target, t)) return 2;
    const bool written = (!ledger.written || deliver_all(target, t)) && deliver_ledger(a.ledger, ledger);
    if (!written || s.files->failed() || run == 2) return 2;
    if (refused) return 1;
    return run == 3 || proof.proof == driver::Proof::not_compared ? 3 : run == 1 || lost ? 1 : 0;
}

}  // namespace obrys::cli
