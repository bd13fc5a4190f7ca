#pragma once
/// What an FkContour keeps between two elements. Inside of fk.hpp; not for callers.

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "path/fk/equations.hpp"

namespace obrys::path {

/// An element that waits for data.
struct FkSlot {
    FkElement e;
    int first_id = 0;
    FkHandle handle;
};

struct FkState {
    geom::Vec2 origin;
    double w = 0, scale = 1;
    FkHandle start;                                ///< the contour's, or the last element that came out
    std::optional<std::array<FkPoly, 2>> closing;  ///< start of the element with CLSD+
    std::deque<FkHandle> history;                  ///< elements that came out
    std::deque<FkSlot> pending;
    std::vector<FkBranch> branches{1};
    int next_id = 0;
    std::optional<FkFault> failed;

    [[nodiscard]] FkResult fail(FkFault f) {
        failed = std::move(f);
        return {{}, failed};
    }
    [[nodiscard]] const FkHandle& last() const { return pending.empty() ? start : pending.back().handle; }
    [[nodiscard]] const FkHandle* find(std::uint64_t tag) const;
    void grow(const FkElement& e);
    [[nodiscard]] std::optional<FkFault> extend(const FkElement& e);
    [[nodiscard]] bool branch_out(const std::vector<FkChoice>& choices);
    [[nodiscard]] FkSolver solver() const;
    void unite();
    [[nodiscard]] std::optional<Element> element(const FkBranch& b, const FkSlot& s) const;
    [[nodiscard]] bool agreed(std::size_t index, Element& out) const;
    [[nodiscard]] std::vector<Element> release();
    void forget_first(const Element& e);
    [[nodiscard]] std::vector<FkDatum> missing(const FkBranch& b, const FkSlot& s) const;
};

}  // namespace obrys::path
