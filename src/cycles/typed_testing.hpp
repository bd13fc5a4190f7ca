#pragma once
/// Shared by the tests of structs of cycles.

#include <gtest/gtest.h>

#include "cycles/cycle_testing.hpp"
#include "cycles/typed.hpp"

namespace obrys::cycles::test {

/// Every member gets a number of its own, goes out by its role and comes back; said or not, as it was.
template <class Cycle>
void expect_round_trip() {
    for (const bool all : {true, false}) {
        Cycle cycle;
        double next = -1;
        for (const Member<Cycle>& m : members_of<Cycle>) {
            if (m.needed != nullptr) cycle.*m.needed = next;
            if (m.said != nullptr && all) cycle.*m.said = next;
            next -= 1;
        }
        const Demand demand = demand_of(cycle);
        EXPECT_EQ(demand.kind, Cycle::kind);
        Course course(demand, situation());
        const Cycle again = read<Cycle>(course, demand);
        for (const Member<Cycle>& m : members_of<Cycle>) {
            if (m.needed != nullptr) {
                EXPECT_EQ(again.*m.needed, cycle.*m.needed) << cl::spelling(m.role);
                EXPECT_EQ(demand.find(m.role), cycle.*m.needed) << cl::spelling(m.role);
            }
            if (m.said != nullptr) {
                EXPECT_EQ(again.*m.said, cycle.*m.said) << cl::spelling(m.role);
                EXPECT_EQ(demand.find(m.role), cycle.*m.said) << cl::spelling(m.role);
            }
        }
    }
}

}  // namespace obrys::cycles::test
