#pragma once
/// What `obrys post` asks for.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace obrys::cli {

struct Arguments;

enum class PostVerb : int { none, list, make, check, preview };

struct PostArguments {
    PostVerb verb = PostVerb::none;
    std::string name;  ///< a shipped post or a file; of `make`: the title
    std::string extends = "fanuc";
    std::string command;           ///< of preview; empty: all
    std::vector<std::string> set;  ///< "depth=-20"
    bool all = false;              ///< of check: every block
};

/// Adds the command with its four verbs.
CLI::App* add_post(CLI::App& app, Arguments& a);

}  // namespace obrys::cli
