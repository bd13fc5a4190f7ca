/// The unit that F is in.

#include "interp/values/values.hpp"

namespace obrys::interp {

double feed_factor(const Reckoning& run) {
    if (!run.modal.inch_feed || run.modal.feed_mode == cl::FeedMode::inverse_time) return 1;
    return run.modal.feed_mode == cl::FeedMode::per_minute ? run.unit().traits->inch_feed : 25.4;
}

}  // namespace obrys::interp
