#pragma once
/// Speed over time in few samples, however long it takes: equal pieces of time, twice as long each time they run out.

#include <cstddef>
#include <vector>

#include "sim/time/times.hpp"

namespace obrys::sim::time {

class SpeedCurve {
public:
    struct Sample {
        double low = 0, high = 0;  ///< mm/s within it
        double way = 0;            ///< mm from the begin to its end
        Place place;               ///< of what was done as it began
    };

    /// `most`: samples, even.
    explicit SpeedCurve(std::size_t most) : most_(most) {}

    /// Goes on with motion whose speed changes evenly, or stands (0, 0).
    void take(double seconds, double from, double to, const Place& place);

    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
    /// Of each sample; the last may be shorter.
    [[nodiscard]] double step() const { return step_; }
    [[nodiscard]] double seconds() const { return seconds_; }

private:
    void halve();

    std::size_t most_;
    std::vector<Sample> samples_;
    double step_ = 1.0 / 1024, seconds_ = 0, way_ = 0;
};

}  // namespace obrys::sim::time
