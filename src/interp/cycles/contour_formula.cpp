/// Contours made of several: CONTOUR DEF, and DECLARE CONTOUR with formulas in a program that SEL CONTOUR names.
/// Source: HEIDENHAIN iTNC 530 cycle programming, "SL cycles with (simple) contour formula", from memory. Which
/// operator binds more strongly it does not say: they are taken from left to right.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "geom/boolean.hpp"
#include "interp/cycles/contour_cycle.hpp"
#include "interp/cycles/cycles.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Region;
using program::ContourOperator;
using program::ContourStatement;
using Kind = ContourStatement::Kind;

namespace {

constexpr std::size_t most_choices = 10'000;

ContourChoice choice_of(Reckoning& run, const ContourStatement& s) {
    ContourChoice c;
    c.statement = &s;
    c.unit = &run.unit();
    const double unit = length_unit(run.modal);
    for (const program::ContourPart& p : s.parts) {
        ContourChoice::Part part;
        part.name = printed(evaluate(run, p.label != program::no_expr ? p.label : p.program));
        part.depth = p.depth == program::no_expr ? NAN : std::abs(number(run, p.depth) * unit);
        if (p.depth != program::no_expr && std::isnan(part.depth))
            unchecked(run, codes::unknown_value, p.where,
                      "the depth of this contour is not known: that of the cycle is taken");
        c.parts.push_back(std::move(part));
    }
    return c;
}

/// Reads contours of parts; a complaint makes it `failed`.
class PartsOfFormula {
public:
    PartsOfFormula(Moving& run, ContourElements& elements) : run_(run), elements_(elements) {}

    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] Region area(const ContourChoice& c, std::size_t i) {
        const program::ContourPart& p = c.statement->parts[i];
        const std::string& name = c.parts[i].name;
        const bool label = p.label != program::no_expr;
        const Unit* unit = label ? c.unit : find_named_program(run_, name, p.where);
        if (unit == nullptr) return fail();
        const auto elements = (label ? run_.onward->label(*unit, name) : run_.onward->program(*unit)).said(run_);
        if (!elements) return alarm("is missing or does not end", label, name, p);
        const geom::Contour contour = contour_of(run_, *elements, elements_);
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
        interp::alarm(run_, codes::contour, p.where,
                      "the contour of " + std::string(label ? "label " : "program ") + name + " " + what);
        return fail();
    }

    Moving& run_;
    ContourElements& elements_;
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

/// Where a part begins and ends below the surface: a pocket goes from it to its depth, an island from its top to the
/// floor.
struct Extent {
    double top = 0, bottom = 0;
};
Extent extent_of(const program::ContourPart& p, double depth, double floor) {
    const double own = std::isnan(depth) ? 0 : std::min(depth, floor);
    if (p.island) return {own, floor};
    return {0, own == 0 ? floor : own};
}

ContourLayer layer_of(Region area, double surface, const Extent& e) {
    ContourLayer l;
    l.task.area = std::move(area);
    l.instead = {{cl::CycleRole::surface, surface - e.top}, {cl::CycleRole::depth, e.top - e.bottom}};
    return l;
}

/// The layers between all tops and bottoms; one of them where no contour has a depth of its own.
std::optional<std::vector<ContourLayer>> of_parts(Moving& run, const ContourChoice& c, const cycles::Demand& d,
                                                  ContourElements& elements) {
    PartsOfFormula parts(run, elements);
    const double floor = std::abs(d.get(cl::CycleRole::depth));
    std::vector<Region> areas;
    std::vector<Extent> extents;
    std::vector<ContourLayer> layers;
    std::vector<double> levels{0, floor};
    for (std::size_t i = 0; i < c.parts.size(); ++i) {
        areas.push_back(parts.area(c, i));
        if (parts.failed()) return std::nullopt;
        extents.push_back(extent_of(c.statement->parts[i], c.parts[i].depth, floor));
        levels.push_back(extents.back().top);
        levels.push_back(extents.back().bottom);
    }
    if (!(floor > 0) || !std::isfinite(floor)) {  // the cycle complains of its depth
        layers.emplace_back().task.area = std::move(areas.front());
        return layers;
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end(), [](double a, double b) { return b - a < 1e-9; }),
                 levels.end());
    for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
        const Extent e{levels[k], levels[k + 1]};
        Region pockets, islands;
        for (std::size_t i = 0; i < areas.size(); ++i) {
            if (extents[i].top > e.top + 1e-9 || extents[i].bottom < e.bottom - 1e-9) continue;
            Region& sum = c.statement->parts[i].island ? islands : pockets;
            sum = sum.empty() ? areas[i] : geom::unite(sum, areas[i]);
        }
        Region area = islands.empty() ? std::move(pockets) : geom::subtract(pockets, islands);
        if (!area.empty()) layers.push_back(layer_of(std::move(area), d.get(cl::CycleRole::surface), e));
    }
    const bool one = levels.size() <= 2;
    if (one && !layers.empty()) layers.front().instead.clear();
    if (!one) assume(run, run.here(), "contours of different depth are milled in layers, from above down");
    if (one || d.kind != cl::CycleKind::floor_finish) return layers;
    unchecked(run, codes::unsupported, run.here(), "floor finishing of contours of different depth is not run");
    return std::nullopt;
}

using Areas = std::map<std::uint32_t, Region>;

/// Nothing after an alarm: a contour of the formula is not declared.
std::optional<Region> of_formula(Saying& run, const ContourStatement& s, const Areas& areas) {
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
std::optional<Region> of_choices(Cycling& run, double floor, ContourElements& elements) {
    PartsOfFormula parts(run, elements);
    Areas areas;
    std::optional<std::uint32_t> declared, computed;
    const std::vector<ContourChoice> choices = run.contour_choices;
    for (const ContourChoice& c : choices) {
        const ContourStatement& s = *c.statement;
        if (s.kind == Kind::declaration) {
            if (c.parts[0].depth > 0 && c.parts[0].depth < floor - 1e-9) {
                unchecked(run, codes::unsupported, s.where,
                          "a contour of a formula with less depth than the cycle is not run: the cycle is left out");
                return std::nullopt;
            }
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

void contour_statement(Cycling& run, const ContourStatement& s) {
    auto& choices = run.contour_choices;
    const bool adds = s.kind == Kind::declaration || s.kind == Kind::formula;
    if (!adds || (!choices.empty() && choices.front().statement->kind == Kind::definition)) choices.clear();
    if (choices.size() >= most_choices)
        return alarm(run, codes::contour, s.where,
                     "more than " + std::to_string(most_choices) + " contours are declared");
    choices.push_back(choice_of(run, s));
    if (run.stopped || s.kind != Kind::selection) return;
    const Value name = evaluate(run, s.program);
    if (run.stopped) return;
    if (const Unit* unit = find_named_program(run, printed(name), s.where)) enter(run, *unit, nullptr, s.where);
}

std::optional<std::vector<ContourLayer>> chosen_layers(Cycling& run, const cycles::Demand& demand,
                                                       ContourElements& elements) {
    const ContourChoice c = run.contour_choices.front();
    std::optional<std::vector<ContourLayer>> layers;
    if (c.statement->kind != Kind::definition) {
        auto area = of_choices(run, std::abs(demand.get(cl::CycleRole::depth)), elements);
        if (!area) return std::nullopt;
        layers.emplace(1);
        layers->front().task.area = std::move(*area);
    } else if (c.parts.empty()) {
        unchecked(run, codes::contour, run.here(), "the contour of this cycle is not known: the cycle is not run");
    } else {
        layers = of_parts(run, c, demand, elements);
    }
    if (!layers) return std::nullopt;
    if (layers->empty() || layers->front().task.area.empty()) {
        unchecked(run, codes::contour, run.here(),
                  "nothing is left of the contour of this cycle: the cycle is not run");
        return std::nullopt;
    }
    return layers;
}

}  // namespace obrys::interp
