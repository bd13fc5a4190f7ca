/// Events hold what a vector would, whether they need memory or not.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <utility>
#include <vector>

#include "path/events.hpp"

namespace obrys::path::test {
namespace {

std::vector<int> content(const Events& e) { return {e.begin(), e.end()}; }

Events of(const std::vector<int>& numbers) {
    Events e;
    for (const int n : numbers) e.push_back(n);
    return e;
}

}  // namespace

RC_GTEST_PROP(Events, hold_what_a_vector_holds, (const std::vector<int>& a, const std::vector<int>& b)) {
    Events e = of(a), sooner = of(b);
    RC_ASSERT(content(e) == a);
    RC_ASSERT(e.size() == a.size());
    RC_ASSERT(e.empty() == a.empty());
    RC_ASSERT((e == sooner) == (a == b));

    Events both = e;
    both.append(sooner);
    std::vector<int> expected = a;
    expected.insert(expected.end(), b.begin(), b.end());
    RC_ASSERT(content(both) == expected);
    RC_ASSERT(content(e) == a);

    Events moved = std::move(both);
    RC_ASSERT(content(moved) == expected);
    RC_ASSERT(both.empty());  // NOLINT: what is moved from is empty on purpose
    both = moved;
    RC_ASSERT(both == moved);
    both.push_back(1);
    RC_ASSERT(content(moved) == expected);

    e.put_before(sooner);
    expected = b;
    expected.insert(expected.end(), a.begin(), a.end());
    RC_ASSERT(content(e) == expected);
    RC_ASSERT(sooner.empty());
    e.clear();
    RC_ASSERT(e.empty());
    e.push_back(7);
    RC_ASSERT(content(e) == std::vector<int>{7});
}

}  // namespace obrys::path::test
