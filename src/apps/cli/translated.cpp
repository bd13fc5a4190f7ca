#include "translated.hpp"

#include <algorithm>
#include <cstdio>

#include "base/number.hpp"
#include "milled.hpp"

namespace obrys::cli {

std::string Target::of(const std::string& name) const {
    return (driver::fs::path(main).parent_path() / name).generic_string();
}

bool is_folder(const std::string& output) {
    std::error_code error;
    return !output.empty() && (output.back() == '/' || driver::fs::is_directory(output, error));
}

Target target_of(const Arguments& a, const std::string& name, const write::Post& post) {
    if (!a.into_folder) return {false, a.output};
    return {true, (driver::fs::path(a.output) / (name + "." + post.suffix)).generic_string()};
}

/// Whether all the files may be written, now that they are known.
bool may_write_all(const Arguments& a, const driver::Session& s, const Target& target, const driver::Translated& t,
                   const std::string& ledger) {
    std::vector<driver::Wanted> wanted{{"--output", target.main.empty() ? "-" : target.main}};
    for (const driver::WrittenFile& file : t.files) wanted.push_back({"--output", target.of(file.name)});
    if (!ledger.empty()) wanted.push_back({"--ledger", ledger});
    const auto refused = driver::refusals(wanted, driver::inputs_of(s), a.request.force);
    for (const std::string& why : refused) std::fprintf(stderr, "obrys: %s\n", why.c_str());
    return refused.empty();
}

/// Each of them whole before any of them stands in its place.
bool deliver_all(const Target& target, const driver::Translated& t) {
    std::vector<std::pair<std::string, std::unique_ptr<driver::OutputFile>>> files;
    const auto add = [&](const std::string& path, const std::string& text) {
        files.emplace_back(path, std::make_unique<driver::OutputFile>(path));
        files.back().second->write(t.tape == write::Tape::none ? text : write::punched(text, t.tape));
    };
    add(target.main, t.text);
    for (const driver::WrittenFile& file : t.files) add(target.of(file.name), file.text);
    return std::all_of(files.begin(), files.end(), [](const auto& f) { return deliver(f.first, *f.second); });
}

std::string name_of(const Target& target) {
    return driver::is_standard_output(target.main) ? "-" : driver::fs::path(target.main).filename().string();
}

bool shows_texts(const std::string& ledger) { return ledger.ends_with(".html"); }

bool deliver_ledger(const std::string& path, const report::Ledger& ledger) {
    if (path.empty()) return true;
    return deliver(path, path.ends_with(".json") ? report::ledger_json(ledger)
                         : shows_texts(path)     ? report::ledger_html(ledger)
                                                 : report::ledger_text(ledger));
}

std::string of_increments(const driver::Proved& p) {
    if (p.increment == 0) return "";
    return " (half the control's increment of " + base::shortest(p.increment) + " mm)";
}

const char* verdict_of(const driver::Proved& p) {
    return p.differs ? "does not do the same" : p.proof == driver::Proof::same ? "does the same" : "not fully compared";
}

}  // namespace obrys::cli
