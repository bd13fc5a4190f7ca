/// obrys compare.

#include "compare/compare.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "driver/compare_programs.hpp"
#include "driver/keep.hpp"
#include "milled.hpp"
#include "session.hpp"

namespace obrys::cli {

namespace {

/// One of the two: its session stays, since places lie in its texts.
struct Side {
    driver::Session session;
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

void open_side(const Arguments& a, const std::string& input, const driver::NameMap& map, Side& side) {
    Arguments own = a;
    own.request.input = input;
    own.request.set = driver::mapped(a.request.set, map);
    if (!driver::is_stream(input)) return static_cast<void>(side.is_open = open(own, side.session));
    side.is_open = driver::open_stream(input, side.session);
    if (!side.is_open) print_diagnostics(side.session, base::Severity::warning);
}

std::string place(const Side& side, const std::optional<base::Span>& at) {
    if (!at || at->file >= side.session.sources.size()) return {};
    const auto p = side.session.sources.position(*at);
    return side.session.sources[at->file].name + ":" + std::to_string(p.line);
}

std::string as_text(const Side& a, const Side& b, const compare::Result& r) {
    std::string out;
    for (std::size_t i = 0; i < compare::aspect_count; ++i) {
        const auto aspect = static_cast<compare::Aspect>(i);
        const compare::Difference* d = r.of(aspect);
        out += std::string(compare::name_of(aspect)) + ": ";
        if (d == nullptr) {
            out += aspect == compare::Aspect::motion ? "equal, " + std::to_string(r.moves_a) + " moves\n"
                   : r.is_equal(aspect)
                       ? "equal\n"
                       : "equal up to move " + std::to_string(*r.looked_to) + ", not compared behind it\n";
            continue;
        }
        const std::string at_a = place(a, d->in_a), at_b = place(b, d->in_b);
        out += "differs first at move " + std::to_string(d->move) + (at_a.empty() ? "" : ", " + at_a) +
               (at_b.empty() ? "" : ", " + at_b) + ": " + d->what + "\n";
    }
    return out;
}

nlohmann::ordered_json as_json(const Side& side, const std::optional<base::Span>& at) {
    if (!at || at->file >= side.session.sources.size()) return nullptr;
    return {{"file", side.session.sources[at->file].name}, {"line", side.session.sources.position(*at).line}};
}

std::string as_json(const Side& a, const Side& b, const compare::Result& r) {
    nlohmann::ordered_json out;
    for (std::size_t i = 0; i < compare::aspect_count; ++i) {
        const auto aspect = static_cast<compare::Aspect>(i);
        auto& equal = out["equal"][std::string(compare::name_of(aspect))];
        equal = r.of(aspect) == nullptr;
        if (equal && !r.is_equal(aspect)) equal = nullptr;  // up to `compared_moves`; behind it nobody knows
    }
    out["moves"] = {{"a", r.moves_a}, {"b", r.moves_b}};
    out["compared_moves"] = r.looked_to.value_or(r.moves_a);
    out["differences"] = nlohmann::ordered_json::array();
    for (const compare::Difference& d : r.first)
        out["differences"].push_back({{"aspect", compare::name_of(d.aspect)},
                                      {"move", d.move},
                                      {"what", d.what},
                                      {"a", as_json(a, d.in_a)},
                                      {"b", as_json(b, d.in_b)}});
    out["first_difference"] = r.first.empty() ? nlohmann::ordered_json(nullptr) : out["differences"].front();
    return out.dump(2) + "\n";
}

}  // namespace

int compare(const Arguments& arguments) {
    Side a, b;
    const auto map = name_map(arguments);
    if (!map) return 2;
    open_side(arguments, arguments.request.input, {}, a);
    open_side(arguments, arguments.other, *map, b);
    if (!a.is_open || !b.is_open) return 2;
    compare::Tolerance tolerance;
    tolerance.length = arguments.same_place;
    const compare::Result r = driver::compare_sessions(a.session, b.session, tolerance);
    for (const Side* side : {&a, &b}) print_diagnostics(side->session, base::Severity::warning);
    const int code_a = driver::exit_code_of_run(a.session), code_b = driver::exit_code_of_run(b.session);
    if (code_a == 2 || code_b == 2) return 2;
    driver::OutputFile out(arguments.output);
    out.write(arguments.format == "json" ? as_json(a, b, r) : as_text(a, b, r));
    if (!deliver(arguments.output, out)) return 2;
    if (code_a != 0 || code_b != 0) return 3;  // of a run that an alarm has ended nothing behind it is compared
    const bool same = std::none_of(r.first.begin(), r.first.end(),
                                   [](const compare::Difference& d) { return compare::is_done(d.aspect); });
    return same ? 0 : 1;
}

}  // namespace obrys::cli
