#include "driver/translate.hpp"

#include <algorithm>
#include <set>

#include "base/codes.hpp"
#include "base/memory.hpp"
#include "base/text.hpp"
#include "driver/canon.hpp"
#include "driver/control.hpp"
#include "driver/files.hpp"
#include "driver/stream_file.hpp"
#include "motion/chords.hpp"
#include "shop/home.hpp"
#include "shop/nearest.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

/// Names that a call may mean, in the order in which they are tried.
std::vector<std::string> candidates(const std::string& name, shop::MachineKind kind) {
    if (kind == shop::MachineKind::lathe) return {name + "-lathe", name};
    return {name};
}

std::vector<std::string> posts_for_lathes() {
    std::vector<std::string> out = write::shipped_post_names();
    std::erase_if(out, [](const std::string& name) { return !name.ends_with("-lathe"); });
    return out;
}

/// A post whose control is none that can be read: what is written by it could not be run. Staircases are for mills.
std::optional<write::Post> checked(std::optional<write::Post> post, std::uint32_t file, Session& s, PostFor way) {
    const bool for_mills = post && (post->staircase || (post->for_mills_alone && way == PostFor::moves));
    if (for_mills && s.job.machine.kind == shop::MachineKind::lathe) {
        complain(s.diagnostics, codes::job_value, {file, 0, 0},
                 std::string("this post is for mills") + (post->staircase ? " that move one axis at a time" : "") +
                     ", and the machine turns",
                 "posts for lathes: " + shop::joined(posts_for_lathes()));
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

write::LoadText beside_post(const std::string& name, Session& s) {
    if (!name.ends_with(".toml")) return {};
    return [name, &s](const std::string& other, const base::Span& where) {
        return load(*s.storage, beside(name, other), s.sources, s.diagnostics, where);
    };
}

std::optional<write::Post> find_post(const std::string& name, Session& s, PostFor way) {
    const std::optional<std::uint32_t> file = load_post(name, s);
    if (!file) return std::nullopt;
    std::optional<write::Post> post =
        checked(write::read_post(*file, s.sources, s.diagnostics, beside_post(name, s)), *file, s, way);
    const std::optional<double>& per_mm = s.job.machine.control.increments_per_mm;
    if (post && post->increment > 0 && per_mm) write::count_in(*post, 1 / *per_mm);
    return post;
}

std::string name_in(const write::Post& post, std::string name) {
    std::string out;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        const bool is_plain = base::is_letter(c) || base::is_digit(c) || c == '_' || c == '-' || c == '.';
        const bool goes_on = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // of a letter of several bytes
        if (post.name_is_plain && !is_plain && goes_on) continue;
        out += c == ' ' || (post.name_is_plain && !is_plain) ? '_' : c;
    }
    if (post.longest_name != 0 && out.size() > post.longest_name) out.resize(post.longest_name);
    return out;
}

std::string said_name_in(const write::Post& post, const std::string& name, Session& s) {
    std::string out = name_in(post, name);
    std::string blank = name;
    std::replace(blank.begin(), blank.end(), ' ', '_');
    if (out == blank) return out;
    base::Diagnostic d;
    d.severity = base::Severity::note;
    d.code = codes::written_by_moves;
    if (s.main != nullptr) d.where = {s.main->file, s.main->begin, s.main->begin};
    d.text = "the program is called " + out + ": the control takes no name as " + name;
    s.diagnostics.add(std::move(d));
    return out;
}

base::Diagnostic complaint_of(const write::Note& note, const Session& s) {
    base::Diagnostic d;
    const bool lost = note.fate == write::Fate::lost;
    d.severity = lost ? base::Severity::error : base::Severity::note;
    d.code = lost ? codes::not_written : !note.remedy.empty() ? codes::assumption : codes::written_by_moves;
    d.remedy = note.remedy;
    d.where = note.in_post.value_or(note.from);
    if (!note.in_post) d.stack = s.stacks.sites(note.stack);
    const std::string file = note.file.empty() ? "" : note.file + ", ";
    if (note.line != 0) d.text = file + "line " + std::to_string(note.line) + ": ";
    d.text += write::sentence_of(note);
    return d;
}

namespace {

/// The session was opened for it (Request::stand_alone): its calls are those of that interpreter.
Translated translate_to_canon(Session& session) {
    Translated out;
    const auto write = [&](std::string_view text) { out.text->append(text); };
    cl::Recording does;
    const interp::Outcome outcome =
        print_canon(session, write, false, [&](const cl::Record& record) { does.take(record); });
    out.does = std::make_shared<const cl::Recording>(std::move(does));
    out.ending = outcome.ending, out.repeats = outcome.repeats;
    return out;
}

/// A text about as long as that which it is written from has its room at once: nothing is copied when it grows.
void make_room(std::string& text, std::size_t written_from) {
    constexpr std::size_t large = 2 * base::large_page;
    if (written_from < large) return;
    text.reserve(written_from + written_from / 4);
    base::prefer_large_pages(text.data(), text.capacity());
}

/// Characters that the code of the tape does not have.
void note_characters(Translated& out, const write::Post& post) {
    out.tape = post.tape;
    if (post.tape == write::Tape::none) return;
    for (const write::MissingCharacter& c : write::missing_characters(*out.text, post.tape))
        static_cast<void>(out.ledger.add(
            {write::Fate::lost,
             "'" + c.character + "', which the " + std::string(write::name_of(post.tape)) + " code of tapes has not,",
             nowhere, 0, c.line}));
}

/// What is written calls tools by their places in the magazine, as the writer's own gives them.
cl::Record by_its_place(const cl::Record& record, write::Magazine& magazine) {
    cl::Record placed = record;
    auto* change = std::get_if<cl::ToolChange>(&placed.step);
    if (change == nullptr || change->number == 0) return placed;
    std::string why;
    if (const write::MagazineSlot* slot = magazine.take(change->number, why)) change->number = slot->place;
    return placed;
}

/// Where a form of the post stands among those for its kind of cycle.
UsedForm used(const write::FoldedBy& by, const write::Post& post, std::size_t record) {
    UsedForm out{record, by.cycle, by.kind, std::nullopt};
    if (by.form != nullptr) out.form = static_cast<std::size_t>(by.form - post.cycles.at(by.kind).data());
    return out;
}

/// Writes a stream, which `stream` hands to a sink. `run`: what the post makes of it where those are other moves
/// (staircases); null: nobody asks.
void write_stream(Translated& out, const write::Post& post, const TranslateOptions& options,
                  const std::function<void(cl::Sink)>& stream, std::function<void(const cl::Record&)> run = nullptr,
                  const std::set<std::size_t>& by_moves = {}) {
    write::Output output;
    output.text = [&](std::string_view text) { out.text->append(text); };
    output.note = [&](const write::Note& note) { static_cast<void>(out.ledger.add(note)); };
    if (options.files)
        output.file = [&](const std::string& file, std::string_view text) {
            out.files.push_back({file, std::string(text)});
        };
    std::size_t taken = 0;
    output.folded = [&](const write::FoldedBy& by) { out.forms.push_back(used(by, post, taken)); };
    output.by_moves = by_moves;
    output.homes = out.homes;
    output.run = std::move(run);
    write::Writer writer(post, name_in(post, options.name), output);
    stream([&](const cl::Record& record) {
        ++taken;
        writer.take(record);
    });
    out.begins_anew = out.repeats && writer.begin_anew();
    writer.finish();
    if (writer.stairs() != nullptr) out.stairs = write::text_of(*writer.stairs(), *post.staircase);
    if (writer.magazine() != nullptr) out.tools = write::text_of(writer.magazine()->slots());
    note_characters(out, post);
}

write::Homes homes_of(const Session& s) {
    write::Homes out;
    for (std::size_t k = 0; k < out.at.size(); ++k) {
        const shop::Home home = shop::home_of(s.job.machine, std::string_view("XYZ").substr(k, 1), s.homes_at_zero);
        out.at[k] = home.at, out.assumed[k] = home.is_assumed;
    }
    return out;
}

bool has_remarks(const Session& s) {
    const auto has = [](const auto& unit) { return !unit->remarks.empty(); };
    return s.programs != nullptr && std::any_of(s.programs->units().begin(), s.programs->units().end(), has);
}

/// Remarks of statements that no run comes to, or from which nothing of its own comes.
void note_missing_remarks(Translated& out, const Session& session) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> written;
    cl::Recording::Playback stream(*out.does);
    const auto take = [&](const cl::Record& record) {
        if (std::holds_alternative<cl::Comment>(record.step)) written.emplace(record.from.file, record.from.begin);
    };
    while (stream.step(take)) {
    }
    for (const auto& unit : session.programs->units())
        for (const program::Remark& remark : unit->remarks) {
            write::Note note;
            note.fate = write::Fate::expanded;
            note.what = "a comment of what is not run, or of a contour,";
            note.from = unit->span(unit->statements[remark.statement]);
            note.instead = "is left out";
            if (written.emplace(note.from.file, note.from.begin).second) static_cast<void>(out.ledger.add(note));
        }
}

/// The post has no word for that.
void lose_beginning_anew(Session& session, Ledger& ledger) {
    write::Note note;
    note.what =
        std::string(session.main->traits->repeats_program) + ", with which the program begins anew without end,";
    note.from = {session.main->file, session.main->end, session.main->end};
    base::Diagnostic d;
    d.severity = base::Severity::error;
    d.code = codes::not_written;
    d.where = note.from;
    d.text = note.what + " is not written: what is there ends behind one pass";
    session.diagnostics.add(std::move(d));
    static_cast<void>(ledger.add(note));
}

}  // namespace

Translated write_program(Session& session, const write::Post& post, const TranslateOptions& options) {
    // A loop's passes are all written: what would be longer than any control's memory most likely never ends.
    constexpr std::uint64_t most_written = 1'000'000;
    if (shop::Budgets& limits = session.job.budgets; !limits.bounds_loops) limits.loop_passes = most_written;
    if (post.is_canon) return translate_to_canon(session);
    Translated out;
    out.homes = homes_of(session);
    make_room(*out.text, session.sources[session.main != nullptr ? session.main->file : 0].text.size());
    cl::Recording does;
    std::optional<write::Magazine> magazine;
    if (post.magazine) magazine.emplace(*post.magazine);
    const auto keep = [&](const cl::Record& record) { does.take(magazine ? by_its_place(record, *magazine) : record); };
    const auto stream = [&](cl::Sink sink) {
        const interp::Outcome outcome = stream_of(session, [&](const cl::Record& record) {
            if (!post.staircase) keep(record);
            sink(record);
        });
        out.ending = outcome.ending, out.repeats = outcome.repeats;
    };
    write_stream(out, post, options, stream, post.staircase ? std::function<void(const cl::Record&)>(keep) : nullptr);
    out.does = std::make_shared<const cl::Recording>(std::move(does));
    return out;
}

Translated write_again(const Translated& first, const write::Post& post, const TranslateOptions& options,
                       const std::set<std::size_t>& by_moves) {
    Translated out;
    out.ending = first.ending, out.repeats = first.repeats;
    out.does = first.does;
    out.chords = first.chords;
    for (const write::Note& note : out.chords) static_cast<void>(out.ledger.add(note));
    out.homes = first.homes;
    make_room(*out.text, first.text->size());
    write_stream(
        out, post, options,
        [&](cl::Sink sink) {
            cl::Recording::Playback stream(*out.does);
            while (stream.step(sink)) {
            }
        },
        nullptr, by_moves);
    return out;
}

std::optional<Translated> with_chords(const Translated& first, double chord) {
    std::vector<const write::Note*> lost;
    for (const Ledger::Entry& entry : first.ledger.entries())
        if (entry.note.may_be_lines) lost.push_back(&entry.note);
    if (lost.empty()) return std::nullopt;
    Translated out;
    out.ending = first.ending, out.repeats = first.repeats, out.homes = first.homes;
    const auto is_lost = [&](const cl::Record& record) {
        const auto of = [&](const write::Note* note) {
            return note->from == record.from && note->stack == record.stack;
        };
        const auto found = std::find_if(lost.begin(), lost.end(), of);
        if (found == lost.end()) return false;
        write::Note told;
        told.fate = write::Fate::expanded;
        told.what = "a curve";
        told.from = record.from, told.stack = record.stack;
        told.instead = "is written as straight lines within the tolerance of --chord";
        out.chords.push_back(std::move(told));
        return true;
    };
    cl::Recording does;
    if (motion::take_chords(*first.does, chord, is_lost, does) == 0) return std::nullopt;
    out.does = std::make_shared<const cl::Recording>(std::move(does));
    out.text = first.text;
    return out;
}

void tell(Session& session, Translated& translated) {
    if (translated.stairs.empty() && has_remarks(session)) note_missing_remarks(translated, session);
    for (const Ledger::Entry& entry : translated.ledger.entries())
        if (entry.note.fate != write::Fate::mapped) session.diagnostics.add(complaint_of(entry.note, session));
    add_not_understood(translated.ledger, session, translated.ending);
    if (translated.repeats && !translated.begins_anew) lose_beginning_anew(session, translated.ledger);
}

}  // namespace obrys::driver
