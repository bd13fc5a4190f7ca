#include "arguments.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <sstream>

#include "help_texts.hpp"
#include "options.hpp"
#include "usage.hpp"
#include "words.hpp"
#include "write/post.hpp"

namespace obrys::cli {

std::vector<driver::Wanted> outputs_of(const Arguments& a) {
    std::vector<driver::Wanted> all;
    const bool only_picture = a.command == Command::plot && !(a.interpolation > 0) && !a.svg.empty();
    if (!only_picture && !a.into_folder) all.push_back({"--output", a.output.empty() ? "-" : a.output});
    const std::string ledger = a.command == Command::compare ? "" : a.ledger;
    const std::pair<const char*, const std::string&> options[] = {{"--html", a.html},
                                                                  {"--svg", a.svg},
                                                                  {"--stl", a.stl},
                                                                  {"--3mf", a.three_mf},
                                                                  {"--gltf", a.gltf},
                                                                  {"--plan", a.plan_view},
                                                                  {"--projections", a.projections},
                                                                  {"--picture", a.picture},
                                                                  {"--engagement", a.engagement},
                                                                  {"--ledger", ledger},
                                                                  {"--write-baseline", a.write_baseline}};
    for (const auto& [option, path] : options)
        if (!path.empty()) all.push_back({option, path});
    return all;
}

Arguments parse(int argc, char** argv) {
    Arguments a;
    if (argc > 1 && argv[1][0] != '-' && !is_command(argv[1])) {
        std::cerr << "obrys: " << no_command(argv[1]);
        a.exit = 2;
        return a;
    }
    CLI::App app(main_help, "obrys");
    app.set_version_flag("--version", OBRYS_VERSION);
    app.require_subcommand(1);
    const Commands c = add_commands(app, a);
    std::string topic;
    c.help->add_option("command", topic, "the command to explain");
    refuse_empty_names(c);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        std::ostringstream text;  // standard output is written, and looked after, in one way only
        a.exit = e.get_exit_code() == 0 ? app.exit(e, text, std::cerr) : 2;
        if (a.exit != 0) print_usage_error(app, e);
        if (a.exit != 0) explain_dashes(argc, argv);
        std::fputs(text.str().c_str(), stdout);
        return a;
    }
    if (c.help->parsed()) {
        a.exit = print_help(topic) ? 0 : 2;
    }
    a.command = c.check->parsed()       ? Command::check
                : c.run->parsed()       ? Command::run
                : c.plot->parsed()      ? Command::plot
                : c.fmt->parsed()       ? Command::fmt
                : c.translate->parsed() ? Command::translate
                : c.compare->parsed()   ? Command::compare
                : c.sheet->parsed()     ? Command::sheet
                : c.time->parsed()      ? Command::time
                : c.calibrate->parsed() ? Command::calibrate
                : c.post->parsed()      ? Command::post
                                        : Command::version;
    return a;
}

}  // namespace obrys::cli
