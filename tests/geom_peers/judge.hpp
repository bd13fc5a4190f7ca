#pragma once
/// For tests that hold our offsets against another kernel's: who is right where they differ, by the distance of single
/// points from the source, which needs no offset.

#include "geom/random_cases_testing.hpp"

namespace obrys::geom::testing {

struct Verdict {
    unsigned ours_wrong = 0, theirs_wrong = 0, points = 0;
};

/// `truth(p)`: 1 inside, 0 outside, -1 too near to the contour to tell.
template <class Truth, class Ours, class Theirs>
Verdict judge(Box around, unsigned points, Random& random, Truth truth, Ours ours, Theirs theirs) {
    Verdict v;
    for (unsigned i = 0; i < points; ++i) {
        const Vec2 p{random.between(around.lo.x, around.hi.x), random.between(around.lo.y, around.hi.y)};
        const int is = truth(p);
        if (is < 0) continue;
        ++v.points;
        v.ours_wrong += ours(p) != (is == 1);
        v.theirs_wrong += theirs(p) != (is == 1);
    }
    return v;
}

}  // namespace obrys::geom::testing
