/// obrys compare.

#include "compare/compare.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "commands.hpp"
#include "compare_output.hpp"
#include "driver/compare_programs.hpp"
#include "driver/documents/plot_difference.hpp"
#include "driver/keep.hpp"
#include "driver/not_run.hpp"
#include "driver/stream_file.hpp"
#include "milled.hpp"
#include "session.hpp"

namespace obrys::cli {

namespace {

/// One of the two: its session stays, since places lie in its texts.
struct Side {
    driver::Request request;
    driver::Session session{};
    bool is_open = false;
};

/// What parameters of the first program are called in the other; nothing after a complaint.
std::optional<driver::NameMap> name_map(const Arguments& a) {
    driver::NameMap map;
    for (const std::string& pair : a.map) {
        const std::size_t equal = pair.find('=');
        map.emplace_back(pair.substr(0, equal), pair.substr(equal + 1));
    }
    const std::string beside = driver::ledger_beside(a.other);
    const bool named = !a.ledger.empty();
    if (!named && !std::filesystem::exists(beside)) return map;
    const std::string& path = named ? a.ledger : beside;
    std::ifstream in(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    auto names = driver::names_of_ledger(text);
    if (!names) {
        std::fprintf(stderr, "obrys: %s is no ledger of a translation\n", path.c_str());
        return std::nullopt;
    }
    map.insert(map.end(), names->begin(), names->end());  // what the call says stands above it
    return map;
}

/// What both mean with a job for both: its tools, stock and zeros, and the program in the place of its own.
driver::Request request_of(const Arguments& a, const std::string& input, const std::string& control,
                           const driver::NameMap& map) {
    driver::Request r = a.request;
    if (!control.empty()) r.control = control;
    r.input = a.job_file.empty() ? input : a.job_file;
    r.program = a.job_file.empty() ? "" : input;
    r.set = driver::mapped(a.request.set, map);
    r.for_these_values = r.homes_at_zero = true;
    return r;
}

void open_side(const Arguments& a, const std::string& input, Side& side) {
    Arguments own = a;
    own.request = side.request;
    if (!driver::is_stream(input)) return static_cast<void>(side.is_open = open(own, side.session));
    own.request.input = input;
    side.is_open = driver::open_stream(own.request, side.session);
    if (!side.is_open) print_diagnostics(side.session, base::Severity::warning);
}

/// The picture, where one is asked for and something moves otherwise. False: it cannot be written.
bool deliver_picture(const Arguments& a, const Compared& c, const driver::ComparedSide& first,
                     const driver::ComparedSide& other) {
    if (a.svg.empty()) return true;
    const auto plot = driver::plot_difference(first, other, c.moves, a.same_place);
    if (!plot) {
        std::fputs("note: the motion does not differ: there is nothing to draw\n", stderr);
        return true;
    }
    return deliver(a.svg, report::to_svg(*plot, c.a.sources));
}

/// What the exit code says; what is said otherwise (zeros, cycles) makes no difference to the machine.
std::string verdict_line(int code, bool same, bool stops_alone, bool turns_alone) {
    if (code == 3)
        return std::string("not fully compared: ") +
               (stops_alone   ? "one stops exactly at blocks (G9) where the other does not"
                : turns_alone ? "whether the rotary axes turn alike to a tilted plane is not known"
                              : "something of either was not understood or not run") +
               (same ? "\n" : "; what was compared differs\n");
    return same ? "the machine does the same\n" : "the machine does not do the same\n";
}

}  // namespace

int compare(const Arguments& arguments) {
    const auto map = name_map(arguments);
    if (!map) return 2;
    Side a{request_of(arguments, arguments.request.input, arguments.control_a, {})},
        b{request_of(arguments, arguments.other, arguments.control_b, *map)};
    open_side(arguments, arguments.request.input, a);
    open_side(arguments, arguments.other, b);
    if (!a.is_open || !b.is_open) return 2;
    compare::Tolerance tolerance;
    tolerance.length = arguments.same_place;
    Compared c{a.session, b.session, driver::compare_sessions(a.session, b.session, tolerance), {}, true};
    for (Side* side : {&a, &b})
        if (c.moves.moves_a == 0 && c.moves.moves_b == 0)
            driver::say_that_nothing_moves(side->session.diagnostics, side->session.main);
    const int code_a = driver::exit_code_of_run(a.session), code_b = driver::exit_code_of_run(b.session);
    driver::complain_of_turns(a.session, c.moves);
    for (const Side* side : {&a, &b}) print_diagnostics(side->session, base::Severity::warning);
    if (code_a == 2 || code_b == 2) return 2;
    c.stock = driver::compare_stock({a.session, a.request}, {b.session, b.request}, c.moves, tolerance.length);
    // Of a run that an alarm has ended nothing behind it is compared.
    c.block_stops_a = driver::block_stops(a.session), c.block_stops_b = driver::block_stops(b.session);
    const bool same_stops = c.block_stops_a == c.block_stops_b;
    const bool is_run = code_a == 0 && code_b == 0 && !c.stock.is_missed;
    c.is_full = is_run && same_stops && !c.moves.turns;
    const int code = !c.is_full ? 3 : does_the_same(c) ? 0 : 1;
    driver::OutputFile out(arguments.output);
    out.write(arguments.format == "json"
                  ? compared_json(c)
                  : compared_text(c) +
                        verdict_line(code, does_the_same(c), is_run && !same_stops, is_run && c.moves.turns));
    if (!deliver(arguments.output, out)) return 2;
    return deliver_picture(arguments, c, {a.session, a.request}, {b.session, b.request}) ? code : 2;
}

}  // namespace obrys::cli
