#include "path/corner_stage.hpp"

#include <utility>

#include "path/curve.hpp"

namespace obrys::path {

std::optional<CornerFault> CornerStage::push(Element e, const CornerRequest& at_end, CornerSink out) {
    if (!moves_in_plane(e)) {
        if (held_)
            between_.push_back(std::move(e));
        else
            out({std::move(e), false});
        return std::nullopt;
    }
    std::optional<CornerFault> fault;
    if (held_ && request_.kind != CornerKind::none && between_.size() <= most_between_) fault = insert(e, out);
    flush(out);
    if (at_end.kind == CornerKind::none) {
        out({std::move(e), false});
        return fault;
    }
    held_ = std::move(e);
    request_ = at_end;
    return fault;
}

std::optional<std::uint64_t> CornerStage::oldest_tag() const {
    if (!held_) return std::nullopt;
    return held_->tag;
}

std::optional<CornerFault> CornerStage::insert(Element& next, CornerSink out) {
    CornerResult r = insert_corner(*held_, next, request_.kind, request_.size);
    if (r.ok() && geom::dot(start_direction(next), request_.toward) < 0) r.failure = CornerFailure::wrong_way;
    if (r.ok()) {
        release(next, std::move(r), out);
        return std::nullopt;
    }
    if (request_.modal && r.failure == CornerFailure::tangential) return std::nullopt;
    CornerFault fault{r.failure, held_->tag, request_.size, 0, held_->to};
    if (!request_.reduce || r.failure != CornerFailure::too_short) return fault;
    fault.made = largest_corner(*held_, next, request_.kind, request_.size);
    r = insert_corner(*held_, next, request_.kind, fault.made);
    if (r.ok()) release(next, std::move(r), out);
    return fault;
}

/// Emits the shortened first element, what stands between, and the inserted one; `next` is left shortened.
void CornerStage::release(Element& next, CornerResult r, CornerSink out) {
    out({std::move(r.first), false});
    held_.reset();
    double w = r.inserted.w_from;
    for (Element& e : between_) {
        e.from = e.to = r.inserted.from;
        w = e.w_to;
        out({std::move(e), false});
    }
    between_.clear();
    r.inserted.w_from = r.inserted.w_to = w;
    if (request_.feed_of_next) std::swap(r.inserted.before, r.second.before);
    r.inserted.before.append(request_.before);
    Events sooner = request_.after;
    r.second.before.put_before(sooner);
    out({std::move(r.inserted), true});
    next = std::move(r.second);
}

void CornerStage::flush(CornerSink out) {
    if (held_) out({std::move(*held_), false});
    held_.reset();
    for (Element& e : between_) out({std::move(e), false});
    between_.clear();
}

}  // namespace obrys::path
