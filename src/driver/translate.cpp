#include "driver/translate.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "driver/canon.hpp"
#include "driver/compare_programs.hpp"
#include "driver/control.hpp"
#include "driver/files.hpp"
#include "driver/program_tools.hpp"
#include "shop/nearest.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

/// Names that a call may mean, in the order in which they are tried.
std::vector<std::string> candidates(const std::string& name, shop::MachineKind kind) {
    if (kind == shop::MachineKind::lathe) return {name + "-lathe", name};
    return {name};
}

/// Names of programs hold no blanks; those of files may.
std::string without_blanks(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

/// A post whose control is none that can be read: what is written by it could not be run. Staircases are for mills.
std::optional<write::Post> checked(std::optional<write::Post> post, std::uint32_t file, Session& s) {
    if (post && post->staircase && s.job.machine.kind == shop::MachineKind::lathe) {
        complain(s.diagnostics, codes::job_value, {file, 0, 0},
                 "this post is for mills that move one axis at a time, and the machine turns");
        return std::nullopt;
    }
    if (!post || post->control.empty() || find_control(post->control) != nullptr) return post;
    complain(s.diagnostics, codes::job_value, {file, 0, 0}, "there is no control \"" + post->control + '"',
             shop::words_remedy(post->control, controls(), "controls that can be read"));
    return std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> load_post(const std::string& name, Session& s) {
    if (name.ends_with(".toml")) return load(*s.storage, name, s.sources, s.diagnostics);
    const std::string& wanted = name == "same" ? s.control : name;
    for (const std::string& candidate : candidates(wanted, s.job.machine.kind))
        if (const write::ShippedPost* post = write::shipped_post(candidate))
            return s.sources.add(candidate + ".toml", std::string(post->text));
    complain(s.diagnostics, codes::file_missing, nowhere, "there is no post called '" + name + "'",
             "name one of: " + shop::joined(write::shipped_post_names()) + ", or a file (.toml)");
    return std::nullopt;
}

std::optional<write::Post> find_post(const std::string& name, Session& s) {
    const std::optional<std::uint32_t> file = load_post(name, s);
    const auto beside_it = [&](const std::string& other, const base::Span& where) {
        return load(*s.storage, beside(name, other), s.sources, s.diagnostics, where);
    };
    if (!file) return std::nullopt;
    if (!name.ends_with(".toml")) return checked(write::read_post(*file, s.sources, s.diagnostics), *file, s);
    return checked(write::read_post(*file, s.sources, s.diagnostics, beside_it), *file, s);
}

base::Diagnostic complaint_of(const write::Note& note, const Session& s) {
    base::Diagnostic d;
    const bool lost = note.fate == write::Fate::lost;
    d.severity = lost ? base::Severity::error : base::Severity::note;
    d.code = lost ? codes::not_written : codes::written_by_moves;
    d.where = note.in_post.value_or(note.from);
    if (!note.in_post) d.stack = s.stacks.sites(note.stack);
    const std::string file = note.file.empty() ? "" : note.file + ", ";
    d.text = file + "line " + std::to_string(note.line) + ": " + note.what +
             (lost ? " is not written" : " " + std::string(note.instead));
    return d;
}

/// The run tells its settings where the session was opened for that (Request::canon).
static Translated translate_to_canon(Session& session, Translated out) {
    const auto write = [&](std::string_view text) { out.text += text; };
    const interp::Outcome outcome =
        print_canon(session, write, false, [&](const cl::Record& record) { out.does.take(record); });
    add_not_understood(out.ledger, session, outcome.ending);
    return out;
}

/// Characters that the code of the tape does not have.
static void note_characters(Translated& out, const write::Post& post, const std::function<void(write::Note)>& note) {
    out.tape = post.tape;
    if (post.tape == write::Tape::none) return;
    for (const write::MissingCharacter& c : write::missing_characters(out.text, post.tape))
        note({write::Fate::lost,
              "'" + c.character + "', which the " + std::string(write::name_of(post.tape)) + " code of tapes has not,",
              nowhere, 0, c.line});
}

/// What is written calls tools by their places in the magazine, as the writer's own gives them.
static cl::Record by_its_place(const cl::Record& record, write::Magazine& magazine) {
    cl::Record placed = record;
    auto* change = std::get_if<cl::ToolChange>(&placed.step);
    if (change == nullptr || change->number == 0) return placed;
    std::string why;
    if (const write::MagazineSlot* slot = magazine.take(change->number, why)) change->number = slot->place;
    return placed;
}

Translated translate(Session& session, const write::Post& post, const TranslateOptions& options) {
    Translated out;
    if (post.is_canon) return translate_to_canon(session, std::move(out));
    write::Output output;
    output.text = [&](std::string_view text) { out.text += text; };
    output.note = [&](const write::Note& note) {
        if (out.ledger.add(note) && note.fate != write::Fate::mapped)
            session.diagnostics.add(complaint_of(note, session));
    };
    if (options.files)
        output.file = [&](const std::string& file, std::string_view text) {
            out.files.push_back({file, std::string(text)});
        };
    std::optional<write::Magazine> magazine;
    if (post.magazine) magazine.emplace(*post.magazine);
    const auto goes = [&](const cl::Record& record) {
        out.does.take(magazine ? by_its_place(record, *magazine) : record);
    };
    if (post.staircase) output.run = goes;
    write::Writer writer(post, without_blanks(options.name), output);
    const interp::Outcome outcome = interpret(session, [&](const cl::Record& record) {
        writer.take(record);
        if (!post.staircase) goes(record);
    });
    writer.finish();
    if (writer.stairs() != nullptr) out.stairs = write::text_of(*writer.stairs(), *post.staircase);
    if (writer.magazine() != nullptr) out.tools = write::text_of(writer.magazine()->slots());
    note_characters(out, post, output.note);
    add_not_understood(out.ledger, session, outcome.ending);
    return out;
}

namespace {

/// What the written program does otherwise, at the place of the program that it comes from; true where it does.
bool complain(Session& s, const compare::Result& result, const Session& run) {
    bool done_otherwise = false;
    for (const compare::Difference& difference : result.first) {
        const bool done = compare::is_done(difference.aspect);
        done_otherwise = done_otherwise || done;
        base::Diagnostic d;
        d.severity = done ? base::Severity::error : base::Severity::note;
        d.code = done ? codes::runs_otherwise : codes::written_by_moves;
        if (difference.in_a) d.where = *difference.in_a;
        if (difference.in_a) d.stack = s.stacks.sites(difference.stack_a);
        const std::string line =
            difference.in_b ? "line " + std::to_string(run.sources.position(*difference.in_b).line) + ": " : "";
        d.text = line + std::string(compare::name_of(difference.aspect)) + " first differs at move " +
                 std::to_string(difference.move) + ": " + difference.what;
        s.diagnostics.add(std::move(d));
    }
    return done_otherwise;
}

/// A control would stop at something, or a run found something else that is wrong, besides what is not written.
bool has_findings(const Session& s) {
    return std::any_of(s.diagnostics.all().begin(), s.diagnostics.all().end(), [](const base::Diagnostic& d) {
        return base::kind_of(d.code) == base::CodeKind::finding && d.code != codes::not_written;
    });
}

/// What the program says of its tools without setting it on a control holds for what was written from it, too.
void take_described_tools(const Session& of, shop::Job& job) {
    if (!of.main->traits->definitions_describe) return;
    base::Diagnostics said_of_the_program;
    for (shop::Tool& tool : program_tools(*of.main, job.tools, said_of_the_program))
        job.tools.push_back(std::move(tool));
}

/// The request for what was written from a program.
Request request_of(const Translated& translated, const write::Post& post, Request request, const Session& of,
                   const OwnValues& values) {
    request.text = translated.text;
    request.set = values.set;
    request.given = values.given;
    request.control = post.control;
    std::shared_ptr<const Storage> storage = of.storage;
    if (!translated.files.empty()) {
        auto files = std::make_shared<Memory>(storage);
        for (const WrittenFile& file : translated.files)
            files->put(fs::path(of.program).parent_path() / file.name, file.text);
        storage = std::move(files);
    }
    request.folders = std::make_shared<Folders>(std::move(storage));  // those of the request belong to another thread
    if (request.machine.empty() && of.job.machine.more_axes)          // nobody has named it
        request.machine = of.job.machine.kind == shop::MachineKind::lathe ? "lathe-generic" : "mill-generic";
    return request;
}

}  // namespace

std::string_view name_of(Proof proof) {
    return proof == Proof::same ? "equal" : proof == Proof::differs ? "differs" : "not compared";
}

Proved prove(const Translated& translated, const write::Post& post, Request request, Session& s,
             const compare::Tolerance& tolerance, const OwnValues& values) {
    Proved out;
    out.why_not = "the post names no control that can be read";
    if (find_control(post.control) == nullptr) return out;
    out.run = std::make_unique<Session>();
    out.why_not = "what was written could not be run";
    const bool guessed = request.machine.empty() && s.job.machine.more_axes;
    if (!open(request_of(translated, post, std::move(request), s, values), *out.run)) return out;
    out.why_not.clear();
    take_described_tools(s, out.run->job);
    if (guessed) out.run->job.machine.more_axes = true;  // as of the program: nobody has said which it has
    compare::Tolerance within = tolerance;
    within.same_control = s.control == post.control;
    within.is_written_from_a = true;
    const compare::Result result = compare_with(translated.does, *out.run, within);
    out.moves = result.moves_b;
    out.within = tolerance.length;
    if (post.staircase && post.staircase->units > 0) out.within = std::max(out.within, 0.5 / post.staircase->units);
    const bool stops = has_findings(*out.run) && !has_findings(s), unknown = exit_code_of_run(*out.run) == 3;
    out.run_complains = stops || (unknown && exit_code_of_run(s) != 3);
    out.differs = complain(s, result, *out.run) || stops;
    out.proof = unknown ? Proof::not_compared : out.differs ? Proof::differs : Proof::same;
    return out;
}

}  // namespace obrys::driver
