#include "driver/keep.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "driver/compare_programs.hpp"
#include "driver/control.hpp"

namespace obrys::driver {

namespace codes = base::codes;

std::optional<rewrite::Language> find_language(const std::string& name, Session& s) {
    const std::optional<std::uint32_t> file = load_post(name, s);
    if (!file) return std::nullopt;
    auto language = rewrite::read_language(*file, s.sources, s.diagnostics, beside_post(name, s));
    const Control* control = language ? find_control(language->control) : nullptr;
    if (control != nullptr && control->is_word != nullptr) language->is_word = control->is_word;
    return language;
}

Kept keep(Session& s, const rewrite::Language& language, const std::string& name) {
    Kept out;
    out.translated.does = std::make_shared<const cl::Recording>(recording_of(s));  // which reads what it calls
    rewrite::Input input;
    input.main = s.main;
    input.find = [&s](std::string_view called) { return s.programs->find(called); };
    input.names = &s.programs->names();
    input.sources = &s.sources;
    input.lathe = s.job.machine.kind == shop::MachineKind::lathe;
    const program::Traits& traits = *s.main->traits;
    input.diameters =
        traits.begins_as_lathe || (!traits.radius_at_start && s.job.machine.defaults.diameter_programming);
    input.angles_from_zero = !traits.angles_from_zero.empty() && s.job.machine.control.angles_from_zero.value_or(true);
    s.programs->read_called();
    out.rewritten = rewrite::rewrite(input, language, name);
    *out.translated.text = out.rewritten.text;
    return out;
}

base::Diagnostic complaint_of(const rewrite::Note& note) {
    base::Diagnostic d;
    const bool lost = note.fate == rewrite::Fate::lost;
    d.severity = lost ? base::Severity::error : base::Severity::note;
    d.code = lost ? codes::not_written : codes::assumption;
    d.where = note.from;
    d.text = note.what;
    d.remedy = note.remedy;
    return d;
}

NameMap map_of(const rewrite::Rewritten& rewritten) {
    NameMap out;
    for (const rewrite::Renamed& n : rewritten.names)
        if (n.program.empty()) out.emplace_back(n.from, n.to);
    return out;
}

namespace {

std::string renamed(std::string_view name, const NameMap& map) {
    for (const auto& [from, to] : map)
        if (base::equals_ignoring_case(from, base::trim(name))) return to;
    return std::string(name);
}

}  // namespace

std::vector<std::string> mapped(const std::vector<std::string>& set, const NameMap& map) {
    std::vector<std::string> out;
    for (const std::string& text : set) {
        const std::size_t equal = std::min(text.find('='), text.size());
        out.push_back(renamed(std::string_view(text).substr(0, equal), map) + text.substr(equal));
    }
    return out;
}

shop::GivenValues mapped(const shop::GivenValues& given, const NameMap& map) {
    shop::GivenValues out;
    for (const auto& [name, value] : given) out[renamed(name, map)] = value;
    return out;
}

namespace {

/// The number that an expression is: a constant with or without signs.
std::optional<double> constant_of(const program::Unit& unit, program::ExprId id) {
    const program::Expr& e = unit.exprs[id];
    if (e.kind == program::ExprKind::number) return unit.numbers[e.a];
    if (e.kind != program::ExprKind::unary) return std::nullopt;
    const auto v = constant_of(unit, e.a);
    const auto op = static_cast<program::Operator>(e.op);
    if (op == program::Operator::negate && v) return -*v;
    return op == program::Operator::plus ? v : std::nullopt;
}

/// Parameters that all programs have in common and that are given one constant, with it. What they compute is not the
/// program's to be set, nor what the definition of a cycle says.
std::map<std::string, double> inputs_by_name(const Session& s) {
    std::map<std::string, std::vector<double>> assigned;
    const auto take = [&](const program::Unit& unit, program::ExprId target, std::optional<double> value) {
        if (target == program::no_expr) return;
        const program::Expr& e = unit.exprs[target];
        if (e.kind == program::ExprKind::parameter && value)
            assigned[program::parameter_name(*unit.traits, e.a)].push_back(*value);
    };
    for (const auto& unit : s.programs->units()) {
        for (const program::Assign& a : unit->assigns) take(*unit, a.target, constant_of(*unit, a.value));
        for (const program::For& f : unit->fors) take(*unit, f.variable, 0.0);  // what counts is no input
    }
    std::map<std::string, double> out;
    for (const auto& [name, values] : assigned)
        if (values.size() == 1 && values.front() != 0) out[name] = values.front();
    return out;
}

std::string decimal(double v) {
    std::string text = base::fixed(v, 3);  // that every control can take: finer ones add up to others where it rounds
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

/// The run raised an alarm, or something is wrong with it.
bool has_finding(const Session& s) {
    return std::any_of(s.diagnostics.all().begin(), s.diagnostics.all().end(), [](const base::Diagnostic& d) {
        return base::kind_of(d.code) == base::CodeKind::finding && d.code != codes::runs_otherwise;
    });
}

/// Something was not understood or not known. That a called program stands in the file and these values do not lead to
/// it is no reason.
bool is_unknown(const Session& s) {
    return std::any_of(s.diagnostics.all().begin(), s.diagnostics.all().end(), [](const base::Diagnostic& d) {
        return base::kind_of(d.code) == base::CodeKind::unchecked && d.code != codes::not_run;
    });
}

}  // namespace

std::vector<std::vector<std::string>> other_values(const Session& s, const rewrite::Rewritten& what,
                                                   std::size_t count) {
    std::map<std::string, double> inputs = inputs_by_name(s);
    const NameMap map = map_of(what);
    std::erase_if(inputs, [&](const auto& input) {
        return std::none_of(map.begin(), map.end(), [&](const auto& pair) { return pair.first == input.first; });
    });
    // 1 and -1 are choices, as climb and up-cut; where there is nothing else, they are what can be varied.
    const auto is_choice = [](const auto& input) { return input.second == 1 || input.second == -1; };
    if (!std::all_of(inputs.begin(), inputs.end(), is_choice)) std::erase_if(inputs, is_choice);
    std::vector<std::vector<std::string>> out;
    std::mt19937 random(1);  // NOLINT: the same values every time
    std::uniform_int_distribution<int> share(-200, 200);
    for (std::size_t n = 0; n < count && !inputs.empty(); ++n) {
        std::vector<std::string>& set = out.emplace_back();
        for (const auto& [name, value] : inputs)
            set.push_back(name + "=" + decimal(value * (1 + share(random) / 1000.0)));
    }
    return out;
}

Proved prove_with(const std::vector<std::string>& set, const Kept& kept, const write::Post& post,
                  const Request& request, const compare::Tolerance& tolerance, std::string& what) {
    Session run;
    Request own = request;
    own.set.insert(own.set.end(), set.begin(), set.end());
    own.prints_nowhere = true;
    own.folders = std::make_shared<Folders>(request.folders->storage());
    Proved out;
    out.why_not = "the program could not be run with these values";
    if (!open(own, run)) return out;
    Translated translated;
    translated.text = kept.translated.text;
    translated.does = std::make_shared<const cl::Recording>(recording_of(run));
    const NameMap map = map_of(kept.rewritten);
    const bool alarm = has_finding(run), unknown = is_unknown(run);
    // What the program computes is rounded there as its own control does it, and here as the other one does.
    compare::Tolerance within = tolerance;
    constexpr double slack = 1 + 1e-6;
    within.length = std::max(within.length, 0.5 * (increment_of(run) + post.increment) * slack);
    out = prove(translated, post, own, run, within, {mapped(own.set, map), mapped(run.job.variables, map)});
    if (out.run != nullptr && alarm != has_finding(*out.run)) {
        out.differs = true;
        if (out.proof == Proof::same) out.proof = Proof::differs;
        what = alarm ? "the program ends with an alarm, what was written does not"
                     : "what was written ends with an alarm, the program does not";
    }
    for (const base::Diagnostic& d : run.diagnostics.all())
        if (d.code == codes::runs_otherwise && what.empty()) what = d.text;
    if (out.run == nullptr || !out.why_not.empty()) return out;
    if (unknown || is_unknown(*out.run))
        out.proof = Proof::not_compared;
    else
        out.proof = out.differs ? Proof::differs : Proof::same;
    return out;
}

}  // namespace obrys::driver
