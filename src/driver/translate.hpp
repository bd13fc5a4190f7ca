#pragma once
/// A program as a program of another control, or of the same one: run, written by a post, and run again as that control
/// reads it.

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "cl/recording.hpp"
#include "compare/compare.hpp"
#include "driver/ledger.hpp"
#include "driver/session.hpp"
#include "write/post.hpp"
#include "write/tape.hpp"
#include "write/writer.hpp"

namespace obrys::driver {

/// Statements of a lathe's program may also be said by a post that is for the moves of mills alone.
enum class PostFor : std::uint8_t { moves, statements };
/// The post that a call names: a shipped one, a file (.toml), or the name of a control, which stands for that of its
/// mills or lathes; "same" is the program's own. Nothing, with what is wrong in the session's diagnostics, where there
/// is none.
[[nodiscard]] std::optional<write::Post> find_post(const std::string& name, Session& session,
                                                   PostFor way = PostFor::moves);
/// The name as the control takes it (`[file]` of the post); names of programs hold no blanks.
[[nodiscard]] std::string name_in(const write::Post& post, std::string name);
/// The same, and says so where it is another one.
[[nodiscard]] std::string said_name_in(const write::Post& post, const std::string& name, Session& session);
/// Its text among the session's sources; as above.
[[nodiscard]] std::optional<std::uint32_t> load_post(const std::string& name, Session& session);
/// Loads what an own post names beside itself: hooks, the post that it extends. Nothing for shipped ones.
[[nodiscard]] write::LoadText beside_post(const std::string& name, Session& session);

/// By which of the post's forms a cycle is written.
struct UsedForm {
    std::size_t record = 0;  ///< of the stream, counted from 1
    std::size_t cycle = 0;   ///< of the program's, counted from 0
    cl::CycleKind kind = cl::CycleKind::drill;
    std::optional<std::size_t> form{};  ///< among those of the kind; nothing: by a function of the post
    [[nodiscard]] bool is_next_of(const UsedForm& other) const {
        return kind == other.kind && form == other.form && cycle == other.cycle + 1;
    }
};

/// What was written, and what it was written from.
struct Translated {
    std::shared_ptr<std::string> text = std::make_shared<std::string>();  ///< whoever runs it shares it
    std::vector<WrittenFile> files;  ///< subprograms in files of their own, beside it
    Ledger ledger;
    std::shared_ptr<const cl::Recording> does;  ///< what the program does; by a post with staircases what these do
    write::Tape tape = write::Tape::none;       ///< in whose code it is to be delivered
    std::string tools{};                        ///< with their places in the magazine and their offsets, for people
    std::string stairs{};                       ///< what has become of slopes and arcs, for people; empty: nothing
    std::vector<UsedForm> forms{};              ///< of cycles that are not written by their moves
    interp::Ending ending = interp::Ending::regular;  ///< of the program
    bool repeats = false;                             ///< it begins anew, without end
    write::Homes homes{};                             ///< of the machine that it was run on
    bool begins_anew = false;                         ///< what is written does so, too
    std::vector<write::Note>
        chords{};  ///< curves that `does` has as straight lines, since the post has no words for them
};

struct TranslateOptions {
    std::string name;    ///< of the program, in its head
    bool files = false;  ///< subprograms may stand in files of their own, where the post has such
    /// mm: a curve that the post has no words for may stand there as straight lines that lie no farther from it; 0: it
    /// is lost.
    double chord = 0;
};
/// Runs the main program and writes it.
[[nodiscard]] Translated write_program(Session& session, const write::Post& post, const TranslateOptions& options);
/// Writes what a program does once more, by another post; none with staircases or a magazine, whose `does` is another
/// stream than what was taken.
/// `by_moves`: cycles, counted from 0, that are written by their moves.
[[nodiscard]] Translated write_again(const Translated& first, const write::Post& post, const TranslateOptions& options,
                                     const std::set<std::size_t>& by_moves);
/// What does the same, but for the curves that are lost: these are straight lines within `chord` mm, and are told as
/// such. Nothing where no curve can be. To be written again.
[[nodiscard]] std::optional<Translated> with_chords(const Translated& first, double chord);
/// Adds what is expanded or lost to the session's diagnostics, and what was not understood to the ledger. Once.
void tell(Session& session, Translated& translated);

/// What the writer says, at its place in the program.
[[nodiscard]] base::Diagnostic complaint_of(const write::Note& note, const Session& session);

enum class Proof : std::uint8_t {
    same,          ///< run again, it does the same
    differs,       ///< it runs otherwise, or its control would stop
    not_compared,  ///< it is not known: one of the two was not understood, or could not be run
};

/// "equal", "differs", "not compared".
[[nodiscard]] std::string_view name_of(Proof proof);

/// Values that count for the text, in its own names.
struct OwnValues {
    std::vector<std::string> set{};
    shop::GivenValues given{};
};

/// The text run on its control, with the machine, the tools and the zeros of the program that it comes from.
struct Proved {
    Proof proof = Proof::not_compared;
    bool differs = false;   ///< something is known to run otherwise, whatever else is not known
    std::size_t moves = 0;  ///< that it makes
    double within = 0;      ///< mm: as near to the program as the comparison says; staircases are on the words' places
    std::string why_not;    ///< it was not compared at all; empty: it was
    std::unique_ptr<Session> run;              ///< null: its control is none that can be read
    bool run_complains = false;                ///< what it complains about is news
    bool planes_rounded = false;               ///< tilted ones, by the angles that their words hold
    bool feeds_rounded = false;                ///< as their words hold them
    bool speeds_rounded = false;               ///< the same of the spindle
    double increment = 0;                      ///< mm, in which the control counts; 0: places are as written
    std::optional<cl::Record> without_feed{};  ///< the program's first move at feed for which it has programmed none
    compare::Result compared{};                ///< with the program
};
/// Without a word to the session, which is that of the program, as `request` is.
[[nodiscard]] Proved hold_against(const Translated& translated, const write::Post& post, Request request,
                                  const Session& session, const compare::Tolerance& tolerance,
                                  const OwnValues& values = {});
/// `request` and `session` are those of the program; how it runs otherwise is added to the session's diagnostics.
[[nodiscard]] Proved prove(const Translated& translated, const write::Post& post, Request request, Session& session,
                           const compare::Tolerance& tolerance, const OwnValues& values = {});

struct Settled {
    Translated translated;
    Proved proved;
};
/// Runs the main program, writes it and proves it. A cycle of the target's control that runs otherwise than the
/// program's (other ways back, another machine's parameters) is written by its moves, and where the next one of its
/// form does so too, all of that form are, or by the post's next form; so are frames left out. Radius compensation that
/// the target makes otherwise (another way onto the contour, other corners) is left out for the tool's path. What is
/// expanded, lost or otherwise is added to the session's diagnostics.
[[nodiscard]] Settled translate(Session& session, const write::Post& post, const Request& request,
                                const TranslateOptions& options, const compare::Tolerance& tolerance);

}  // namespace obrys::driver
