#include "driver/ledger.hpp"

#include <algorithm>
#include <tuple>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "driver/not_run.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

std::size_t hash_of(const write::Note& n) {
    const std::size_t place = (std::size_t{n.from.file} << 40u) ^ (std::size_t{n.from.begin} << 8u) ^ n.from.end;
    return std::hash<std::string>()(n.what) ^ (place * 0x9E3779B97F4A7C15U) ^ static_cast<std::size_t>(n.fate);
}

/// Of what these are said of, nothing or not all was run.
bool leaves_out(std::string_view code) {
    for (const std::string_view one : {codes::syntax, codes::undefined_name, codes::unknown_word, codes::unsupported,
                                       codes::missing_subprogram, codes::budget, codes::unclosed, codes::not_run})
        if (code == one) return true;
    return false;
}

/// Of a function without effect on the path, "M88 has no effect …": it stands in what is written.
bool is_written(const Ledger& ledger, std::string_view said) {
    const std::string what = "function " + std::string(said.substr(0, said.find(' ')));
    return std::any_of(ledger.entries().begin(), ledger.entries().end(),
                       [&](const Ledger::Entry& e) { return e.note.what == what; });
}

/// How often a word without effect on the path stands in the programs, which is told once, where it stands first.
std::uint64_t times_of(const Session& s, const base::Diagnostic& said) {
    if (s.programs == nullptr) return 1;
    for (const auto& unit : s.programs->units())
        for (const program::Ignored& word : unit->ignored)
            if (word.where == said.where && said.text.starts_with(word.text + " ")) return word.count;
    return 1;
}

}  // namespace

bool Ledger::add(const write::Note& note, std::uint64_t times) {
    const std::size_t hash = hash_of(note);
    const auto [first, last] = index_.equal_range(hash);
    for (auto it = first; it != last; ++it) {
        const write::Note& there = entries_[it->second].note;
        if (there.fate != note.fate || there.what != note.what || !(there.from == note.from)) continue;
        entries_[it->second].times += times;
        return false;
    }
    index_.emplace(hash, entries_.size());
    entries_.push_back({note, times});
    lost_ = lost_ || note.fate == write::Fate::lost;
    return true;
}

void add_not_understood(Ledger& ledger, const Session& s, interp::Ending ending) {
    for (const base::Diagnostic& d : s.diagnostics.all()) {
        const bool said = d.code == codes::no_effect;                                              // and left out
        const bool describes = said && s.main != nullptr && s.main->traits->definitions_describe;  // CL data: the job
        if (describes || (said ? is_written(ledger, d.text) : !leaves_out(d.code))) continue;
        const bool uncalled = is_of_no_run(d);
        write::Note note;
        note.what = d.text;
        if (said || uncalled) note.fate = write::Fate::expanded;
        if (uncalled && d.text.ends_with(nothing_calls_it)) note.instead = "is left out";
        note.from = d.where;
        const std::uint64_t times = said ? times_of(s, d) : 1;
        const std::string counted = " (" + std::to_string(times) + " times)";  // a number of its own in the ledger
        if (times > 1 && note.what.ends_with(counted)) note.what.resize(note.what.size() - counted.size());
        static_cast<void>(ledger.add(note, times));
    }
    if (ending == interp::Ending::regular) return;
    write::Note note;
    note.what =
        ending == interp::Ending::alarm ? "what follows the alarm" : "what follows the limit that has ended the run";
    const auto& all = s.diagnostics.all();
    const auto cause = std::find_if(all.rbegin(), all.rend(), [](const base::Diagnostic& d) {
        return d.severity == base::Severity::error && d.code != codes::not_written;
    });
    if (cause != all.rend()) note.from = cause->where;
    static_cast<void>(ledger.add(note));
}

/// Of the main program among the session's sources.
static std::uint32_t file_of_main(const Session& s) { return s.main != nullptr ? s.main->file : 0; }

report::Ledger shown(const Ledger& ledger, const Session& s, const std::string& output) {
    report::Ledger out;
    out.program = s.program;
    out.control = s.control;
    out.output = output;
    for (const Ledger::Entry& e : ledger.entries()) {
        report::LedgerEntry entry;
        entry.what = e.note.what;
        entry.fate = e.note.fate;
        entry.times = e.times;
        const base::Span& from = e.note.from;
        if (from.file < s.sources.size()) entry.from = {s.sources[from.file].name, s.sources.position(from).line};
        if (e.note.line != 0) entry.to = {e.note.file.empty() ? out.output : e.note.file, e.note.line};
        if (e.note.fate == write::Fate::lost) entry.to.reset();
        out.entries.push_back(std::move(entry));
    }
    const auto place = [](const report::LedgerEntry& e) {
        return e.from ? std::tuple(e.from->file, e.from->line) : std::tuple(std::string(), std::uint64_t{0});
    };
    const std::uint32_t main_file = file_of_main(s);
    const std::string main = main_file < s.sources.size() ? s.sources[main_file].name : "";
    std::stable_sort(out.entries.begin(), out.entries.end(), [&](const auto& a, const auto& b) {
        const auto [file_a, line_a] = place(a);
        const auto [file_b, line_b] = place(b);
        return std::tuple(file_a != main, file_a, line_a) < std::tuple(file_b != main, file_b, line_b);
    });
    return out;
}

void add_texts(report::Ledger& ledger, const Ledger& of, const Session& s, std::vector<WrittenFile> outputs) {
    std::vector<std::uint32_t> files{file_of_main(s)};
    for (const Ledger::Entry& e : of.entries())
        if (std::find(files.begin(), files.end(), e.note.from.file) == files.end()) files.push_back(e.note.from.file);
    for (const std::uint32_t file : files) {
        if (file >= s.sources.size()) continue;
        s.sources.fetch(file);
        ledger.sources.push_back({s.sources[file].name, base::as_utf8(s.sources[file].text)});
    }
    for (WrittenFile& file : outputs) ledger.outputs.push_back({std::move(file.name), base::as_utf8(file.text)});
}

}  // namespace obrys::driver
