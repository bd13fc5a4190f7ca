#include "time_arguments.hpp"

#include "help_texts.hpp"
#include "options.hpp"
#include "shop/nearest.hpp"
#include "words.hpp"
#include "write/post.hpp"

namespace obrys::cli {

CLI::App* add_time(CLI::App& app, Arguments& a) {
    CLI::App* time = app.add_subcommand("time", time_help);
    time->add_option("input", a.request.input, "a program (.MPF, .SPF, .H, .I, .ngc) or a job file (.toml)")
        ->required()
        ->type_name("FILE");
    add_request(*time, a);
    time->add_option("--format", a.format, "text or json")->check(only({"text", "json"}))->type_name("FORMAT");
    time->add_option("--lines", a.lines, "how many of the slowest lines (10)")->type_name("N");
    time->add_option("--compare", a.variants,
                     "also the time with other values of the machine: tolerance=0.01,0.05 (mm), acceleration (mm/s2), "
                     "jerk (mm/s3), block_time (s), look_ahead (blocks), corner=exact-stop,filter,blend, servo_gain "
                     "(1/s), window (mm), spindle_time (s for 1000 1/min), strobe_time (s), tool_change_time (s)")
        ->type_name("NAME=VALUE,…")
        ->allow_extra_args(false)
        ->take_all();
    time->add_flag("--advise", a.advise,
                   "also how the program's lines lie beside the tolerance, and the time with others in its place");
    time->add_option("--svg", a.svg, "also draw speed over time, and time over the path")->type_name("FILE");
    return time;
}

CLI::App* add_calibrate(CLI::App& app, Arguments& a) {
    CLI::App* calibrate = app.add_subcommand("calibrate", calibrate_help);
    calibrate->add_option("inputs", a.inputs, "the machine file and the table of recorded runs (.csv)")
        ->type_name("FILE")
        ->expected(0, 2);
    add_request(*calibrate, a);
    // The machine is the one that is fitted.
    calibrate->remove_option(calibrate->get_option("--machine"));
    calibrate->add_option("--format", a.format, "text or json")->check(only({"text", "json"}))->type_name("FORMAT");
    auto* program = calibrate->add_flag(
        "--program", a.test_program, "write a program whose times show how a machine moves: rapids, zigzags, circles");
    const std::string posts =
        "of the program: control or post: " + shop::joined(write::shipped_post_names()) + ", or a file";
    calibrate->add_option("--to", a.to, posts)->needs(program)->type_name("NAME|FILE");
    calibrate->add_option("--size", a.size, "of the program: how far it goes, mm (100)")
        ->needs(program)
        ->check(CLI::Range(20.0, 1000.0))
        ->type_name("MM");
    calibrate->add_option("--feed", a.feed, "of the program: its highest feed, mm/min (6000)")
        ->needs(program)
        ->check(CLI::Range(100.0, 100'000.0))
        ->type_name("MM/MIN");
    return calibrate;
}

}  // namespace obrys::cli
