#pragma once
/// What the commands of a post print with chosen values, without a program.

#include <map>
#include <string>
#include <vector>

#include "write/post.hpp"

namespace obrys::write {

struct ChosenValue {
    ValueIndex value = 0;
    std::string name;
    double number = 0;
};

struct Previewed {
    std::string command;  ///< "motion.arc-cw", "cycle.drill"
    std::string form;     ///< of several of a cycle: what it asks for; "define", "call"
    std::vector<std::string> blocks;
    std::vector<ChosenValue> values;  ///< that it prints or asks for
    std::string fault;                ///< why it prints nothing
};

/// By name of the value; in cycles roles come first.
using Choice = std::map<std::string, double>;

/// All commands for which the post has something, or the one of this name. A value that nobody has chosen is that of
/// the samples.
[[nodiscard]] std::vector<Previewed> preview(const Post& post, const std::string& command, const Choice& choice);

/// Whether a command or cycle is called so, and whether a value is.
[[nodiscard]] bool is_command_name(std::string_view name);
[[nodiscard]] bool is_value_name(std::string_view name);

}  // namespace obrys::write
