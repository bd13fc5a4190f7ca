#include "sim/cost/cost.hpp"

#include <cmath>

namespace obrys::sim::cost {

namespace {

constexpr double minute = 60, hour = 60, percent = 100;

/// Of the operator, with overhead, and of the machine, a minute.
double wage(const shop::CostTable& t) { return t.wage / hour * (1 + t.overhead / percent); }
double machine(const shop::CostTable& t) { return t.machine / hour; }

/// A tool's share in a piece: of its price and regrinds over all its lives, and of the time to change it.
double share(const shop::CostTable& t, const shop::CostTool& tool) {
    const double lives = *tool.cut_s / minute / tool.life_min;
    const double a_life = (tool.price + (tool.lives - 1) * tool.regrind) / tool.lives;
    return lives * (a_life + tool.change_min * (wage(t) + machine(t)));
}

void add(Cost& c, const char* name, double money) {
    if (money != 0) c.items.push_back({name, money});
}

}  // namespace

Cost cost_of(const shop::CostTable& t, double seconds) {
    Cost c;
    const double minutes = seconds / minute / t.utilisation;
    c.items.push_back({"wages", minutes * wage(t)});
    c.items.push_back({"machine", minutes * machine(t)});
    c.items.push_back({"material", t.material});
    if (t.batch) add(c, "set-up", t.set_up_min * (wage(t) + machine(t)) / *t.batch);
    add(c, "loading", t.load_s / minute * (wage(t) + machine(t)));
    double tools = 0;
    for (const shop::CostTool& tool : t.tools)
        if (tool.cut_s)
            tools += share(t, tool);
        else
            c.tools_left_out.push_back(tool.name);
    add(c, "tools", tools);
    if (t.pieces) {
        add(c, "fixture", t.fixture / *t.pieces);
        add(c, "programming", t.programming / *t.pieces);
    }
    for (const Item& i : c.items) c.exact += i.money;
    if (t.scrap > 0) {  // what the others cost is lost with each that is thrown away
        const double lost = c.exact * (1 / (1 - t.scrap / percent) - 1);
        c.items.push_back({"scrap", lost});
        c.exact += lost;
    }
    c.per_piece = t.rounding ? std::round(c.exact / *t.rounding) * *t.rounding : c.exact;
    if (t.batch) c.per_batch = *t.batch * c.per_piece;
    if (t.pieces) c.per_year = *t.pieces * c.per_piece;
    return c;
}

}  // namespace obrys::sim::cost
