#pragma once
/// Where the blocks of a program go: numbered, in the characters and with the line ends of the control; parts that are
/// called write their blocks once, as subprograms, where they come to the same again. Holds the text of open parts and
/// of subprograms, nothing of the main program.

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "write/note.hpp"
#include "write/post.hpp"

namespace obrys::write {

/// The form of the post by which a cycle is written; null: a function of the post has said it.
struct FoldedBy {
    cl::CycleKind kind = cl::CycleKind::drill;
    const CycleForm* form = nullptr;
    std::size_t cycle = 0;  ///< of those that were taken, counted from 0
};

/// Machine coordinates of the reference points of X, Y and Z, NaN where they are not known.
struct Homes {
    std::array<double, 3> at{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::quiet_NaN()};
    std::array<bool, 3> assumed{};  ///< nobody has given them
};

struct Output {
    std::function<void(std::string_view)> text;
    std::function<void(Note)> note;
    /// A further file, whole, for posts that have subprograms in files of their own; null: all is to be in one text.
    std::function<void(const std::string& name, std::string_view text)> file{};
    std::function<void(const cl::Record&)> run{};   ///< what is written, where that is not what was taken (staircases)
    std::function<void(const FoldedBy&)> folded{};  ///< the cycle that was taken last is written as one of the control
    std::set<std::size_t> by_moves{};  ///< cycles that are written by their moves whatever forms there are, from 0
    Homes homes{};                     ///< of the machine
};

/// A text in UTF-8 as the control has it; ? for what it does not have.
[[nodiscard]] std::string encoded(std::string text, Encoding encoding);

class Layout {
public:
    /// `name` of the program. `post` outlives this.
    Layout(const Post& post, const std::string& name, Output output);

    /// `in_force`: words that hold before it, whether it says them or not.
    void block(std::string_view text, const std::vector<std::string>& in_force = {});
    /// A note without a line is about the block that follows.
    void note(Note note);
    /// The line of the block that follows, in the part that is open.
    [[nodiscard]] std::uint64_t next();

    /// Whether calls are written as such.
    [[nodiscard]] bool calls() const { return form_ != nullptr; }
    /// What follows, up to the matching close, comes from a part of the program; `call` says what and where from.
    void open(const cl::PartBegin& part, Note call);
    /// `whole`: the part may be called by itself.
    void close(bool whole);
    /// Parts that are open are no subprograms: their blocks stand where they are.
    void spill();
    /// Behind the end of the program.
    void put_subprograms();
    [[nodiscard]] bool has_subprograms() const { return !behind_.empty(); }
    void finish();

private:
    struct Piece {
        std::vector<std::string> blocks;
        std::vector<std::vector<std::string>> in_force;  ///< before each block, whether it says it or not
        std::vector<Note> notes;                         ///< lines counted from 1 within it
    };
    struct Subprogram {
        std::string part, name;
        double number = 0;
        Piece text;
        std::string file{};       ///< empty: that of the program
        std::uint64_t lines = 0;  ///< before its text in that file
    };
    /// One that waits for more passes of the same.
    struct Call {
        std::size_t subprogram = 0;
        std::uint64_t passes = 1;
        std::vector<Note> notes;
    };
    struct Level {
        cl::PartBegin part;
        Note call;
        Piece text;
        std::optional<Call> waiting;
        std::size_t bytes = 0;
        bool spilled = false;
    };
    /// Numbers the lines of a file.
    struct Lines {
        std::uint64_t lines = 0, numbered = 0;
    };

    [[nodiscard]] Level* top();  ///< null: the program's own text
    void append(Level* level, const Piece& text);
    void flush(Level* level);
    void call(std::size_t subprogram, const Level& closed);
    void unroll(const Level& closed);
    void tell_more(Subprogram& s, const Level& closed);
    [[nodiscard]] static bool does_for(const std::vector<std::string>& blocks, const Piece& pass);
    [[nodiscard]] std::optional<std::size_t> same_as(const Level& closed) const;
    [[nodiscard]] bool is_worth_it(const Level& closed);
    [[nodiscard]] std::size_t add(const Level& closed);
    [[nodiscard]] std::string name_for(const std::string& part, double number);
    [[nodiscard]] std::vector<std::string> blocks_of(const Template& text, const Subprogram& s,
                                                     std::uint64_t passes = 1) const;
    [[nodiscard]] Piece whole(const Subprogram& s) const;
    void put_file(Subprogram& s);
    void put(std::string_view block);
    /// Appends the block as it stands in its file.
    void append_line(std::string& to, std::string_view block, Lines& lines) const;
    [[nodiscard]] bool append_number(std::string& line, const Lines& lines) const;

    const Post& post_;
    Output output_;
    const SubprogramForm* form_ = nullptr;
    Lines lines_;
    std::string line_;             ///< room for the one that is put
    std::optional<Call> waiting_;  ///< of the program's own text
    std::vector<Level> levels_;
    std::vector<Subprogram> subprograms_;
    std::vector<std::size_t> behind_;  ///< those that will stand behind the end of the program
    std::vector<std::string> names_;   ///< in capitals
    struct Seen {
        std::string part;
        std::vector<std::string> blocks;
    };
    std::vector<Seen> seen_;  ///< the last texts that were unrolled: the next pass may come to one of them
};

}  // namespace obrys::write
