#pragma once
/// Tools in convex parts: of most the tool itself, of a T-slot cutter disc and neck.

#include <deque>
#include <map>
#include <vector>

#include "sim/milling/shape.hpp"

namespace obrys::sim::milling {

class ConvexParts {
public:
    /// `shape` stays where it is. To be called before `of`, by one thread.
    void add(const Shape* shape);
    /// What was added alone; stays where it is.
    [[nodiscard]] const std::vector<const Shape*>& of(const Shape* shape) const { return parts_.at(shape); }

private:
    std::deque<Shape> shapes_;
    std::map<const Shape*, std::vector<const Shape*>> parts_;
};

}  // namespace obrys::sim::milling
