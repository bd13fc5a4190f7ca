/// What was written, run again and held against the program.

#include <algorithm>
#include <functional>
#include <set>

#include "base/codes.hpp"
#include "driver/compare_programs.hpp"
#include "driver/control.hpp"
#include "driver/increments.hpp"
#include "driver/not_run.hpp"
#include "driver/program_tools.hpp"
#include "driver/translate.hpp"
#include "write/lesser.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

/// What the written program does otherwise, at the place of the program that it comes from.
void complain_of(Session& s, const compare::Result& result, const Session& run) {
    for (const compare::Difference& difference : result.first) {
        const bool done = difference.is_done;
        // A cycle or a call in the place of another, as the ledger says: it would be told in two controls' words.
        const bool by_ledger =
            difference.aspect == compare::Aspect::cycles || difference.aspect == compare::Aspect::parts;
        if (by_ledger && difference.in_a && difference.in_b) continue;
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
}

/// Of several tools, which are not of one length.
void complain_of_lengths(Session& s, const compare::Result& result) {
    if (result.lengths)
        warn_of(
            s, *result.lengths,
            "the program compensates the length of none of its tools, and what is written does that of each: whether "
            "the zeros are right for that is not known",
            "have the program compensate lengths, or set the zeros anew for tools that are measured");
}

/// At what feed such a move goes nobody knows, so that no other is the same.
void complain_of_feed(Session& s, const std::optional<cl::Record>& move) {
    if (!move) return;
    base::Diagnostic d;
    d.severity = base::Severity::warning;
    d.code = codes::unknown_value;
    d.where = move->from;
    d.stack = s.stacks.sites(move->stack);
    d.text = "a move at feed, and no feed is programmed: at what feed it goes is not known, so it is not compared";
    d.remedy = "program F before it";
    s.diagnostics.add(std::move(d));
}

bool runs_otherwise(const compare::Result& result) {
    return std::any_of(result.first.begin(), result.first.end(),
                       [](const compare::Difference& d) { return d.is_done; });
}

/// In what the numbers of words say.
bool differs_by_rounding(const compare::Result& result) {
    using compare::Aspect;
    return result.of(Aspect::motion) != nullptr || result.of(Aspect::feed) != nullptr ||
           result.of(Aspect::spindle) != nullptr;
}

/// A control would stop at something, or a run found something else that is wrong, besides what is not written.
bool has_findings(const Session& s) {
    return std::any_of(s.diagnostics.all().begin(), s.diagnostics.all().end(), [](const base::Diagnostic& d) {
        return base::kind_of(d.code) == base::CodeKind::finding && d.code != codes::not_written;
    });
}

/// What the program says of its tools without setting it on a control holds for what was written from it, too.
void take_described_tools(const Session& of, shop::Job& job) {
    if (of.main == nullptr || !of.main->traits->definitions_describe) return;
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

Proved hold_against(const Translated& translated, const write::Post& post, Request request, const Session& s,
                    const compare::Tolerance& wanted_tolerance, const OwnValues& values) {
    const LookedThrough program = translated.does ? look_through(*translated.does) : LookedThrough{};
    const compare::Tolerance tolerance = as_control_counts(post, wanted_tolerance, program.spread);
    Proved out;
    out.why_not = "the post names no control that can be read";
    if (find_control(post.control) == nullptr) return out;
    out.why_not = "what was written could not be run";
    const bool guessed = request.machine.empty() && s.job.machine.more_axes;
    const Request wanted = request_of(translated, post, std::move(request), s, values);
    const auto run = [&](const compare::Tolerance& t) {
        out.run = std::make_unique<Session>();
        Request again = wanted;
        again.folders = std::make_shared<Folders>(wanted.folders->storage());
        if (!open(again, *out.run)) return false;
        take_described_tools(s, out.run->job);
        if (guessed) out.run->job.machine.more_axes = true;  // as of the program: nobody has said which it has
        compare::Tolerance within = t;
        within.same_control = s.control == post.control;
        within.joins_freely = within.same_control && joins_freely(s.control);
        within.is_written_from_a = true;
        within.is_axis_by_axis = post.staircase.has_value();
        out.compared = compare_with(*translated.does, *out.run, within);
        return true;
    };
    if (!run(tolerance)) return out;
    out.within = tolerance.length;
    out.increment = post.increment;
    if (const compare::Result first = out.compared; differs_by_rounding(first)) {
        const compare::Tolerance wide = as_words_hold(post, program, tolerance);
        if (!run(wide)) return out;
        const auto settled = [&](compare::Aspect a) { return first.of(a) != nullptr && out.compared.is_equal(a); };
        if (settled(compare::Aspect::motion)) out.within = std::max(wide.length, wide.on_arcs);
        out.planes_rounded = wide.turn > 0 && settled(compare::Aspect::motion);
        out.feeds_rounded = settled(compare::Aspect::feed);
        out.speeds_rounded = settled(compare::Aspect::spindle);
    }
    out.why_not.clear();
    out.moves = out.compared.moves_b;
    if (post.staircase && post.staircase->units > 0) out.within = std::max(out.within, 0.5 / post.staircase->units);
    const bool stops = has_findings(*out.run) && !has_findings(s), unknown = exit_code_of_translation(*out.run) == 3;
    out.run_complains = stops || (unknown && exit_code_of_translation(s) != 3);
    out.differs = runs_otherwise(out.compared) || stops;
    const bool stays = out.compared.moves_a == 0 && out.moves == 0;
    out.without_feed = program.without_feed;
    out.proof = unknown || stays || out.without_feed || out.compared.lengths || out.compared.turns ? Proof::not_compared
                : out.differs                                                                      ? Proof::differs
                                                                                                   : Proof::same;
    return out;
}

namespace {

/// The move of the program from which on what was written does something else; nothing: it does the same, or that is
/// not known.
std::optional<std::size_t> differs_at(const Proved& proved) {
    std::optional<std::size_t> out;
    for (const compare::Difference& d : proved.compared.first)
        if (d.is_done && (!out || d.move < *out)) out = d.move;
    return out;
}

/// How many records of a stream lie before and in its move of that number, as moves are compared.
std::size_t records_to(std::size_t move, const cl::Recording& stream, double same_place) {
    compare::Path path(same_place);
    cl::Recording::Playback playback(stream);
    std::size_t records = 0;
    while (path.moves.size() <= move && playback.step([&](const cl::Record& record) { path.take(record); })) {
        ++records;
        path.forget(path.moves.size() - std::min<std::size_t>(path.moves.size(), 1), path.all_items());
    }
    return records;
}

/// The form by which the last cycle before a move was written.
const UsedForm* form_before(const Translated& t, std::size_t move, double same_place) {
    const std::size_t records = records_to(move, *t.does, same_place);
    const UsedForm* last = nullptr;
    for (const UsedForm& form : t.forms)
        if (form.record <= records) last = &form;
    return last;
}

/// The post without that form: such cycles are written by the next form that says them, or by their moves.
void leave_out(write::Post& post, const UsedForm& form) {
    if (!form.form) {
        post.hooked_cycles.erase(form.kind);
        return;
    }
    std::vector<write::CycleForm>& forms = post.cycles.at(form.kind);
    forms.erase(forms.begin() + static_cast<std::ptrdiff_t>(*form.form));
}

/// What was written compensates radii, and something of it runs otherwise or is lost: the tool's path may stand there
/// instead.
bool may_go_by_tool_path(const Settled& settled) {
    const std::vector<Ledger::Entry>& entries = settled.translated.ledger.entries();
    const bool compensates = std::any_of(entries.begin(), entries.end(), [](const Ledger::Entry& e) {
        return e.note.fate == write::Fate::mapped && e.note.what == write::radius_compensation;
    });
    return compensates && (settled.proved.differs || settled.translated.ledger.has_lost());
}

/// The post without its words of radius compensation and of ways onto contours.
write::Post by_tool_path(write::Post post) {
    using write::Command;
    const auto clear = [&](Command first, Command last) {
        for (auto c = static_cast<std::size_t>(first); c <= static_cast<std::size_t>(last); ++c)
            post.commands[c].clear();
    };
    clear(Command::compensation_left, Command::compensation_off_alone);
    clear(Command::onto_tangent_line, Command::off_arc_and_line);
    return post;
}

/// A reference point and the coordinates of its place have one word between them: whether they are the same counts.
bool lacks_a_word_for_homes(const write::Post& post) {
    using write::Command;
    return !post.has(Command::machine_home) || !post.has(Command::machine_coordinates);
}

/// A way of writing a program, and the post by which that was done.
struct Version {
    write::Post post;
    Settled settled;
    std::set<std::size_t> by_moves{};  ///< cycles, counted from 0
};

/// Ways of writing the same with less of the control's own, the likeliest first.
std::vector<write::Post> lesser_posts(const Version& now, std::size_t differs, double same_place) {
    std::vector<write::Post> out;
    if (const UsedForm* form = form_before(now.settled.translated, differs, same_place)) {
        out.push_back(now.post);
        leave_out(out.back(), *form);
    }
    if (write::Post standing = now.post; write::leave_out_turns(standing)) out.push_back(std::move(standing));
    if (write::Post frameless = now.post; write::leave_out_frames(frameless)) out.push_back(std::move(frameless));
    return out;
}

/// It does the same for longer, and loses nothing that the other does not lose.
bool is_better(const Settled& a, const Settled& b) {
    const std::optional<std::size_t> at = differs_at(a.proved), before = differs_at(b.proved);
    return (!at || (before && *at > *before)) && (b.translated.ledger.has_lost() || !a.translated.ledger.has_lost());
}

}  // namespace

Settled translate(Session& session, const write::Post& post, const Request& wanted, const TranslateOptions& options,
                  const compare::Tolerance& tolerance) {
    constexpr int most_attempts = 16;
    constexpr std::size_t most_alone = 6;  // cycles by their moves, before all of a form are
    Request request = wanted;
    request.homes_at_zero = session.homes_at_zero = lacks_a_word_for_homes(post);
    Version best{post, {write_program(session, post, options), {}}};
    if (best.settled.translated.ending == interp::Ending::budget) {
        best.settled.proved.why_not = "the program does not end within the limits of its run";
        tell(session, best.settled.translated);
        return std::move(best.settled);
    }
    best.settled.proved = hold_against(best.settled.translated, post, request, session, tolerance);
    /// Whether it is better so; then it counts.
    const auto better_with = [&](const write::Post& other, const std::set<std::size_t>& by_moves) {
        Settled next{write_again(best.settled.translated, other, options, by_moves), {}};
        next.proved = hold_against(next.translated, other, request, session, tolerance);
        if (!is_better(next, best.settled)) return false;
        best = {other, std::move(next), by_moves};
        return true;
    };
    const auto better_by = [&](const write::Post& other) { return better_with(other, best.by_moves); };
    std::optional<UsedForm> alone;  // the cycle that was written by its moves last
    const auto better_without_cycle = [&](std::size_t differs) {
        const UsedForm* form = form_before(best.settled.translated, differs, tolerance.length);
        if (form == nullptr || (alone && form->is_next_of(*alone)) || best.by_moves.size() >= most_alone) return false;
        alone = *form;
        std::set<std::size_t> by_moves = best.by_moves;
        by_moves.insert(form->cycle);
        return better_with(write::Post(best.post), by_moves);
    };
    const bool once = post.staircase || post.magazine;
    if (const auto straight =
            options.chord > 0 && !once ? with_chords(best.settled.translated, options.chord) : std::nullopt) {
        best.settled = {write_again(*straight, post, options, {}), {}};
        best.settled.proved = hold_against(best.settled.translated, post, request, session, tolerance);
    }
    if (!once && may_go_by_tool_path(best.settled)) static_cast<void>(better_by(by_tool_path(post)));
    for (int attempt = 0; attempt < most_attempts && !once; ++attempt) {
        const std::optional<std::size_t> at = differs_at(best.settled.proved);
        if (!at) break;
        if (better_without_cycle(*at)) continue;
        const std::vector<write::Post> lesser = lesser_posts(best, *at, tolerance.length);
        if (std::none_of(lesser.begin(), lesser.end(), better_by)) break;  // it is something else that differs
    }
    tell(session, best.settled.translated);
    if (best.settled.proved.run != nullptr)
        complain_of(session, best.settled.proved.compared, *best.settled.proved.run);
    complain_of_lengths(session, best.settled.proved.compared);
    complain_of_turns(session, best.settled.proved.compared);
    complain_of_feed(session, best.settled.proved.without_feed);
    if (best.settled.proved.run != nullptr && best.settled.proved.compared.moves_a == 0 &&
        best.settled.proved.moves == 0)
        say_that_nothing_moves(session.diagnostics, session.main);
    return std::move(best.settled);
}

Proved prove(const Translated& translated, const write::Post& post, Request request, Session& s,
             const compare::Tolerance& tolerance, const OwnValues& values) {
    Proved out = hold_against(translated, post, std::move(request), s, tolerance, values);
    if (out.run != nullptr) complain_of(s, out.compared, *out.run);
    complain_of_lengths(s, out.compared);
    complain_of_turns(s, out.compared);
    complain_of_feed(s, out.without_feed);
    return out;
}

}  // namespace obrys::driver
