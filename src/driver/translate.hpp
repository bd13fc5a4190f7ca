#pragma once
/// A program as a program of another control, or of the same one: run, written by a post, and run again as that control
/// reads it.

#include <memory>
#include <optional>
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

/// The post that a call names: a shipped one, a file (.toml), or the name of a control, which stands for that of its
/// mills or lathes; "same" is the program's own. Nothing, with what is wrong in the session's diagnostics, where there
/// is none.
[[nodiscard]] std::optional<write::Post> find_post(const std::string& name, Session& session);
/// Its text among the session's sources; as above.
[[nodiscard]] std::optional<std::uint32_t> load_post(const std::string& name, Session& session);

/// What was written, and what it was written from.
struct Translated {
    std::string text;
    std::vector<WrittenFile> files;  ///< subprograms in files of their own, beside it
    Ledger ledger;
    cl::Recording does;                    ///< what the program does; by a post with staircases what these do
    write::Tape tape = write::Tape::none;  ///< in whose code it is to be delivered
    std::string tools{};                   ///< with their places in the magazine and their offsets, for people
    std::string stairs{};                  ///< what has become of slopes and arcs, for people; empty: nothing
};

struct TranslateOptions {
    std::string name;    ///< of the program, in its head
    bool files = false;  ///< subprograms may stand in files of their own, where the post has such
};
/// Runs the main program and writes it. What is expanded or lost is added to the session's diagnostics.
[[nodiscard]] Translated translate(Session& session, const write::Post& post, const TranslateOptions& options);

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
    std::unique_ptr<Session> run;  ///< null: its control is none that can be read
    bool run_complains = false;    ///< what it complains about is news
};
/// `request` and `session` are those of the program; how it runs otherwise is added to the session's diagnostics.
[[nodiscard]] Proved prove(const Translated& translated, const write::Post& post, Request request, Session& session,
                           const compare::Tolerance& tolerance, const OwnValues& values = {});

}  // namespace obrys::driver
