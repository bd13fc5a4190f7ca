/// obrys data.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "commands.hpp"
#include "driver/cutting/tables.hpp"
#include "milled.hpp"
#include "report/cutting/data.hpp"
#include "session.hpp"

namespace obrys::cli {

namespace {

using sim::cutting::Value;

sim::cutting::MachineLimits limits_of(const shop::Machine& m) {
    sim::cutting::MachineLimits l;
    l.least_speed = m.spindle.min;
    l.most_speed = m.spindle.max;
    if (m.max_feed > 0) l.most_feed = m.max_feed;
    constexpr double watts = 1000;
    if (m.spindle.power) l.most_power = watts * *m.spindle.power;
    return l;
}

/// What cannot be asked so; empty: nothing.
std::string fault_of(const CuttingArguments& c) {
    const sim::cutting::Asked& s = c.asked;
    const bool given = std::any_of(s.given.begin(), s.given.end(), [](double value) { return std::isfinite(value); });
    if (!given) return "nothing is given: obrys data --vc 160 --diameter 10 --teeth 4 --fz 0.05";
    if ((c.kind == "bull-nose") != (s.corner_radius > 0))
        return "--corner-radius belongs to --kind bull-nose, and that needs it";
    if (c.kind == "turning" && std::isfinite(s[Value::teeth]))
        return "--teeth means nothing for --kind turning: its feed is that of a revolution";
    if (c.kind != "ball" && c.kind != "bull-nose" && std::isfinite(s[Value::effective_diameter]))
        return "--d-eff is that of a round mill: --kind ball or bull-nose";
    const double diameter = s[Value::diameter];
    if (diameter < 2 * s.corner_radius) return "--corner-radius must not be more than half of --diameter";
    if (c.kind == "ball" && s[Value::depth] > diameter / 2)
        return "--ap must not be more than half of the ball's --diameter: above it is its shank's side";
    if (s[Value::width] > diameter) return "--ae must not be more than --diameter";
    return "";
}

void set_kind(const std::string& kind, sim::cutting::Asked& asked) {
    if (kind == "turning") asked.process = sim::cutting::Process::turning;
    if (kind == "drill") asked.process = sim::cutting::Process::drilling;
    asked.ball = kind == "ball";
}

int fail(const driver::cutting::Texts& texts) {
    print_diagnostics(texts);
    return 2;
}

}  // namespace

int data(const Arguments& a) {
    driver::cutting::Texts texts;
    std::vector<driver::fs::path> inputs(a.cutting.materials.begin(), a.cutting.materials.end());
    if (!a.request.machine.empty()) inputs.emplace_back(a.request.machine);
    if (!may_write(a, inputs)) return 2;
    const auto all = driver::cutting::materials(a.cutting.materials, texts);
    if (!all) return fail(texts);
    if (a.cutting.list) {
        const bool json = a.format == "json";
        return deliver(a.output,
                       json ? report::cutting::materials_as_json(*all) : report::cutting::materials_as_text(*all))
                   ? 0
                   : 2;
    }
    if (const std::string fault = fault_of(a.cutting); !fault.empty()) {
        std::fprintf(stderr, "obrys data: %s\n  how it is called: obrys help data\n", fault.c_str());
        return 2;
    }
    report::cutting::DataSubject subject{a.cutting.asked, {}, {}};
    set_kind(a.cutting.kind, subject.asked);
    if (!a.cutting.material.empty()) {
        subject.asked.material =
            driver::cutting::material_named(a.cutting.material, *all, texts.diagnostics, driver::nowhere);
        if (subject.asked.material == nullptr) return fail(texts);
    }
    sim::cutting::MachineLimits limits;
    if (!a.request.machine.empty()) {
        const auto machine = driver::cutting::machine_named(a.request.machine, texts);
        if (!machine) return fail(texts);
        limits = limits_of(*machine);
        subject.machine = machine->name;
    }
    subject.data = sim::cutting::solve(subject.asked, limits);
    const std::string text = a.format == "json" ? report::cutting::as_json(subject) : report::cutting::as_text(subject);
    if (!deliver(a.output, text)) return 2;
    if (!subject.data.differences.empty() || subject.data.impossible || subject.data.feed_implausible) return 1;
    const bool found = std::isfinite(subject.data[Value::speed]) || std::isfinite(subject.data[Value::feed]);
    return found ? 0 : 3;
}

}  // namespace obrys::cli
