#include "shop/job.hpp"

#include <utility>

namespace obrys::shop {

std::string_view name(Scope scope) {
    switch (scope) {
        case Scope::all: return "all";
        case Scope::part: return "part";
        case Scope::collisions: return "collisions";
        case Scope::motion: return "motion";
    }
    return "all";
}

std::optional<Scope> scope_named(std::string_view wanted) {
    for (const Scope scope : {Scope::all, Scope::part, Scope::collisions, Scope::motion})
        if (name(scope) == wanted) return scope;
    return std::nullopt;
}

void apply_defaults(const DefaultsOverride& from, ControlDefaults& to) {
    to.diameter_programming = from.diameter_programming.value_or(to.diameter_programming);
    to.inch = from.inch.value_or(to.inch);
    to.feed_per_rev = from.feed_per_rev.value_or(to.feed_per_rev);
    to.plane = from.plane.value_or(to.plane);
    to.circle_tolerance = from.circle_tolerance.value_or(to.circle_tolerance);
}

void use_machine(Job& job, Machine machine) {
    apply_defaults(job.defaults, machine.defaults);
    for (const auto& [number, origin] : job.datums) machine.datums[number] = origin;
    job.machine = std::move(machine);
}

}  // namespace obrys::shop
