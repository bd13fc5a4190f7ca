/// A word of a control's cycle, and a word of a post's, is bound to something that a call of that cycle can say. What a
/// cycle has no member for it does not look at: a slip there would be a hole of another depth, without a message.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>

#include "cycles/expand/expand.hpp"
#include "cycles/turn/turning.hpp"
#include "dialect/heidenhain/cycles.hpp"
#include "dialect/rs274/fanuc.hpp"
#include "driver/control.hpp"
#include "program/traits.hpp"
#include "write/post.hpp"
#include "write/template.hpp"
#include "write/values.hpp"

namespace obrys::driver {
namespace {

using cl::CycleKind;
using cl::CycleRole;

std::span<const CycleRole> roles_of_kind(CycleKind kind) {
    return cycles::is_turning_cycle(kind) ? cycles::roles_of_turning(kind) : cycles::roles_of(kind);
}

bool is_made_here(CycleKind kind) { return cycles::is_turning_cycle(kind) || cycles::is_expanded(kind); }

bool cycle_can_say(CycleKind kind, CycleRole role) {
    const auto roles = roles_of_kind(kind);
    return std::find(roles.begin(), roles.end(), role) != roles.end();
}

std::string cycle_label(std::string_view who, std::string_view cycle, CycleKind kind, CycleRole role) {
    return std::string(who) + ", " + std::string(cycle) + " (" + std::string(cl::spelling(kind)) +
           "): " + std::string(cl::spelling(role));
}

/// Of each way of writing programs that can be read.
std::vector<const program::Traits*> traits_of_all() {
    std::set<const program::Traits*> out;
    for (const Control& control : all_controls())
        for (const Language& language : control.languages) {
            base::Sources sources;
            program::Names names;
            base::Diagnostics diagnostics;
            const std::uint32_t file = sources.add("A", "\n", language.numbers);
            for (const program::Unit& unit : language.read(file, sources, names, diagnostics, nullptr))
                out.insert(unit.traits);
        }
    return {out.begin(), out.end()};
}

/// Heights of a control that says depths from the top; what a series keeps for the next cycle.
bool is_for_the_control(const program::Traits& t, CycleRole role) {
    return role == CycleRole::kept || (role == CycleRole::clearance && t.hole_depth_from_top);
}

TEST(cycle_roles, WordsOfCannedCyclesSayWhatTheCycleCan) {
    std::size_t words = 0;
    for (const program::Traits* t : traits_of_all())
        for (const program::CannedCycle& c : t->canned) {
            if (!cycles::is_expanded(c.kind)) continue;
            for (const program::CannedWord& w : c.words) {
                ++words;
                EXPECT_TRUE(cycle_can_say(c.kind, w.role) || is_for_the_control(*t, w.role))
                    << cycle_label("canned", c.name, c.kind, w.role);
                if (w.beside != nullptr) {
                    EXPECT_TRUE(cycle_can_say(c.kind, w.beside->role))
                        << cycle_label("beside", c.name, c.kind, w.beside->role);
                }
            }
            for (const cl::CycleValue& v : c.fixed)
                EXPECT_TRUE(cycle_can_say(c.kind, v.role)) << cycle_label("fixed", c.name, c.kind, v.role);
        }
    EXPECT_GT(words, 100u);
}

TEST(cycle_roles, WordsOfTurningCyclesSayWhatTheCycleCan) {
    std::size_t words = 0;
    for (const program::Traits* t : traits_of_all())
        for (const program::CannedCycle& c : t->turning) {
            for (const program::CannedWord& w : c.words) {
                ++words;
                EXPECT_TRUE(cycle_can_say(c.kind, w.role)) << cycle_label("turning", c.name, c.kind, w.role);
            }
            for (const cl::CycleValue& v : c.fixed)
                EXPECT_TRUE(cycle_can_say(c.kind, v.role)) << cycle_label("fixed", c.name, c.kind, v.role);
        }
    for (int number = 700; number <= 760; number += 10) {
        const auto* c = obrys::dialect::rs274::find_turning_cycle(number);
        ASSERT_NE(c, nullptr) << number;
        for (const auto& list : {c->data, c->call, c->single, c->haas})
            for (const auto& w : list) {
                ++words;
                EXPECT_TRUE(cycle_can_say(c->kind, w.role)) << cycle_label("fanuc", "", c->kind, w.role);
            }
        for (const auto& list : {c->parameters, c->settings})
            for (const program::CycleDefault& d : list)
                EXPECT_TRUE(cycle_can_say(c->kind, d.role)) << cycle_label("default", "", c->kind, d.role);
    }
    EXPECT_GT(words, 60u);
}

TEST(cycle_roles, ParametersOfDefinedCyclesSayWhatTheCycleCan) {
    std::size_t parameters = 0;
    for (const obrys::dialect::heidenhain::Cycle& c : obrys::dialect::heidenhain::all_cycles()) {
        if (!is_made_here(c.kind)) continue;
        for (const obrys::dialect::heidenhain::CycleParameter& p : c.parameters) {
            ++parameters;
            EXPECT_TRUE(cycle_can_say(c.kind, p.role)) << cycle_label("CYCL DEF", c.name, c.kind, p.role);
        }
    }
    EXPECT_GT(parameters, 100u);
}

TEST(cycle_roles, PostsPrintWhatTheCycleCanSay) {
    std::size_t words = 0;
    for (const std::string& name : write::shipped_post_names()) {
        base::Sources sources;
        base::Diagnostics diagnostics;
        const std::string text(write::shipped_post(name)->text);
        const auto post = write::read_post(sources.add(name + ".toml", text), sources, diagnostics);
        ASSERT_TRUE(post) << name;
        for (const auto& [kind, forms] : post->cycles) {
            if (!is_made_here(kind)) continue;
            for (const write::CycleForm& form : forms)
                for (int r = 0; r <= static_cast<int>(CycleRole::turned_axes); ++r) {
                    const CycleRole role = static_cast<CycleRole>(r);
                    const write::ValueIndex value = write::index_of(role);
                    if (!write::says(form.define, value) && !write::says(form.call, value)) continue;
                    ++words;
                    EXPECT_TRUE(cycle_can_say(kind, role)) << cycle_label("post " + name, "", kind, role);
                }
        }
    }
    EXPECT_GT(words, 100u);
}

}  // namespace
}  // namespace obrys::driver
