#pragma once
/// Chamfers and roundings on the fly: elements in, elements with inserted corners out, one element held back.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/function_ref.hpp"
#include "path/corner.hpp"

namespace obrys::path {

/// What the block that leads to a corner asks for at its end.
struct CornerRequest {
    CornerKind kind = CornerKind::none;
    double size = 0;           ///< mm
    bool modal = false;        ///< corners without a corner (tangential) are no fault
    bool reduce = false;       ///< take the largest that fits instead of failing
    bool feed_of_next = true;  ///< the next element's events come before the inserted one (F of the leading-away block)
    /// Not null: the next element must not run against it (sizes whose sign says where the corner turns).
    geom::Vec2 toward{};
    Events before{}, after{};  ///< events round the inserted element alone (FRC=: its feed, and back)
};

struct CornerFault {
    CornerFailure failure = CornerFailure::none;
    std::uint64_t tag = 0;  ///< the element whose block asked for it
    double size = 0;        ///< asked for, mm
    double made = 0;        ///< inserted instead where `reduce` was set, else 0
    geom::Vec2 at;          ///< programmed corner
    bool operator==(const CornerFault&) const = default;
};

struct CornerOutput {
    Element element;
    bool inserted = false;
};
using CornerSink = base::FunctionRef<void(const CornerOutput&)>;

class CornerStage {
public:
    /// `most_between`: with more elements without motion in the plane between, no corner is inserted (SINUMERIK: 3).
    explicit CornerStage(std::size_t most_between = 3) : most_between_(most_between) {}

    /// `at_end`: what this element's block asks for at its end. Elements without motion in the plane keep the request
    /// of the one before.
    std::optional<CornerFault> push(Element e, const CornerRequest& at_end, CornerSink out);
    /// Emits what is held back; a request left open (no element follows) makes no corner and no fault.
    void flush(CornerSink out);
    [[nodiscard]] bool empty() const { return !held_; }
    /// Tag of the element at whose end a corner is still asked for.
    [[nodiscard]] std::optional<std::uint64_t> open_request() const {
        return held_ && request_.kind != CornerKind::none ? std::optional(held_->tag) : std::nullopt;
    }
    /// Tag of the element held back, if there is one.
    [[nodiscard]] std::optional<std::uint64_t> oldest_tag() const;

private:
    std::optional<CornerFault> insert(Element& next, CornerSink out);
    void release(Element& next, CornerResult r, CornerSink out);

    std::size_t most_between_;
    std::optional<Element> held_;
    CornerRequest request_;
    std::vector<Element> between_;
};

}  // namespace obrys::path
