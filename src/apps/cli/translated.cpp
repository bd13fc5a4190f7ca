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

namespace {

struct Document {
    std::string path, text;
    std::unique_ptr<driver::OutputFile> file;
};

/// Each of them whole before any of them stands in its place. Standard output, which cannot be taken back, is the first
/// that gets its own, when nothing else can fail any more.
bool deliver_all(std::vector<Document> all) {
    const auto goes_out = [](const Document& d) { return driver::is_standard_output(d.path); };
    std::stable_partition(all.begin(), all.end(), goes_out);
    bool good = true;
    for (Document& d : all) {
        d.file = std::make_unique<driver::OutputFile>(d.path);
        if (goes_out(d)) continue;
        d.file->write(d.text);
        if (!d.file->flush()) good = deliver(d.path, *d.file);  // which says why
    }
    for (Document& d : all) {
        if (good && goes_out(d)) d.file->write(d.text);
        good = good && deliver(d.path, *d.file);
    }
    return good;
}

std::string ledger_text(const std::string& path, const report::Ledger& ledger) {
    return path.ends_with(".json") ? report::ledger_json(ledger)
           : shows_texts(path)     ? report::ledger_html(ledger)
                                   : report::ledger_text(ledger);
}

}  // namespace

bool deliver_all(const Target& target, const driver::Translated& t, const std::string& ledger_path,
                 const report::Ledger& ledger) {
    std::vector<Document> all;
    const auto add = [&](const std::string& path, const std::string& text) {
        all.push_back({path, t.tape == write::Tape::none ? text : write::punched(text, t.tape), nullptr});
    };
    if (ledger.written) add(target.main, *t.text);
    if (ledger.written)
        for (const driver::WrittenFile& file : t.files) add(target.of(file.name), file.text);
    if (!ledger_path.empty()) all.push_back({ledger_path, ledger_text(ledger_path, ledger), nullptr});
    return deliver_all(std::move(all));
}

std::string name_of(const Target& target) {
    return driver::is_standard_output(target.main) ? "-" : driver::fs::path(target.main).filename().string();
}

bool shows_texts(const std::string& ledger) { return ledger.ends_with(".html"); }

std::string of_increments(const driver::Proved& p) {
    if (p.increment == 0) return "";
    return " (the control counts in increments of " + base::shortest(p.increment) + " mm)";
}

const char* verdict_of(const driver::Proved& p) {
    return p.differs ? "does not do the same" : p.proof == driver::Proof::same ? "does the same" : "not fully compared";
}

}  // namespace obrys::cli
