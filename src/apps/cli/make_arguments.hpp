#pragma once
/// What `obrys make` is asked for.

#include <string>

namespace CLI {
class App;
}

namespace obrys::cli {

struct Arguments;

struct MakeArguments {
    std::string what;                        ///< "groove"
    std::string strategy = "side-stepping";  ///< its word
    bool compare = false;                    ///< all strategies in a table
};

CLI::App* add_make(CLI::App& app, Arguments& a);

}  // namespace obrys::cli
