#include "check/trace.hpp"

#include <utility>

namespace obrys::check {

void Trace::add(geom::Region stock) {
    snapshots_.push_back({moves_.size(), std::move(stock)});
    if (snapshots_.size() < most_snapshots) return;
    every_ *= 2;
    std::erase_if(snapshots_, [this](const Snapshot& s) { return s.moves % every_ != 0; });
}

void Trace::finish(Result& result) {
    result.moves = std::move(moves_);
    result.snapshots = std::move(snapshots_);
}

}  // namespace obrys::check
