#pragma once
/// Prints blocks of a post: words that are in force are left out, blocks that say nothing are not printed.

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/vec.hpp"
#include "write/post.hpp"

namespace obrys::write {

/// What stands in the places that a template leaves to others.
struct Parts {
    const Template* compensation = nullptr;
    const Template* feed = nullptr;
    const Template* corner = nullptr;
    const Template* length = nullptr;
    const Template* coolant = nullptr;
    std::vector<std::string> axes;
};

enum class Printed : std::uint8_t {
    all,
    nothing,  ///< all that it would say is in force
    refused,  ///< a function of the post refuses it, or is wrong: it has been said
    failed    ///< a number that its word cannot hold, or that nobody knows: nothing was printed
};

class Printer {
public:
    /// `out` gets blocks, without numbers and ends of lines.
    Printer(const Post& post, std::function<void(std::string_view)> out);

    /// From here on what the post says holds at the begin is in force.
    void start();
    /// A word of a group is in force without having been printed.
    void force(const std::string& word);
    void force(const Template& words);
    /// No word of the groups of these is in force any more.
    void leave(const Template& words);
    /// `moves`: blocks that do nothing but say how to move are left out; `by_hook`: what stands as it is says
    /// something.
    Printed print(const Template& text, const Values& values, const Parts& parts = {}, bool moves = false,
                  bool by_hook = false);
    /// The block as it would stand, every word with it; nothing where a number does not fit.
    [[nodiscard]] std::optional<std::string> whole(const Block& block, const Values& values,
                                                   const Parts& parts = {}) const;

    /// What the words of such a block would say is in force, without having been printed.
    void remember(const Template& words, const Values& values);
    void forget_coordinates();
    /// Words that stand there as they are may have another value than the last one of their letter.
    void forget_words_of(const Template& text);
    /// Words of such a block are said again, whatever value they had.
    void forget_values_of(const Template& text);
    /// Every word but coordinates is said again.
    void forget_modes();
    /// Blocks of moves that would not move are printed, too, with all their words.
    void keep_standing(bool keep) { keeps_standing_ = keep; }
    /// Where the tool stands before the next move, as coordinates are programmed; it may be there without a word.
    void stand_at(const geom::Vec3& place) { stand_ = {place.x, place.y, place.z}; }
    /// Of the block that is given out: words of coordinates that are in force without it, printed or not.
    [[nodiscard]] const std::vector<std::string>& in_force() const { return coordinates_in_force_; }
    [[nodiscard]] const std::string& failed_word() const { return failed_; }

private:
    /// A word as it was printed last.
    struct Word {
        std::string text;     ///< empty: not known
        double number = NAN;  ///< of which it is made by itself, with `factor` and in `style`; NaN: that is not told
        double factor = 1;
        std::size_t style = 0;
        [[nodiscard]] bool is_made_of(double n, const Token& t) const {
            return number == n && factor == t.factor && style == t.style;
        }
        void clear() { text.clear(), number = NAN; }
    };
    /// What stands in a slot behind a block.
    struct Said {
        int slot = -1;
        Word word;
    };
    /// A block on its way, with what will be in force behind it.
    struct Line {
        std::string text;
        int words = 0;              ///< printed, of those that say more than how
        int names = 0;              ///< of these, those that only name what the block is about
        int modes = 0;              ///< words of groups
        bool mode_printed = false;  ///< in this template: a word behind it is printed, too
        int plain = 0;              ///< texts that stand as they are
        bool asked = false;         ///< the block has words with values
        std::vector<Said> said;     ///< of which so many count:
        std::size_t slots = 0;
        std::vector<std::pair<int, const std::string*>> groups;  ///< texts of the template
        std::vector<std::string> in_force;                       ///< words of coordinates that are so without it

        void append(std::string_view token);
        /// Room for one more, with what it held before.
        Said& next() {
            if (said.size() == slots) said.emplace_back();
            return said[slots];
        }
        /// As new; what it has of memory stays for the next block.
        void clear();
    };
    /// One that nothing stands in yet, for the block number `n` of a template.
    Line& line_for(std::size_t n);
    void put_in_force(Line& line);
    Printed print_once(const Template& text, const Values& values, const Parts& parts, bool moves, bool by_hook);
    bool add(Line& line, std::span<const Token> block, const Values& values, const Parts& parts);
    bool add_token(Line& line, const Token& t, const Values& values, const Parts& parts);
    bool add_word(Line& line, const Token& t, const Values& values);
    bool add_part(Line& line, const Token& t, const Values& values, const Parts& parts);
    [[nodiscard]] bool append_value(std::string& text, ValueIndex value, double factor, std::size_t style,
                                    const Values& values);
    [[nodiscard]] bool make_word(Word& word, const Token& t, const Values& values);
    [[nodiscard]] bool is_due(Line& line, const Token& t, const std::string& text, bool holds, double number) const;
    void add_literal(Line& line, const std::string& text, int group) const;

    const Post& post_;
    std::function<void(std::string_view)> out_;
    std::vector<Word> words_;            ///< by slot
    std::vector<std::string> in_force_;  ///< by group
    std::vector<std::string> coordinates_in_force_;
    std::array<double, 3> stand_{NAN, NAN, NAN};
    bool keeps_standing_ = false, all_words_ = false;
    bool always_ = false;  ///< inside of a part whose words are always printed
    std::string failed_;
    std::vector<Line> lines_;  ///< room for the blocks of a template, one time after the other
};

}  // namespace obrys::write
