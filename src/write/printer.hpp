#pragma once
/// Prints blocks of a post: words that are in force are left out, blocks that say nothing are not printed.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
    [[nodiscard]] std::uint64_t lines() const { return lines_; }
    [[nodiscard]] const std::string& failed_word() const { return failed_; }

private:
    struct Line;
    bool add(Line& line, const Block& block, const Values& values, const Parts& parts);
    bool add_token(Line& line, const Token& t, const Values& values, const Parts& parts);
    bool add_word(Line& line, const Token& t, const Values& values);
    void add_literal(Line& line, const std::string& text, int group) const;
    void put(std::string_view text);
    [[nodiscard]] bool put_number(std::string& line) const;

    const Post& post_;
    std::function<void(std::string_view)> out_;
    std::vector<std::string> words_;     ///< by slot: as last printed; empty: not known
    std::vector<std::string> in_force_;  ///< by group
    std::uint64_t lines_ = 0, numbered_ = 0;
    std::string failed_;
};

}  // namespace obrys::write
