#pragma once
/// What was read is run: a program and its job, in a folder of this process alone, opened and run as the command line
/// does it. What must hold of every stream and every result, whatever the program says, is required here.

#include <fcntl.h>
#include <sys/file.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "check/group.hpp"
#include "cl/text.hpp"
#include "cl/verify.hpp"
#include "driver/check_program.hpp"
#include "report/report.hpp"
#include "write/writer.hpp"

namespace obrys::fuzz {

inline void require(bool holds, std::string_view what) {
    if (holds) return;
    std::cerr << "does not hold: " << what << '\n';
    std::abort();
}

/// The first of a row of folders that no running process holds, so that a run alone always has the same name in its
/// texts and the same seed leads to the same inputs. Emptied when the process ends.
class Folder {
public:
    Folder() {
        for (int n = 0; lock_ < 0; ++n) {
            require(n < 1000, "a folder for the files can be had");
            path_ = std::filesystem::temp_directory_path() / ("obrys-fuzz-" + std::to_string(n));
            std::filesystem::create_directories(path_);
            hold();
        }
    }
    ~Folder() {
        std::error_code ignored;
        for (const auto& entry : std::filesystem::directory_iterator(path_, ignored))
            std::filesystem::remove_all(entry.path(), ignored);
        close(lock_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::string put(std::string_view name, std::string_view text) const {
        const std::filesystem::path path = path_ / name;
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }

private:
    void hold() {
        lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (lock_ < 0 || flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
        close(lock_);
        lock_ = -1;
    }
    std::filesystem::path path_;
    int lock_ = -1;
};
inline const Folder& folder() {
    static const Folder own;
    return own;
}

/// One thread: which branches an input takes, and with it what is tried next, is then the same in every run.
inline const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);

/// Limits of every run here, as a job says them.
inline constexpr std::string_view limits = "[budget]\nblocks = 2000\nloop_passes = 1000\nseconds = 20\n";

inline constexpr std::string_view tools = R"([[tool]]
number = 1
kind = "end-mill"
diameter = 6.0
length = 40.0
cutting_length = 20.0
holder = [{ diameter = 30.0, length = 30.0 }]
[[tool]]
number = 2
kind = "drill"
diameter = 5.0
length = 50.0
[[tool]]
number = 3
kind = "tap"
diameter = 6.0
pitch = 1.0
length = 50.0
)";

/// The text of a job: the program of that name on a control and machine, with the tools above.
inline std::string job_of(std::string_view name, std::string_view control, std::string_view machine) {
    const auto line = [](std::string_view key, std::string_view value) {
        return std::string(key) + " = \"" + std::string(value) + "\"\n";
    };
    return line("program", name) + line("control", control) + line("machine", machine) + std::string(limits) +
           std::string(tools);
}
inline std::string mill_job(std::string_view name, std::string_view control) {
    return job_of(name, control, "mill-generic");
}

/// `job` is the text of a job file that names the program `name`. False where they cannot be used at all.
inline bool open(driver::Session& session, std::string_view name, std::string_view text, std::string_view job) {
    folder().put(name, text);
    driver::Request request;
    request.input = folder().put("case.job.toml", job);
    return driver::open(request, session);
}

inline void check_span(const base::Sources& sources, const base::Span& s) {
    if (s.file < sources.size())
        require(s.begin <= s.end && s.end <= sources[s.file].text.size(), "a span lies in its text");
}

inline void check_diagnostics(const driver::Session& s) {
    for (const base::Diagnostic& d : s.diagnostics.all()) {
        check_span(s.sources, d.where);
        (void)base::render(d, s.sources);
    }
}

inline bool complains(const driver::Session& s) {
    for (const base::Diagnostic& d : s.diagnostics.all())
        if (d.severity == base::Severity::error) return true;
    return false;
}

/// Written by every shipped post: whatever the stream holds, each line is whole, and what is lost is said.
inline void check_written(const std::vector<cl::Record>& records) {
    static const std::vector<write::Post> posts = [] {
        std::vector<write::Post> all;
        for (const std::string& name : write::shipped_post_names()) {
            base::Sources sources;
            base::Diagnostics diagnostics;
            const std::uint32_t file = sources.add(name, std::string(write::shipped_post(name)->text));
            all.push_back(*write::read_post(file, sources, diagnostics));
        }
        return all;
    }();
    const write::Post& post = posts[records.size() % posts.size()];
    write::Output output;
    output.text = [&](std::string_view line) { require(line.ends_with(post.line_end), "a line is whole"); };
    output.note = [](const write::Note& n) { require(!n.what.empty(), "a note says something"); };
    write::Writer writer(post, "CASE", output);
    for (const cl::Record& record : records) writer.take(record);
    writer.finish();
}

/// The stream keeps its own rules, stands in its texts and comes back from its text form as it was.
inline void check_stream(const driver::Session& s, const std::vector<cl::Record>& records) {
    check_written(records);
    base::Diagnostics faults;
    cl::Verifier verifier(faults, {}, &s.stacks);
    for (const cl::Record& r : records) {
        verifier(r);
        check_span(s.sources, r.from);
        for (const base::Span& site : s.stacks.sites(r.stack)) check_span(s.sources, site);
    }
    for (const base::Diagnostic& d : faults.all()) require(false, base::render(d, s.sources));
    const std::string text = cl::to_text(records);
    base::Sources sources;
    base::Diagnostics diagnostics;
    const std::uint32_t file = sources.add("STREAM", text);
    require(cl::to_text(cl::read_text(sources, file, diagnostics)) == text, "the stream's text reads back");
    for (const base::Diagnostic& d : diagnostics.all()) require(false, base::render(d, sources));
}

/// Runs what was opened and gives its stream.
inline std::vector<cl::Record> run(driver::Session& session) {
    std::vector<cl::Record> records;
    const auto sink = [&](const cl::Record& r) { records.push_back(r); };
    const interp::Outcome outcome = driver::interpret(session, sink);
    if (outcome.ending == interp::Ending::alarm) require(complains(session), "an alarm is said");
    check_diagnostics(session);
    return records;
}

/// Reads, runs and verifies; the stream without places, and what was complained about.
inline std::string run_text(std::string_view name, std::string_view text, std::string_view job) {
    driver::Session session;
    if (!open(session, name, text, job)) {
        check_diagnostics(session);
        return "not opened";
    }
    std::vector<cl::Record> records = run(session);
    check_stream(session, records);
    for (cl::Record& r : records) r.from = {}, r.stack = 0;
    return cl::to_text(records);
}

inline void check_findings(const driver::Session& s, const check::Result& r) {
    std::uint64_t move = 0;
    for (const check::Finding& f : r.findings) {
        if (check::is_placed(f.where)) check_span(s.sources, f.where);
        for (const base::Span& site : f.stack) check_span(s.sources, site);
        for (const check::Amount& a : f.amounts) require(std::isfinite(a.value), "amounts are finite");
        if (f.code == "rest-material" || !f.move) continue;  // known when all is done
        require(*f.move >= move && *f.move < r.stats.moves, "findings stand in the order of their moves");
        move = *f.move;
    }
    std::size_t members = 0;
    for (const check::Group& g : check::groups_of(r)) members += g.members.size();
    require(members == r.findings.size(), "every finding is in one group");
}

inline void check_figures(const check::Result& r) {
    require(r.stats.rapid_moves + r.stats.feed_moves == r.stats.moves, "moves are rapid or feed");
    require(std::isfinite(r.stats.feed_length_mm) && std::isfinite(r.stats.rapid_length_mm), "lengths are finite");
    if (!r.before || !r.after) return;
    const double slack = 1e-6 * (1 + r.before->volume_mm3);
    require(r.after->volume_mm3 >= -slack && r.after->volume_mm3 <= r.before->volume_mm3 + slack,
            "the stock does not grow");
}

/// Numbers and words of a JSON text.
inline std::string outside_quotes(std::string_view json) {
    std::string out;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (quoted && json[i] == '\\')
            ++i;
        else if (json[i] == '"')
            quoted = !quoted;
        else if (!quoted)
            out += json[i];
    }
    return out;
}

/// Checks what was opened as `obrys check` does.
inline void check_case(std::string_view name, std::string_view text, std::string_view job) {
    driver::Session session;
    if (!open(session, name, text, job)) return check_diagnostics(session);
    driver::MillingRequest request;
    request.memory_bytes = 2e8;
    const driver::Checked checked = driver::check_program(session, 100, request);
    const check::Result& r = checked.result;
    check_diagnostics(session);
    require(r.verdict == check::verdict_of(r), "the verdict follows from the lists");
    if (complains(session)) require(r.verdict != check::Verdict::clean, "what has errors is not clean");
    check_findings(session, r);
    check_figures(r);
    const report::Subject subject{
        session.sources, r, checked.setup, session.stacks, session.program, session.control, {}, {}};
    const std::string shown = report::to_text(subject), json = report::to_json(subject);
    require(!shown.empty() && !json.empty(), "reports are written");
    const std::string figures = outside_quotes(json);
    for (const std::string_view word : {"nan", "inf"})
        require(figures.find(word) == std::string::npos, "no figure of the report is nan");
}

}  // namespace obrys::fuzz
