#pragma once
/// How long something has taken since it began, seconds.

#include <chrono>

namespace obrys::base {

class WorkTime {
public:
    WorkTime();
    /// By the clock on the wall.
    [[nodiscard]] double by_clock() const;
    /// That a processor spent on the thread which made this and now asks: the same on a busy machine as on an idle one.
    /// By the clock where the system does not tell.
    [[nodiscard]] double by_processor() const;

private:
    std::chrono::steady_clock::time_point started_;
    double processor_ = 0;
};

}  // namespace obrys::base
