#include "driver/not_run.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/text.hpp"

namespace obrys::driver {

namespace {

/// "12" of "O0012" and "0012"; other names as they are.
std::string plain(std::string_view written) {
    std::string name = base::to_upper(base::trim(written));
    const std::size_t begin = name.starts_with("O") ? 1 : 0;
    if (name.size() <= begin || name.find_first_not_of("0123456789", begin) != std::string::npos) return name;
    name.erase(0, std::min(name.find_first_not_of('0', begin), name.size() - 1));
    return name;
}

/// Does the text of the program itself name a coordinate?
bool names_coordinates(const program::Unit& unit) {
    return std::any_of(unit.words.begin(), unit.words.end(), [](const program::Word& w) {
        const program::Code c = program::code_of(w);
        return c <= program::Code::w || c == program::Code::polar_radius || c == program::Code::polar_angle;
    });
}

}  // namespace

bool holds_subprograms_alone(const std::vector<const program::Unit*>& in_file,
                             const std::vector<const program::Unit*>& entered, const program::Unit& main) {
    const bool called = std::any_of(entered.begin(), entered.end(), [&](const auto* u) { return u != &main; });
    return in_file.size() > 1 && !called && !names_coordinates(main);
}

bool is_called(const program::Unit& unit, std::string_view written) { return plain(unit.name) == plain(written); }

std::vector<const program::Unit*> led_to(const std::vector<const program::Unit*>& in_file,
                                         std::vector<const program::Unit*> reached, const program::Names& names) {
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const program::Unit& from = *reached[i];
        for (const program::Call& call : from.calls) {
            if (call.kind != program::CallKind::by_name) continue;
            for (const program::Unit* unit : in_file)
                if (is_called(*unit, names.text(call.name)) &&
                    std::find(reached.begin(), reached.end(), unit) == reached.end())
                    reached.push_back(unit);
        }
    }
    return reached;
}

void say_what_was_not_run(const std::vector<const program::Unit*>& in_file,
                          const std::vector<const program::Unit*>& entered, bool all, base::Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < in_file.size(); ++i) {
        const program::Unit& unit = *in_file[i];
        const bool run = std::find(entered.begin(), entered.end(), &unit) != entered.end();
        if (run || !(unit.startable || all) || unit.statements.empty()) continue;
        const bool again = std::any_of(in_file.begin(), in_file.begin() + static_cast<std::ptrdiff_t>(i),
                                       [&](const program::Unit* u) { return u->name == unit.name; });
        base::Diagnostic d;
        d.severity = base::Severity::warning;
        d.code = base::codes::not_run;
        d.where = {unit.file, unit.begin, unit.begin};
        const std::string shown = unit.startable || !unit.name.starts_with("O") ? unit.name : "o" + unit.name.substr(1);
        d.text = (unit.startable ? "the program " : "the subprogram ") + shown +
                 (again ? ", which the file holds a second time," : " of this file") + std::string(nothing_calls_it);
        d.remedy = again ? "give it a number of its own"
                   : !unit.startable
                       ? "check a program that calls it"
                       : "begin with it: start = \"" + unit.name + "\" in the job; or keep it in a file of its own";
        diagnostics.add(std::move(d));
    }
}

bool is_of_no_run(const base::Diagnostic& d) {
    return d.code == base::codes::not_run &&
           (d.text.ends_with(nothing_calls_it) || d.text.find("never run") != std::string::npos);
}

void say_that_nothing_moves(base::Diagnostics& diagnostics, const program::Unit* main) {
    base::Diagnostic d;
    d.severity = base::Severity::warning;
    d.code = base::codes::not_run;
    if (main != nullptr) d.where = {main->file, main->begin, main->begin};
    d.text = "nothing moves: what is set here for a program that calls it is not compared";
    d.remedy = "take the program that calls it";
    diagnostics.add(std::move(d));
}

}  // namespace obrys::driver
