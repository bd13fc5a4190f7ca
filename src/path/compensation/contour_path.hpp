#pragma once
/// From programmed contour to tool path in one call: corner insertion, then radius compensation, each element with the
/// setting of its own block. This is what an interpreter uses; the stages can also be used alone.

#include <optional>
#include <vector>

#include "path/compensation/compensation.hpp"
#include "path/corner_stage.hpp"

namespace obrys::path {

struct PathFaults {
    std::optional<CornerFault> corner;
    std::vector<Fault> compensation;
    [[nodiscard]] bool empty() const { return !corner && compensation.empty(); }
};

class ContourPath {
public:
    explicit ContourPath(std::size_t look_ahead = 3, std::size_t most_between = 3)
        : corners_(most_between), compensation_(look_ahead) {}

    /// One programmed element with what is in force in its block. Programmed coordinates, also while compensated.
    PathFaults push(Element&& e, const Setting& setting, const CornerRequest& at_end, OutputSink out);
    /// Emits everything held back: end of program, change of plane or frame, anything that must not be overtaken.
    PathFaults flush(OutputSink out);
    /// The block that switches the compensation off has been read (Compensation::switch_off).
    PathFaults switch_off(OutputSink out);
    /// Tag of the element whose block asks for a corner that has not been made yet.
    [[nodiscard]] std::optional<std::uint64_t> open_corner() const {
        const auto inside = corners_.open_request();
        return inside ? std::optional(blocks_[static_cast<std::size_t>(*inside - first_)].tag) : std::nullopt;
    }
    /// True while elements go through unchanged and at once: the caller may emit them itself.
    [[nodiscard]] bool idle() const { return corners_.empty() && compensation_.idle(); }

private:
    struct Block {
        std::uint64_t tag = 0;
        Setting setting;
    };
    void compensate(Element e, PathFaults& faults, OutputSink out);

    CornerStage corners_;
    Compensation compensation_;
    std::vector<Block> blocks_;  ///< of the elements in corners_; inside, tags are first_ + index into it
    std::uint64_t first_ = 0;
};

}  // namespace obrys::path
