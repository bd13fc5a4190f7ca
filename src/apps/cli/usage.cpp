#include "usage.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "help_texts.hpp"
#include "options.hpp"
#include "shop/machine.hpp"
#include "shop/nearest.hpp"
#include "words.hpp"
#include "write/post.hpp"

namespace obrys::cli {

void explain_dashes(int argc, char** argv) {
    std::error_code error;
    for (int i = 1; i < argc; ++i)
        if (argv[i][0] == '-' && std::filesystem::exists(argv[i], error))
            std::cerr << "  there is a file " << argv[i] << ", but a word with - before it is an option: write ./"
                      << argv[i] << "\n";
}

namespace {

/// Long names of all options of a command.
std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// The parser names what follows an option that it does not know, too.
std::string plain_error(const CLI::ParseError& e, const CLI::App& command) {
    const std::string text = e.what(), unexpected = "not expected: ";
    const std::size_t at = text.find(unexpected);
    if (at == std::string::npos) return text;
    std::string options, all, near;
    std::istringstream words(text.substr(at + unexpected.size()));
    for (std::string word; words >> word;) {
        all += " " + word;
        if (word.size() < 2 || word[0] != '-') continue;
        options += " " + word;
        if (word[1] == '-' && near.empty()) near = shop::nearest(word.substr(0, word.find('=')), option_names(command));
    }
    if (options.empty()) return "not expected:" + all;
    return "there is no option" + options + (near.empty() ? "" : "\n  did you mean " + near + "?");
}

}  // namespace

void print_usage_error(const CLI::App& app, const CLI::ParseError& e) {
    const std::vector<CLI::App*> used = app.get_subcommands();
    const std::string command = used.empty() ? "" : " " + used.front()->get_name();
    std::cerr << "obrys" << command << ": " << plain_error(e, used.empty() ? app : *used.front())
              << "\n  how it is called: obrys help" << command << "\n";
}

bool print_help(const std::string& topic) {
    Arguments unused;
    CLI::App app(main_help, "obrys");  // help of one that has parsed a command is that of the command
    const Commands c = add_commands(app, unused);
    if (topic.empty()) return std::fputs(app.help().c_str(), stdout) >= 0;
    for (const CLI::App* command : {c.check, c.run, c.plot, c.fmt, c.translate, c.compare, c.sheet, c.time, c.calibrate,
                                    c.post, c.version, c.help})
        if (command->get_name() == topic) return std::fputs(command->help("obrys").c_str(), stdout) >= 0;
    std::cerr << "obrys help: " << no_command(topic);
    return false;
}

}  // namespace obrys::cli
