#include "sim/time/ledger.hpp"

#include <algorithm>
#include <functional>

namespace obrys::sim::time {
namespace {

bool before(const Spent& a, const Place& b) { return a.place < b; }

/// Calls `of` with the range of each place, which stand together.
template <class Of>
void for_each_place(const std::vector<Spent>& spent, Of of) {
    for (std::size_t i = 0, k = 0; i < spent.size(); i = k) {
        double seconds = 0;
        for (k = i; k < spent.size() && spent[k].place == spent[i].place; ++k) seconds += spent[k].seconds;
        of(i, k, seconds);
    }
}

}  // namespace

void Ledger::next(const Place& place) {
    flush();
    place_ = place;
}

void Ledger::flush() {
    for (std::size_t i = 0; i < now_.size(); ++i)
        if (now_[i] != 0) spent_.push_back({place_, static_cast<Cause>(i), now_[i]});
    now_ = {};
    if (any_dropped_ && !short_ && place_ <= dropped_) {
        const auto end = spent_.begin() + static_cast<std::ptrdiff_t>(merged_);
        const auto found = std::lower_bound(spent_.begin(), end, place_, before);
        short_ = found == end || found->place != place_;
    }
    if (spent_.size() >= next_merge_) prune();
}

void Ledger::prune() {
    merge(spent_);
    if (most_ > 0) {
        std::vector<double> seconds;
        for_each_place(spent_, [&](std::size_t, std::size_t, double s) { seconds.push_back(s); });
        if (seconds.size() > most_) {
            const auto last = seconds.begin() + static_cast<std::ptrdiff_t>(most_ - 1);
            std::nth_element(seconds.begin(), last, seconds.end(), std::greater<>());
            const double least = *last;
            std::size_t kept = 0, at_least = most_;  // of many that took the same, no more than are wanted
            for_each_place(spent_, [&](std::size_t i, std::size_t k, double s) {
                if (s >= least && at_least > 0) {
                    --at_least;
                    for (; i < k; ++i) spent_[kept++] = spent_[i];
                } else {
                    dropped_ = std::max(dropped_, spent_[i].place);
                    any_dropped_ = true;
                }
            });
            spent_.resize(kept);
        }
    }
    merged_ = spent_.size();
    next_merge_ = std::max<std::size_t>(65'536, 2 * merged_);
}

std::vector<Spent> Ledger::finish() {
    flush();
    place_ = {UINT32_MAX, 0};
    merge(spent_);
    return std::move(spent_);
}

}  // namespace obrys::sim::time
