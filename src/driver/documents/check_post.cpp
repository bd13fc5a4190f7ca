#include "driver/documents/check_post.hpp"
#include "driver/increments.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "compare/compare.hpp"
#include "cycles/expand/expand.hpp"
#include "driver/control.hpp"
#include "driver/translate.hpp"

namespace obrys::driver {

namespace {

constexpr double tried_tool_radius = 5;  ///< mm, of the tool that mills cycles
constexpr double tried_feed = 200, tried_speed = 1000;

struct WrittenSample {
    std::string text;
    std::size_t begin = 0, end = 0;  ///< of what the sample itself has written
    std::vector<write::Note> notes;
    std::vector<cl::Record> run;  ///< what the writer has made of the records, where it makes staircases of them
};

WrittenSample write_sample(const write::Post& post, const std::vector<cl::Record>& before,
                           const std::vector<cl::Record>& records, bool ends) {
    WrittenSample out;
    bool own = false;
    write::Output output;
    output.text = [&](std::string_view text) { out.text += text; };
    output.note = [&](write::Note n) {
        if (own && n.fate != write::Fate::mapped) out.notes.push_back(std::move(n));
    };
    output.run = [&](const cl::Record& r) { out.run.push_back(r); };
    write::Writer writer(post, "SAMPLE", output);
    for (const cl::Record& r : before) writer.take(r);
    writer.settle();
    out.begin = out.text.size();
    own = true;
    for (const cl::Record& r : records) writer.take(r);
    writer.settle();
    out.end = out.text.size();
    own = false;
    if (!ends) writer.take({cl::Stop{cl::StopKind::end}, {}, 0});
    writer.finish();
    return out;
}

bool turns_left(const write::Sample& sample) {
    return std::any_of(sample.values.begin(), sample.values.end(), [](const cl::CycleValue& v) {
        return v.role == cl::CycleRole::spindle_direction && v.value < 0;
    });
}

/// The moves of a cycle where the tool stands; false where no path is known with these values.
bool add_moves(const write::Sample& sample, const geom::Vec3& at, std::vector<cl::Step>& steps) {
    bool known = false;
    if (cycles::is_expanded(*sample.cycle)) {
        cycles::Situation s;
        s.at = at;
        s.tool_radius = tried_tool_radius, s.tool_corner_radius = 0, s.tool_point_angle = 118;
        s.spindle_speed = tried_speed, s.spindle_direction = turns_left(sample) ? -1 : 1, s.feed = tried_feed;
        s.tool_plunge_angle = 90, s.tool_cutting_length = 50;
        cycles::Expansion path = cycles::expand({*sample.cycle, sample.values}, s);
        known = path.ok() && !path.steps.empty();
        if (known)
            steps.insert(steps.end(), path.steps.begin() + static_cast<std::ptrdiff_t>(path.leads), path.steps.end());
    }
    if (!known) {
        steps.emplace_back(cl::Linear{at - geom::Vec3{0, 0, 5}, {0, 0, 1}, false});
        steps.emplace_back(cl::Linear{at, {0, 0, 1}, true});
    }
    steps.emplace_back(cl::CycleEnd{});
    steps.emplace_back(cl::Feed{tried_feed});
    return known;
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> out;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        out.emplace_back(line);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return out;
}

Outcome outcome_of(const TriedSample& t) {
    const auto has = [&](write::Fate fate) {
        return std::any_of(t.notes.begin(), t.notes.end(), [&](const write::Note& n) { return n.fate == fate; });
    };
    if (has(write::Fate::lost)) return Outcome::refused;
    if (has(write::Fate::expanded)) return Outcome::expanded;
    return t.blocks.empty() ? Outcome::nothing : Outcome::written;
}

/// The text run on its control; null where it cannot be run.
std::unique_ptr<Session> read_again(const write::Post& post, const std::string& text, compare::Path& path,
                                    bool turns_axes) {
    auto run = std::make_unique<Session>();
    Request request;
    request.input = "SAMPLE." + post.suffix;
    request.text = std::make_shared<const std::string>(text);
    request.control = post.control;
    request.prints_nowhere = true;
    request.machine = write::turns(post) ? "lathe-generic" : turns_axes ? "hermle-u1130" : "mill-generic";
    if (!open(request, *run)) return nullptr;
    static_cast<void>(interpret(*run, [&](const cl::Record& record) { path.take(record); }));
    return run;
}

/// What the reader says that keeps a comparison from being one.
/// The samples have no table of tools and no places of zeros: what is not known for that is
/// not known in what they ask for either.
std::vector<std::string> complaints_of(const Session& run, bool with_warnings) {
    std::vector<std::string> out;
    for (const base::Diagnostic& d : run.diagnostics.all()) {
        const bool warns = d.severity == base::Severity::warning && d.code != base::codes::unknown_value;
        const bool counts = d.severity == base::Severity::error || (with_warnings && warns);
        if (counts) out.push_back(d.text + " [" + std::string(d.code) + "]");
    }
    return out;
}

/// What reading back says about nothing but what stands around each sample.
struct Around {
    std::vector<cl::Record> before;
    std::vector<compare::Aspect> differ;
    bool is_unclear = true;
};

/// What the text is to do: the records, or what the writer has made of them.
void take_wanted(compare::Path& path, const write::Post& post, const WrittenSample& written,
                 const std::vector<cl::Record>& before, const std::vector<cl::Record>& records, bool ends) {
    if (post.staircase) {
        for (const cl::Record& r : written.run) path.take(r);
        return;
    }
    for (const cl::Record& r : before) path.take(r);
    for (const cl::Record& r : records) path.take(r);
    if (!ends) path.take({cl::Stop{cl::StopKind::end}, {}, 0});
}

Around around(const write::Post& post, double tool_radius, bool has_reader) {
    Around out;
    out.before = write::records_of(write::sample_begin(post, tool_radius));
    if (!has_reader) return out;
    const compare::Tolerance tolerance = as_control_counts(post, {}, 1);
    const bool by_axes = post.staircase.has_value();
    compare::Path wanted(tolerance.length, by_axes), read(tolerance.length, by_axes);
    const WrittenSample written = write_sample(post, out.before, {}, false);
    take_wanted(wanted, post, written, out.before, {}, false);
    const auto run = read_again(post, written.text, read, false);
    if (run == nullptr) return out;
    out.is_unclear = exit_code_of_run(*run) == 3;
    for (const compare::Difference& d : compare::compare(wanted, read, tolerance).first) out.differ.push_back(d.aspect);
    return out;
}

/// Of a cycle that was read back: how it is called, and roles that have no words and are the machine's, do not count.
/// True where it has such roles: then its moves are the machine's, too.
bool strip_unsaid(compare::Path& path, const write::Sample& sample) {
    bool stripped = false;
    for (std::size_t i = 0; i < path.cycles.size(); ++i) {
        compare::Item& item = path.cycles[i];
        auto* begin = std::get_if<cl::CycleBegin>(&item.step);
        if (begin == nullptr) continue;
        cl::Cycle cycle = *begin->cycle;
        const auto unsaid = [&](const cl::CycleValue& v) {
            return std::none_of(sample.values.begin(), sample.values.end(),
                                [&](const cl::CycleValue& s) { return s.role == v.role; });
        };
        stripped = std::erase_if(cycle.values, unsaid) > 0 || stripped;
        begin->cycle = cycle;
        begin->call = cl::CycleCall::single;
    }
    return stripped;
}

void read_sample(const write::Post& post, const Around& a, const std::vector<cl::Record>& records,
                 const WrittenSample& written, bool ends, bool moves_known, TriedSample& t) {
    double spread = 1;
    for (const cl::Record& r : records)
        if (const auto* frame = std::get_if<cl::Frame>(&r.step)) spread = std::max(spread, spread_of(*frame));
    const compare::Tolerance tolerance = as_control_counts(post, {}, spread);
    const bool by_axes = post.staircase.has_value();
    compare::Path wanted(tolerance.length, by_axes), read(tolerance.length, by_axes);
    take_wanted(wanted, post, written, a.before, records, ends);
    const bool turns_axes = std::any_of(records.begin(), records.end(), [](const cl::Record& r) {
        const cl::AxisEnds* along = cl::ends_of(r.step);
        return along != nullptr && !along->empty();
    });
    const auto run = read_again(post, written.text, read, turns_axes);
    t.read = ReadBack::unclear;
    if (run == nullptr) return t.differences.emplace_back("it cannot be read"), void();
    t.differences = complaints_of(*run, exit_code_of_run(*run) == 3 && !a.is_unclear);
    if (!t.differences.empty()) return;
    const bool folded = t.sample.cycle && t.outcome == Outcome::written;
    if (folded && strip_unsaid(read, t.sample)) moves_known = false;
    t.read = ReadBack::same;
    for (const compare::Difference& d : compare::compare(wanted, read, tolerance).first) {
        if (std::find(a.differ.begin(), a.differ.end(), d.aspect) != a.differ.end()) continue;
        if (folded && !moves_known && d.aspect != compare::Aspect::cycles) continue;
        if (d.is_done || folded)
            t.read = ReadBack::differs;
        else if (t.read == ReadBack::same)
            t.read = ReadBack::said;
        t.differences.push_back(std::string(compare::name_of(d.aspect)) + ": " + d.what);
    }
}

TriedSample tried(const write::Post& post, const write::Sample& sample, const Around& a, bool has_reader) {
    TriedSample t;
    t.sample = sample;
    std::vector<cl::Step> steps = sample.steps;
    bool known = true;
    if (sample.cycle) known = add_moves(sample, write::sample_place(write::turns(post)), steps);
    std::vector<cl::Record> records = write::records_of(steps);
    constexpr std::uint32_t behind = 1000;  // blocks of their own
    for (cl::Record& r : records) r.from.begin += behind, r.from.end += behind;
    const auto* stop = std::get_if<cl::Stop>(&records.back().step);
    const bool ends = stop != nullptr && stop->kind == cl::StopKind::end;
    WrittenSample written = write_sample(post, a.before, records, ends);
    t.blocks = lines_of(std::string_view(written.text).substr(written.begin, written.end - written.begin));
    t.notes = written.notes;
    t.outcome = outcome_of(t);
    const bool reads =
        has_reader && t.outcome != Outcome::refused && !(sample.moves_itself() && t.outcome == Outcome::written);
    if (reads) read_sample(post, a, records, written, ends, known, t);
    return t;
}

}  // namespace

std::size_t TriedPost::count(Outcome o) const {
    return static_cast<std::size_t>(
        std::count_if(samples.begin(), samples.end(), [&](const TriedSample& t) { return t.outcome == o; }));
}

std::size_t TriedPost::count(ReadBack r) const {
    return static_cast<std::size_t>(
        std::count_if(samples.begin(), samples.end(), [&](const TriedSample& t) { return t.read == r; }));
}

TriedPost try_post(const write::Post& post) {
    TriedPost out;
    out.has_reader = find_control(post.control) != nullptr;
    const Around plain = around(post, 0, out.has_reader), milling = around(post, tried_tool_radius, out.has_reader);
    for (const write::Sample& s : write::record_samples(post))
        out.samples.push_back(tried(post, s, plain, out.has_reader));
    for (const write::Sample& s : write::cycle_samples(post))
        out.samples.push_back(tried(post, s, milling, out.has_reader));
    return out;
}

std::string_view name_of(Outcome o) {
    constexpr std::array<std::string_view, 4> names{"written", "expanded", "refused", "nothing"};
    return names[static_cast<std::size_t>(o)];
}

std::string_view name_of(ReadBack r) {
    constexpr std::array<std::string_view, 5> names{"none", "same", "said-otherwise", "differs", "unclear"};
    return names[static_cast<std::size_t>(r)];
}

}  // namespace obrys::driver
