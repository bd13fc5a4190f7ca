#pragma once
/// Rigid taps that a program makes by moves of their own (G33.1, G331 and G332), as cycles: for controls that tap by
/// cycles alone.

#include <functional>
#include <vector>

#include "cl/record.hpp"
#include "motion/cursor.hpp"

namespace obrys::write {

/// A tap along the tool's axis and the way back to where it began become a cycle, whose name is empty. What comes
/// between them waits for the way back; everything else goes on as it comes.
class LoneTaps {
public:
    explicit LoneTaps(std::function<void(const cl::Record&)> out) : out_(std::move(out)) {}
    void take(const cl::Record& record);
    /// Hands on what waits.
    void settle();

private:
    [[nodiscard]] bool begins_tap(const cl::Record& record) const;
    [[nodiscard]] bool ends_tap(const cl::Record& record) const;
    void hand_on(const cl::Record& record);

    std::function<void(const cl::Record&)> out_;
    motion::Cursor cursor_;
    std::vector<cl::Record> waiting_;
    geom::Vec3 from_;  ///< where the tap that waits begins
    int brackets_ = 0;
};

}  // namespace obrys::write
