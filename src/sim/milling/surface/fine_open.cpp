// What could not be made right.

#include <algorithm>
#include <tuple>

#include "sim/milling/surface/fine.hpp"

namespace obrys::sim::milling {

/// What was too fine once may have become right with its neighbours.
void Fine::settle() {
    KeyMap given_up;
    for (const Leaf& leaf : given_up_) given_up.add(key_of(leaf.at), 1);
    given_up_.clear();
    for (std::size_t e = 0; e < edges_.size() && given_up.size() > 0; ++e)
        for (const Leaf& leaf : edges_[e].around)
            if (given_up.find(key_of(leaf.at)) != KeyMap::none &&
                is_off(leaves_.cell_of(leaf.at), e, tolerance_, tolerance_))
                open_.push_back(box_of(leaf));
}

Box3 Fine::box_of(const Leaf& leaf) const {
    const std::int32_t s = leaf.size;
    return {leaves_.node(leaf.at), leaves_.node({leaf.at[0] + s, leaf.at[1] + s, leaf.at[2] + s})};
}

Refined Fine::figures() const {
    Refined r;
    r.cells = leaves_.split_cells().size();
    r.open = open_;
    r.filled = filled_;
    const auto before = [](const Box3& a, const Box3& b) {
        return std::tie(a.min.x, a.min.y, a.min.z, a.max.x) < std::tie(b.min.x, b.min.y, b.min.z, b.max.x);
    };
    std::sort(r.open.begin(), r.open.end(), before);
    r.open.erase(std::unique(r.open.begin(), r.open.end(),
                             [](const Box3& a, const Box3& b) { return a.min == b.min && a.max == b.max; }),
                 r.open.end());
    std::int32_t smallest = leaves_.unit();
    for (const Place& c : leaves_.split_cells())
        leaves_.each_leaf(c, [&](const Leaf& leaf) { smallest = std::min(smallest, leaf.size); });
    const double step = std::max({lattice_.step.x, lattice_.step.y, lattice_.step.z});
    r.finest = step * smallest / leaves_.unit();
    return r;
}

}  // namespace obrys::sim::milling
