#pragma once
/// What each place of the source texts has cost, in little room: of a long program the slowest places are kept.

#include <cstddef>
#include <vector>

#include "sim/time/times.hpp"

namespace obrys::sim::time {

class Ledger {
public:
    /// `most`: so many places are kept at least; 0: all.
    explicit Ledger(std::size_t most) : most_(most) {}

    void spend(const Place& place, Cause cause, double seconds) {
        if (place != place_) next(place);
        now_[static_cast<std::size_t>(cause)] += seconds;
    }
    /// Of all that were kept, as `merge` leaves them; the ledger is then empty.
    [[nodiscard]] std::vector<Spent> finish();
    /// A place was gone through again whose earlier passes may have been dropped: its sum may be short of them.
    [[nodiscard]] bool is_short() const { return short_; }

private:
    void next(const Place& place);
    void flush();
    void prune();

    std::size_t most_;
    Place place_{UINT32_MAX, 0};  ///< that is spent for
    Seconds now_{};
    std::vector<Spent> spent_;
    std::size_t merged_ = 0;  ///< so many at the begin are in their order
    std::size_t next_merge_ = 65'536;
    Place dropped_{};  ///< the last of those that were dropped
    bool any_dropped_ = false, short_ = false;
};

}  // namespace obrys::sim::time
