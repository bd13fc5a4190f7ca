#include "cutting_arguments.hpp"

#include <CLI/CLI.hpp>
#include <cmath>

#include "arguments.hpp"
#include "base/number.hpp"
#include "geom/vec.hpp"
#include "help_texts.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/nearest.hpp"
#include "words.hpp"

namespace obrys::cli {

namespace {

constexpr double largest = 1e6;  ///< of a shop: a kilometre, a million revolutions

/// A size of a shop, above 0.
std::string is_size(const std::string& text) {
    const auto v = base::parse_double(text);
    if (!v || !std::isfinite(*v)) return "\"" + text + "\" is no number";
    if (!(*v > 0)) return "must be above 0";
    return *v <= largest ? "" : "is too large: at most 1000000";
}

void add_number(CLI::App& app, const char* name, double& value, const char* unit, const char* what, double factor = 1) {
    app.add_option_function<std::string>(
           name, [&value, factor](const std::string& text) { value = factor * *base::parse_double(text); }, what)
        ->check(is_size)
        ->type_name(unit);
}

/// Between 0 and 90 degrees; of a drill's point 180.
void add_angle(CLI::App& app, const char* name, double& value, const char* what, double most) {
    app.add_option_function<std::string>(
           name, [&value](const std::string& text) { value = geom::radians(*base::parse_double(text)); }, what)
        ->check([most](const std::string& text) {
            const auto v = base::parse_double(text);
            return v && *v >= 0 && *v <= most ? std::string()
                                              : "must be an angle of 0 to " + base::shortest(most) + " degrees";
        })
        ->type_name("DEG");
}

void add_output(CLI::App& app, Arguments& a) {
    app.add_option("--format", a.format, "text or json")->check(only({"text", "json"}))->type_name("FORMAT");
    app.add_option("-o,--output", a.output, "write to this file instead of standard output")->type_name("FILE");
    app.add_flag("--force", a.request.force, "replace files that are there (never the inputs)");
}

void add_machine(CLI::App& app, Arguments& a) {
    app.add_option("--machine", a.request.machine,
                   "shipped machine (" + shop::joined(shop::shipped_machine_names()) + ") or machine file")
        ->type_name("NAME|FILE");
}

void add_materials(CLI::App& app, Arguments& a) {
    app.add_option("--materials", a.cutting.materials, "file with materials of one's own (docs/cutting-data.md)")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->take_all();
}

void add_material(CLI::App& app, Arguments& a) {
    app.add_option("--material", a.cutting.material,
                   "of the workpiece: a name, an alloy or a number that obrys data --list prints")
        ->type_name("NAME");
    add_materials(app, a);
}

}  // namespace

CLI::App* add_data(CLI::App& app, Arguments& a) {
    using sim::cutting::Value;
    CLI::App* data = app.add_subcommand("data", data_help);
    sim::cutting::Asked& s = a.cutting.asked;
    data->add_option("--kind", a.cutting.kind, "end-mill, ball, bull-nose, drill or turning (end-mill)")
        ->check(only({"end-mill", "ball", "bull-nose", "drill", "turning"}))
        ->type_name("KIND");
    add_number(*data, "--diameter", s[Value::diameter], "MM", "of the tool; turning: of the workpiece");
    add_number(*data, "--corner-radius", s.corner_radius, "MM", "of a bull nose end mill");
    data->add_option_function<std::string>(
            "--teeth", [&s](const std::string& text) { s[Value::teeth] = *base::parse_double(text); },
            "cutting edges (flutes) of the tool")
        ->check([](const std::string& text) {
            const auto v = base::parse_integer(text);
            constexpr std::int64_t most = 1000;
            return v && *v > 0 && *v <= most
                       ? ""
                       : "must be a whole number from 1 to 1000: a tool without flutes does not cut";
        })
        ->type_name("N");
    add_number(*data, "--vc", s[Value::cutting_speed], "M/MIN", "cutting speed at the effective diameter");
    add_number(*data, "--rpm", s[Value::speed], "1/MIN", "speed of the spindle");
    add_number(*data, "--fz", s[Value::feed_per_tooth], "MM", "feed per tooth; turning: per revolution");
    add_number(*data, "--vf", s[Value::feed], "MM/MIN", "feed");
    add_number(*data, "--ap", s[Value::depth], "MM", "depth of cut");
    add_number(*data, "--ae", s[Value::width], "MM", "width of cut; of a round mill the distance of its rows, too");
    add_number(*data, "--hm", s[Value::chip], "MM", "mean chip thickness");
    add_number(*data, "--removal", s[Value::removal], "CM3/MIN", "removal rate");
    add_number(*data, "--d-eff", s[Value::effective_diameter], "MM", "effective diameter of a round mill");
    constexpr double right = 90, straight = 180;
    add_angle(*data, "--tilt", s.tilt, "of the tool's axis against the surface's normal (0)", right);
    add_angle(*data, "--point-angle", s.point_angle, "of a drill (118)", straight);
    add_angle(*data, "--entering-angle", s.entering_angle, "turning: of the edge against the feed (90)", straight);
    add_number(*data, "--nose-radius", s.nose_radius, "MM", "turning: of the insert");
    add_material(*data, a);
    data->add_flag("--list", a.cutting.list, "print the materials that can be named, and nothing else");
    add_machine(*data, a);
    add_output(*data, a);
    return data;
}

CLI::App* add_blade(CLI::App& app, Arguments& a) {
    CLI::App* blade = app.add_subcommand("blade", blade_help);
    blade->add_option("input", a.request.input, "a blade (.toml), see docs/blade.md")->required()->type_name("FILE");
    add_materials(*blade, a);
    add_output(*blade, a);
    return blade;
}

CLI::App* add_force(CLI::App& app, Arguments& a) {
    CLI::App* force = app.add_subcommand("force", force_help);
    add_material(*force, a);
    force->add_option("--format", a.format, "text or json")->check(only({"text", "json"}))->type_name("FORMAT");
    force->add_option("--lines", a.lines, "how many of the lines with the largest forces (10)")->type_name("N");
    return force;
}

CLI::App* add_cost(CLI::App& app, Arguments& a) {
    CLI::App* cost = app.add_subcommand("cost", cost_help);
    cost->add_option("input", a.request.input, "a cost table (.toml), see docs/cost.md")->required()->type_name("FILE");
    add_number(*cost, "--time", a.cutting.seconds, "S", "of a piece, for variants that say no time");
    cost->add_option("--program", a.cutting.program, "the same: as long as this program or job takes")
        ->type_name("FILE");
    add_machine(*cost, a);
    add_output(*cost, a);
    return cost;
}

}  // namespace obrys::cli
