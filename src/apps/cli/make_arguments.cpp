#include "make_arguments.hpp"

#include <CLI/CLI.hpp>

#include "arguments.hpp"
#include "cycles/groove/strategy.hpp"
#include "shop/nearest.hpp"
#include "words.hpp"
#include "write/post.hpp"

namespace obrys::cli {

namespace {

constexpr const char* make_help =
    "Makes a program from measures, holds it against stock and part, and says what it does.\n\n"
    "Examples:\n"
    "  obrys make groove groove.toml                                   side stepping: what it does, and its verdict\n"
    "  obrys make groove groove.toml --strategy plunge-turning --format json\n"
    "  obrys make groove groove.toml --to sinumerik-840d-lathe -o GROOVE.MPF\n"
    "                                                                  the program, and GROOVE.job.toml to check it\n"
    "  obrys make groove groove.toml --compare                         all strategies in a table\n\n"
    "Nothing is written where a guard refuses the groove, or the path cuts into the part or meets stock at rapid.\n\n"
    "Exit codes: 0 clean, 1 refused or findings, 2 usage or unreadable input, 3 the program could not be compared.";

std::vector<std::string> strategy_words() {
    std::vector<std::string> words;
    for (const cycles::groove::Named& n : cycles::groove::strategies()) words.emplace_back(n.word);
    return words;
}

}  // namespace

CLI::App* add_make(CLI::App& app, Arguments& a) {
    CLI::App* make = app.add_subcommand("make", make_help);
    make->add_option("what", a.make.what, "groove")->required()->check(only({"groove"}))->type_name("WHAT");
    make->add_option("input", a.request.input, "its measures (.toml)")->required()->type_name("FILE");
    auto* compare = make->add_flag("--compare", a.make.compare, "all strategies on this groove, in a table");
    make->add_option("--strategy", a.make.strategy, shop::joined(strategy_words()) + " (side-stepping)")
        ->check(only(strategy_words()))
        ->excludes(compare)
        ->type_name("NAME");
    make->add_option("--to", a.to, "control or post of the program: " + shop::joined(write::shipped_post_names()))
        ->excludes(compare)
        ->type_name("NAME|FILE");
    make->add_option("--format", a.format, "of what is said: text or json; of --compare also csv")
        ->check(only({"text", "json", "csv"}))
        ->type_name("FORMAT");
    make->add_option("-o,--output", a.output, "the program; without --to the CL stream; of --compare the table")
        ->type_name("FILE");
    make->add_flag("--force", a.request.force, "replace files that are there (never the inputs)");
    make->callback([&a] {
        if (!a.to.empty() && a.output.empty())
            throw CLI::ValidationError("--to", "writes a program: name its file with -o");
        if (a.format == "csv" && !a.make.compare)
            throw CLI::ValidationError("--format", "csv is a form of --compare; without it there are text and json");
    });
    return make;
}

}  // namespace obrys::cli
