#pragma once
/// What `obrys data`, `cost`, `blade` and `force` ask for.

#include <string>
#include <vector>

#include "sim/cutting/data.hpp"

namespace CLI {
class App;
}

namespace obrys::cli {

struct Arguments;

struct CuttingArguments {
    sim::cutting::Asked asked;           ///< of data
    std::string kind = "end-mill";       ///< of data
    std::string material;                ///< a name; empty: none
    std::vector<std::string> materials;  ///< files
    double seconds = NAN;                ///< of cost: of a piece; NaN: not given
    std::string program;                 ///< of cost: what takes so long
    bool list = false;                   ///< of data: the materials
};

CLI::App* add_data(CLI::App& app, Arguments& a);
CLI::App* add_cost(CLI::App& app, Arguments& a);
CLI::App* add_blade(CLI::App& app, Arguments& a);
/// Without what it has in common with the other commands that run a program.
CLI::App* add_force(CLI::App& app, Arguments& a);

}  // namespace obrys::cli
