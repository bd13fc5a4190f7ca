#include "path/fk/fk.hpp"

#include <algorithm>
#include <cmath>

#include "path/fk/state.hpp"

namespace obrys::path {

using geom::Vec2;

FkContour::FkContour(Vec2 start, std::optional<Vec2> direction, double w) : state_(std::make_unique<FkState>()) {
    FkState& s = *state_;
    s.origin = start;
    s.w = w;
    const bool finite = std::isfinite(start.x) && std::isfinite(start.y);
    if (!finite || std::abs(start.x) > fk_most_length || std::abs(start.y) > fk_most_length) {
        s.failed = FkFault{};
        s.failed->reason = finite ? FkReason::bad_value : FkReason::not_known;
    }
    const double length = direction ? geom::length(*direction) : 0;
    s.start.has_direction = length > 0 && std::isfinite(length);
    if (!s.start.has_direction) return;
    const Vec2 n = (1 / length) * geom::left_of(*direction);
    s.start.na_x = s.start.nb_x = n.x;
    s.start.na_y = s.start.nb_y = n.y;
}

FkContour::FkContour(const FkContour& o) : state_(std::make_unique<FkState>(*o.state_)) {}
FkContour::FkContour(FkContour&&) noexcept = default;
FkContour& FkContour::operator=(const FkContour& o) {
    *state_ = *o.state_;
    return *this;
}
FkContour& FkContour::operator=(FkContour&&) noexcept = default;
FkContour::~FkContour() = default;

FkResult FkContour::push(const FkElement& e) {
    FkState& s = *state_;
    if (s.failed) return {{}, s.failed};
    if (e.closed == FkClosed::begins) s.closing = {s.last().end_x, s.last().end_y};
    if (auto f = s.extend(e)) return s.fail(std::move(*f));
    return {s.release(), {}};
}

FkResult FkContour::select(std::size_t n) {
    FkState& s = *state_;
    if (s.failed) return {{}, s.failed};
    if (n < 1 || n > s.branches.size()) {
        FkFault f;
        f.reason = FkReason::no_such_solution;
        f.tag = s.last().tag;
        f.datum = FkDatum::fselect;
        f.solutions = s.branches.size();
        return s.fail(std::move(f));
    }
    s.branches = {s.branches[n - 1]};
    s.branches.front().path.clear();
    return {s.release(), {}};
}

FkResult FkContour::finish() {
    FkState& s = *state_;
    if (s.failed) return {{}, s.failed};
    FkResult r{s.release(), {}};
    if (s.pending.empty()) return r;
    FkFault f;
    f.solutions = s.branches.size();
    const auto open = [&](const FkBranch& b) {
        return std::find_if(s.pending.begin(), s.pending.end(), [&](const FkSlot& p) { return !s.element(b, p); });
    };
    const auto under = std::find_if(s.branches.begin(), s.branches.end(),
                                    [&](const FkBranch& b) { return open(b) != s.pending.end(); });
    if (under != s.branches.end()) {
        f.reason = FkReason::under_determined;
        f.tag = open(*under)->e.tag;
        f.missing = s.missing(*under, *open(*under));
    } else {
        f.reason = FkReason::ambiguous;
        f.tag = s.pending.front().e.tag;
        f.datum = FkDatum::fselect;
    }
    r.fault = s.fail(std::move(f)).fault;
    return r;
}

std::size_t FkContour::solutions() const { return state_->branches.size(); }
std::size_t FkContour::pending() const { return state_->pending.size(); }

std::vector<Element> FkContour::solution(std::size_t index) const {
    std::vector<Element> out;
    if (index >= state_->branches.size()) return out;
    for (const FkSlot& s : state_->pending) {
        const auto e = state_->element(state_->branches[index], s);
        if (!e) break;
        out.push_back(*e);
    }
    return out;
}

}  // namespace obrys::path
