#include "options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>

#include "base/number.hpp"
#include "help_texts.hpp"
#include "milled.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/machine.hpp"
#include "shop/nearest.hpp"
#include "time_arguments.hpp"
#include "words.hpp"
#include "write/post.hpp"

namespace obrys::cli {

namespace {

void add_format(CLI::App& app, Arguments& a) {
    using format::heidenhain::Decimal;
    using format::heidenhain::LineEnds;
    app.add_option("files", a.files, "programs (.H, .I)")->required()->type_name("FILE");
    auto* write = app.add_flag("-i,--in-place", a.in_place, "write the files instead of standard output");
    app.add_flag("--check", a.only_check, "write nothing; exit code 1 where a file would change")->excludes(write);
    app.add_option_function<std::string>(
           "--decimal",
           [&a](const std::string& word) {
               a.style.decimal = word == "point" ? Decimal::point : word == "comma" ? Decimal::comma : Decimal::keep;
           },
           "decimal sign of values (keep)")
        ->check(only({"keep", "point", "comma"}))
        ->type_name("SIGN");
    app.add_option_function<std::string>(
           "--line-ends",
           [&a](const std::string& word) {
               a.style.line_ends = word == "lf" ? LineEnds::lf : word == "crlf" ? LineEnds::crlf : LineEnds::keep;
           },
           "ends of lines (keep)")
        ->check(only({"keep", "lf", "crlf"}))
        ->type_name("ENDS");
}

void add_input(CLI::App& app, Arguments& a) {
    app.add_option("input", a.request.input, "program (.MPF, .SPF, .H, .I, .ngc) or job file (.toml)")
        ->required()
        ->type_name("FILE");
}

}  // namespace

void add_request(CLI::App& app, Arguments& a) {
    app.add_option("--control", a.request.control,
                   "control of the program: " + shop::joined(driver::controls()) + "; else found from the text")
        ->type_name("NAME");
    app.add_option("--machine", a.request.machine,
                   "shipped machine (" + shop::joined(shop::shipped_machine_names()) + ") or machine file")
        ->type_name("NAME|FILE");
    app.add_option("--set", a.request.set, "give a parameter another value: replaces its constant assignments")
        ->type_name("NAME=NUMBER")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--search", a.request.search, "folder in which called programs are looked for too")
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--tools", a.request.tools, "tool table of the control: TOOL.T, .tbl, TOA, or a list (.toml)")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--ini", a.request.configuration, "configuration of a LinuxCNC machine")->type_name("FILE");
    app.add_option("--var", a.request.stored, "parameter file of a LinuxCNC machine")->type_name("FILE");
    app.add_option("--prints", a.request.prints, "folder for what the program prints (FN 15, FN 16)")->type_name("DIR");
    app.add_option("--skip", a.request.skip, "block skip level that is on (/ is level 0)")
        ->type_name("0..9")
        ->check(CLI::Range(0, 9))
        ->allow_extra_args(false)
        ->take_all();
    // Not bound to the optional: CLI11 sets a bound flag to false when it is not given.
    auto* diameter = app.add_flag_callback(
        "--diameter", [&a] { a.request.diameter = true; }, "X words are diameters at the start");
    app.add_flag_callback(
           "--radius", [&a] { a.request.diameter = false; }, "X words are radii at the start")
        ->excludes(diameter);
    app.add_option("-o,--output", a.output, "write to this file instead of standard output")->type_name("FILE");
    app.add_flag("--force", a.request.force, "replace files that are there (never the inputs)");
}

namespace {

/// What the verdict and the exit code count.
void add_verdict(CLI::App& app, Arguments& a) {
    app.add_option_function<std::string>(
           "--scope", [&a](const std::string& text) { a.request.scope = shop::scope_named(text); },
           "what is judged: all; part (its shape); collisions (no part needed); motion (neither stock nor part needed)")
        ->check(only({"all", "part", "collisions", "motion"}))
        ->type_name("SCOPE");
    app.add_option("--fail-on", a.fail_on, "exit code 1 only for findings of this code, or as severe or worse")
        ->check(is_code_or_severity)
        ->type_name("CODE|SEVERITY")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--baseline", a.baseline, "findings that this file knows do not count for the exit code")
        ->type_name("FILE");
    app.add_option("--write-baseline", a.write_baseline, "write the findings as such a file")->type_name("FILE");
}

void refuse_two_pictures(CLI::App& plot, const Arguments& a) {
    plot.final_callback([&a] {
        if (!(a.interpolation > 0) && !a.svg.empty() && !a.output.empty())
            throw CLI::ValidationError("--svg and --output both name a file for the one picture");
    });
}

/// The machined surface as file or picture, and when.
void add_surface_outputs(CLI::App& check, Arguments& a) {
    check.add_option("--stl", a.stl, "milling: also write the machined surface as binary STL")->type_name("FILE");
    check.add_option("--3mf", a.three_mf, "milling: the same as 3MF, coloured by tool or deviation")->type_name("FILE");
    check.add_option("--gltf", a.gltf, "milling: the same as binary glTF (.glb)")->type_name("FILE");
    const auto picture = [&](const char* name, std::string& file, const char* what) {
        check.add_option(name, file, what)
            ->check([](const std::string& path) {
                return path.ends_with(".png") || path.ends_with(".svg") ? "" : "must end with .png or .svg";
            })
            ->type_name("FILE");
    };
    picture("--plan", a.plan_view, "milling: also draw the part from above, the deeper the darker (.png, .svg)");
    picture("--projections", a.projections, "milling: the same from front, left and above, cut open");
    picture("--picture", a.picture, "milling: the same in 3D");
    check
        .add_option_function<std::string>(
            "--at",
            [&a](const std::string& move) { a.milling.at = static_cast<std::uint64_t>(*base::parse_integer(move)); },
            "milling: surface and pictures as they are after this move (numbers: obrys run --format csv)")
        ->check([](const std::string& text) {
            return base::parse_integer(text).value_or(-1) >= 0 ? "" : "must be the number of a move, counted from 0";
        })
        ->type_name("MOVE");
    check.callback([&a] {
        if (a.milling.at && !wants_surface(a))
            throw CLI::ValidationError(
                "--at", "says when; what to write is said by --stl, --3mf, --gltf, --plan, --projections or --picture");
    });
}

/// How near the simulated surface of a milled part must be.
void add_simulation_tolerance(CLI::App& app, Arguments& a) {
    app.add_option_function<double>(
           "--tolerance", [&a](const double& mm) { a.milling.tolerance = mm; },
           "milling: how near the simulated surface must be to the true one, mm (0.01)")
        ->check([](const std::string& text) {
            const auto value = base::parse_double(text);
            return value && *value > 0 && *value <= shop::largest_tolerance
                       ? std::string()
                       : "must be a length in mm above 0, at most 1";
        })
        ->type_name("MM");
}

std::string is_length(const std::string& text) {
    const auto value = base::parse_double(text);
    return value && *value > 0 && *value <= 1 ? std::string() : "must be a length in mm above 0, at most 1";
}

/// How near both runs must lie.
void add_same_place(CLI::App& app, Arguments& a) {
    app.add_option_function<double>(
           "--tolerance", [&a](const double& mm) { a.same_place = mm; }, "how far places may lie apart, mm (0.0001)")
        ->check(is_length)
        ->type_name("MM");
}

CLI::App* add_translate(CLI::App& app, Arguments& a) {
    CLI::App* translate = app.add_subcommand("translate", translate_help);
    add_input(*translate, a);
    add_request(*translate, a);
    translate->add_option("--to", a.to, "control or post: " + shop::joined(write::shipped_post_names()) + ", or a file")
        ->required()
        ->type_name("NAME|FILE");
    translate
        ->add_option("--ledger", a.ledger,
                     "also write what became of what (.json, .html, else text); with --keep it is OUT.ledger.json")
        ->type_name("FILE");
    translate->add_flag("--accept-loss", a.accept_loss, "write the program also where something is lost or differs");
    add_same_place(*translate, a);
    auto* chord =
        translate
            ->add_option_function<double>(
                "--chord", [&a](const double& mm) { a.chord = mm; },
                "curves that the control has no words for as straight lines, no farther from them than so much")
            ->check(is_length)
            ->type_name("MM");
    translate->callback([&a] { a.request.stand_alone = a.to == "canon"; });  // whose calls are those of rs274
    auto* keep = translate->add_flag(
        "--keep", a.keep, "statement by statement: parameters, expressions, branches, loops and subprograms stay");
    keep->excludes(chord);
    translate->add_option("--sets", a.sets, "--keep: prove it with so many sets of other values, too (3)")
        ->needs(keep)
        ->check(CLI::Range(0, 1000))
        ->type_name("N");
    return translate;
}

CLI::App* add_compare(CLI::App& app, Arguments& a) {
    CLI::App* compare = app.add_subcommand("compare", compare_help);
    compare->add_option("a", a.request.input, "program, job file (.toml) or CL stream")->required()->type_name("FILE");
    compare->add_option("b", a.other, "what it is held against")->required()->type_name("FILE");
    add_request(*compare, a);
    compare->add_option("--format", a.format, "text or json")->check(only({"text", "json"}))->type_name("FORMAT");
    add_same_place(*compare, a);
    compare->add_option("--svg", a.svg, "picture of both ways around the first move that differs")->type_name("FILE");
    compare->add_option("--job", a.job_file, "a job for both: each program in the place of its own")->type_name("FILE");
    compare
        ->add_option_function<std::string>(
            "--scope", [&a](const std::string& text) { a.request.scope = shop::scope_named(text); },
            "all; motion: what is left of the stock is not compared, which takes the time")
        ->check(only({"all", "motion"}))
        ->type_name("SCOPE");
    compare
        ->add_option("--map", a.map, "what a parameter of the first program is called in the other: --set is for both")
        ->check([](const std::string& text) {
            const std::size_t equal = text.find('=');
            const bool good = equal != std::string::npos && equal > 0 && equal + 1 < text.size();
            return good ? std::string() : "must be of the form R3=Q3";
        })
        ->type_name("A=B")
        ->allow_extra_args(false)
        ->take_all();
    const std::string controls = shop::joined(driver::controls());
    compare->add_option("--control-a", a.control_a, "control of the first program alone: " + controls)
        ->type_name("NAME");
    compare->add_option("--control-b", a.control_b, "control of the other one alone")->type_name("NAME");
    compare->add_option("--ledger", a.ledger, "the same for all of them: what translate --keep has written beside B")
        ->type_name("FILE");
    return compare;
}

CLI::App* add_sheet(CLI::App& app, Arguments& a) {
    CLI::App* sheet = app.add_subcommand("sheet", sheet_help);
    sheet->add_option("input", a.inputs, "programs (.MPF, .SPF, .H, .I, .ngc) or job files (.toml)")
        ->required()
        ->type_name("FILE");
    add_request(*sheet, a);
    sheet
        ->add_option_function<std::string>(
            "--format", [&a](const std::string& word) { a.format = word, a.format_given = true; },
            "text, html, json or pdf (by the ending of the output's name, else text)")
        ->check(only({"text", "html", "json", "pdf"}))
        ->type_name("FORMAT");
    sheet->add_flag("--job", a.job, "first one list of tools and one time for all programs together");
    sheet->add_option("--since", a.since, "also what differs from this older sheet (.json)")->type_name("FILE");
    return sheet;
}

}  // namespace

Commands add_commands(CLI::App& app, Arguments& a) {
    Commands c{};
    c.check = app.add_subcommand("check", check_help);
    c.check->add_option("input", a.inputs, "programs (.MPF, .SPF, .H, .I, .ngc) or job files (.toml)")
        ->required()
        ->type_name("FILE");
    add_request(*c.check, a);
    add_verdict(*c.check, a);
    c.check->add_option("--format", a.format, "text, json or sarif")
        ->check(only({"text", "json", "sarif"}))
        ->type_name("FORMAT");
    c.check->add_option("--html", a.html, "also write a page with picture and program text")->type_name("FILE");
    c.check->add_option("--svg", a.svg, "also write the picture; milling: as --projections")->type_name("FILE");
    add_simulation_tolerance(*c.check, a);
    add_surface_outputs(*c.check, a);
    c.check->add_option("--engagement", a.engagement, "milling: also write how every move was engaged (.csv, .json)")
        ->check([](const std::string& path) {
            return path.ends_with(".csv") || path.ends_with(".json") ? "" : "must end with .csv or .json";
        })
        ->type_name("FILE");
    c.check->add_flag("--all", a.all, "also what every move of a finding did that several moves make");
    c.check->add_flag("-q,--quiet", a.quiet, "text: verdict, findings and what was not checked only");
    c.check->add_flag("--no-list", a.no_list, "text: leave out what has no effect on the verdict");
    c.check->add_flag_function(
        "--no-color,--no-colour", [&a](std::int64_t) { a.colours = false; }, "text without colours (also: NO_COLOR)");
    c.run = app.add_subcommand("run", run_help);
    add_input(*c.run, a);
    add_request(*c.run, a);
    auto* format = c.run->add_option("--format", a.format, "text, csv or json")
                       ->check(only({"text", "csv", "json"}))
                       ->type_name("FORMAT");
    c.run->add_flag("--canon", a.request.stand_alone, "print LinuxCNC's canonical calls instead of the moves")
        ->excludes(format);
    c.run->add_flag("-q,--quiet", a.quiet, "print one line of counts instead of the moves");
    c.run->add_flag("--parameters", a.parameters, "print the numbered parameters at the end instead of the moves");
    c.plot = app.add_subcommand("plot", plot_help);
    add_input(*c.plot, a);
    add_request(*c.plot, a);
    c.plot->add_option("--svg", a.svg, "write the picture to this file")->type_name("FILE");
    refuse_two_pictures(*c.plot, a);
    c.plot
        ->add_option_function<std::string>(
            "--interpolation", [&a](const std::string& text) { a.interpolation = *base::parse_double(text); },
            "basic length unit of the controller, mm: print its deviations from the path")
        ->check([](const std::string& text) {
            const auto value = base::parse_double(text);
            return value && *value > 0 && std::isfinite(*value) ? std::string() : "must be a length in mm above 0";
        })
        ->type_name("MM");
    c.fmt = app.add_subcommand("fmt", fmt_help);
    add_format(*c.fmt, a);
    c.translate = add_translate(app, a);
    c.compare = add_compare(app, a);
    c.sheet = add_sheet(app, a);
    c.time = add_time(app, a);
    c.calibrate = add_calibrate(app, a);
    c.data = add_data(app, a);
    c.cost = add_cost(app, a);
    c.blade = add_blade(app, a);
    c.force = add_force(app, a);
    add_input(*c.force, a);
    add_request(*c.force, a);
    add_simulation_tolerance(*c.force, a);
    c.post = add_post(app, a);
    c.make = add_make(app, a);
    c.version = app.add_subcommand("version", "prints the version");
    c.help = app.add_subcommand("help", "prints this text, or that of a command: obrys help check");
    return c;
}

void refuse_empty_names(const Commands& c) {
    for (CLI::App* command : {c.check, c.run, c.plot, c.fmt, c.translate, c.compare, c.sheet, c.time, c.calibrate,
                              c.data, c.cost, c.blade, c.force, c.make})
        for (CLI::Option* option : command->get_options())
            if (option->get_type_name().find("FILE") != std::string::npos)
                option->check(
                    [](const std::string& name) { return name.empty() ? "the name is empty" : std::string(); }, "");
}

}  // namespace obrys::cli
