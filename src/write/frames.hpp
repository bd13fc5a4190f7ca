#pragma once
/// Frames in which coordinates are programmed, as commands of a control.

#include <vector>

#include "cl/record.hpp"
#include "write/post.hpp"

namespace obrys::write {

struct FrameStep {
    Command command = Command::shift;
    cl::FramePart part;  ///< of commands that set one
};

/// Whether values can say the part, and these.
[[nodiscard]] bool frame_values(const cl::FramePart& part, Values& values);

/// The frame that the text has set so far.
class Frames {
public:
    /// Commands that lead to `frame`; nothing, and no frame is in force any more, where the post has none for a part.
    [[nodiscard]] std::optional<std::vector<FrameStep>> lead_to(const cl::Frame& frame, const Post& post);
    /// Commands that end all parts; what the selected zero has besides its place (of `wanted`) stays.
    [[nodiscard]] std::vector<FrameStep> clear(const cl::Frame& wanted, const Post& post);
    /// As the stream has them; they may be written in other words.
    [[nodiscard]] const std::vector<cl::FramePart>& parts() const { return wanted_; }

    /// Workpiece frame -> programmed; a coordinate that nobody knows makes those unknown that depend on it.
    [[nodiscard]] geom::Vec3 programmed(const geom::Vec3& point) const;
    [[nodiscard]] geom::Vec3 programmed_direction(const geom::Vec3& direction) const;
    [[nodiscard]] bool mirrors() const { return mirrors_; }
    [[nodiscard]] const geom::Frame& into() const { return into_; }

private:
    void take(std::vector<cl::FramePart> parts);
    /// `frame` as these parts.
    [[nodiscard]] std::optional<std::vector<FrameStep>> lead_to_parts(const cl::Frame& frame,
                                                                      const std::vector<cl::FramePart>& parts,
                                                                      const Post& post);

    std::vector<cl::FramePart> wanted_;
    std::vector<cl::FramePart> parts_;  ///< as they are written
    geom::Frame into_;
    bool mirrors_ = false;
};

}  // namespace obrys::write
