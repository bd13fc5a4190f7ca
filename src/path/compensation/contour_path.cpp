#include "path/compensation/contour_path.hpp"

#include <utility>

namespace obrys::path {

PathFaults ContourPath::push(Element&& e, const Setting& setting, const CornerRequest& at_end, OutputSink out) {
    PathFaults faults;
    if (at_end.kind == CornerKind::none && corners_.empty()) {  // nothing is held back there, nor will be
        faults.compensation = compensation_.push(std::move(e), setting, out);
        return faults;
    }
    blocks_.push_back({std::exchange(e.tag, first_ + blocks_.size()), setting});
    const auto next = [&](const CornerOutput& c) { compensate(c.element, faults, out); };
    faults.corner = corners_.push(std::move(e), at_end, next);
    if (faults.corner) faults.corner->tag = blocks_[faults.corner->tag - first_].tag;
    const std::uint64_t keep = corners_.oldest_tag().value_or(first_ + blocks_.size());
    blocks_.erase(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(keep - first_));
    first_ = keep;
    return faults;
}

PathFaults ContourPath::flush(OutputSink out) {
    PathFaults faults;
    corners_.flush([&](const CornerOutput& c) { compensate(c.element, faults, out); });
    first_ += blocks_.size();
    blocks_.clear();
    for (const Fault& f : compensation_.flush(out)) faults.compensation.push_back(f);
    return faults;
}

PathFaults ContourPath::switch_off(OutputSink out) {
    PathFaults faults;
    faults.compensation = compensation_.switch_off(out);
    return faults;
}

void ContourPath::compensate(Element e, PathFaults& faults, OutputSink out) {
    const Block& block = blocks_[e.tag - first_];
    e.tag = block.tag;
    for (const Fault& f : compensation_.push(std::move(e), block.setting, out)) faults.compensation.push_back(f);
}

}  // namespace obrys::path
