/// Contours made of several: CONTOUR DEF, and DECLARE CONTOUR with formulas in a program that SEL CONTOUR names.
/// Source: HEIDENHAIN iTNC 530 cycle programming, "SL cycles with (simple) contour formula", from memory. Which operator
/// binds more strongly it does not say: they are taken from left to right.

#include <cmath>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "geom/boolean.hpp"
#include "interp/contour_cycle.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Region;
using program::ContourOperator;
using program::ContourStatement;
using Kind = ContourStatement::Kind;

namespace {

constexpr std::size_t most_choices = 10'000;

ContourChoice choice_of(Run& run, const ContourStatement& s) {
    ContourChoice c;
    c.statement = &s;
    c.unit = &run.unit();
    const double unit = run.modal.inch_geometry ? 25.4 : 1;
    for (const program::ContourPart& p : s.parts) {
        ContourChoice::Part part;
        part.name = printed(evaluate(run, p.label != program::no_expr ? p.label : p.program));
        part.depth = p.depth == program::no_expr ? NAN : std::abs(number(run, p.depth) * unit);
        if (p.depth != program::no_expr && std::isnan(part.depth))
            unchecked(run, codes::unknown_value, p.where, "the depth of this contour is not known: that of the cycle is taken");
        c.parts.push_back(std::move(part));
    }
    return c;
}

/// What a part does to the area.
enum class Effect : std::uint8_t { whole, none, refused };
Effect effect_of(const program::ContourPart& p, double depth, double of_cycle) {
    if (std::isnan(depth) || depth == 0) return Effect::whole;
    if (!(depth < std::abs(of_cycle) - 1e-9)) return p.island ? Effect::none : Effect::whole;
    return Effect::refused;
}

/// Reads contours of parts; a complaint makes it `failed`.
class Parts {
public:
    Parts(Run& run, const cycles::Demand& demand)
        : run_(run), depth_(demand.get(program::CycleRole::depth)) {}

    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] Region area(const ContourChoice& c, std::size_t i) {
        const program::ContourPart& p = c.statement->parts[i];
        const std::string& name = c.parts[i].name;
        const Effect effect = effect_of(p, c.parts[i].depth, depth_);
        if (effect == Effect::refused)
            return unchecked(run_, codes::unsupported, p.where,
                             "a contour with another depth than the cycle's is not run: the cycle is left out"),
                   fail();
        if (effect == Effect::none) return {};
        const bool label = p.label != program::no_expr;
        const Unit* unit = label ? c.unit : find_named_program(run_, name, p.where);
        if (unit == nullptr) return fail();
        const auto elements = label ? elements_of_label(run_, *unit, name) : elements_of_program(run_, *unit);
        if (!elements) return alarm("is missing or does not end", label, name, p);
        const geom::Contour contour = contour_of(run_, *elements);
        if (!is_known(contour))
            return unchecked(run_, codes::unknown_value, p.where,
                             "the contour " + name + " depends on a value that is not known: the cycle is not run"),
                   fail();
        if (!contour.closed) return alarm("is not closed", label, name, p);
        return geom::tidied({contour});
    }

private:
    Region fail() {
        failed_ = true;
        return {};
    }
    Region alarm(const std::string& what, bool label, const std::string& name, const program::ContourPart& p) {
        interp::alarm(run_, codes::contour, p.where, "the contour of " + std::string(label ? "label " : "program ") + name + " " + what);
        return fail();
    }

    Run& run_;
    double depth_;
    bool failed_ = false;
};

Region combined(ContourOperator op, const Region& a, const Region& b) {
    switch (op) {
        case ContourOperator::unite: return geom::unite(a, b);
        case ContourOperator::intersect: return geom::intersect(a, b);
        case ContourOperator::subtract: return geom::subtract(a, b);
        case ContourOperator::either: return geom::unite(geom::subtract(a, b), geom::subtract(b, a));
        case ContourOperator::contour: break;
    }
    return a;
}

Region of_parts(const ContourChoice& c, Parts& parts) {
    Region pockets, islands;
    for (std::size_t i = 0; i < c.parts.size() && !parts.failed(); ++i) {
        Region& sum = c.statement->parts[i].island ? islands : pockets;
        const Region area = parts.area(c, i);
        sum = sum.empty() ? area : geom::unite(sum, area);
    }
    return islands.empty() ? pockets : geom::subtract(pockets, islands);
}

using Areas = std::map<std::uint32_t, Region>;

/// Nothing after an alarm: a contour of the formula is not declared.
std::optional<Region> of_formula(Run& run, const ContourStatement& s, const Areas& areas) {
    std::vector<Region> values;
    for (const program::ContourNode& n : s.nodes) {
        if (n.op != ContourOperator::contour) {
            values.push_back(combined(n.op, values[n.left], values[n.right]));
            continue;
        }
        const auto found = areas.find(n.number);
        if (found == areas.end()) {
            alarm(run, codes::contour, s.where, "the contour QC" + std::to_string(n.number) + " is not declared",
                  "declare it with DECLARE CONTOUR before the formula");
            return std::nullopt;
        }
        values.push_back(found->second);
    }
    if (s.mixed)
        assume(run, s.where, "different operators side by side in a contour formula are taken from left to right",
               "write parentheses");
    return std::move(values.back());
}

/// The contour is that of the last formula; where there is none, the one declared last.
std::optional<Region> of_choices(Run& run, Parts& parts) {
    Areas areas;
    std::optional<std::uint32_t> declared, computed;
    const std::vector<ContourChoice> choices = run.contour_choices;
    for (const ContourChoice& c : choices) {
        const ContourStatement& s = *c.statement;
        if (s.kind == Kind::declaration) {
            areas[s.number] = parts.area(c, 0);
            declared = s.number;
        } else if (s.kind == Kind::formula) {
            auto value = of_formula(run, s, areas);
            if (!value) return std::nullopt;
            areas[s.number] = std::move(*value);
            computed = s.number;
        }
        if (parts.failed()) return std::nullopt;
    }
    if (const auto which = computed ? computed : declared) return areas[*which];
    unchecked(run, codes::contour, run.here(), "the program of SEL CONTOUR declares no contour: the cycle is not run");
    return std::nullopt;
}

}  // namespace

void contour_statement(Run& run, const ContourStatement& s) {
    auto& choices = run.contour_choices;
    const bool adds = s.kind == Kind::declaration || s.kind == Kind::formula;
    if (!adds || (!choices.empty() && choices.front().statement->kind == Kind::definition)) choices.clear();
    if (choices.size() >= most_choices)
        return alarm(run, codes::contour, s.where, "more than " + std::to_string(most_choices) + " contours are declared");
    choices.push_back(choice_of(run, s));
    if (run.stopped || s.kind != Kind::selection) return;
    const Value name = evaluate(run, s.program);
    if (run.stopped) return;
    if (const Unit* unit = find_named_program(run, printed(name), s.where)) enter(run, *unit, nullptr, s.where);
}

std::optional<Region> chosen_area(Run& run, const cycles::Demand& demand) {
    Parts parts(run, demand);
    if (run.contour_choices.front().statement->kind != Kind::definition) return of_choices(run, parts);
    const ContourChoice c = run.contour_choices.front();
    if (c.parts.empty()) {
        unchecked(run, codes::contour, run.here(), "the contour of this cycle is not known: the cycle is not run");
        return std::nullopt;
    }
    Region area = of_parts(c, parts);
    if (parts.failed()) return std::nullopt;
    return area;
}

}  // namespace obrys::interp
