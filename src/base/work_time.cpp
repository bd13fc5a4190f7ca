#include "base/work_time.hpp"

#include <ctime>

namespace obrys::base {

namespace {

using Clock = std::chrono::steady_clock;

/// Of this thread so far.
double processor_seconds() {
#ifdef CLOCK_THREAD_CPUTIME_ID
    std::timespec t{};
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t) == 0)
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
#endif
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace

WorkTime::WorkTime() : started_(Clock::now()), processor_(processor_seconds()) {}

double WorkTime::by_clock() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }

double WorkTime::by_processor() const { return processor_seconds() - processor_; }

}  // namespace obrys::base
