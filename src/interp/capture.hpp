#pragma once
/// Running a stretch of the program without output, to learn which contour elements it makes. Private to interp.

#include <functional>
#include <optional>
#include <vector>

#include "interp/motion.hpp"
#include "path/corner_stage.hpp"

namespace obrys::interp {

/// An element of the working plane as programmed, in the frame in force at `frame`.
struct Captured {
    path::Element element;
    bool rapid = false;
    Modal compensation = Modal::compensation_off;
    path::CornerRequest corner;  ///< chamfer or rounding at its end
    geom::Frame frame;
    base::Span where;
    cl::StackId stack = 0;
    double fillet = 0, chamfer = 0;      ///< A and C of a turning cycle's contour, mm
    std::optional<double> line_angle{};  ///< ANG= of a line that gives both coordinates of its end, degrees
};

/// While it lives, the run emits nothing, complains about nothing and collects its elements; at its end the run stands
/// where it stood, with every value as it was.
class Rehearsal {
public:
    explicit Rehearsal(Run& run);
    ~Rehearsal();
    Rehearsal(const Rehearsal&) = delete;
    Rehearsal& operator=(const Rehearsal&) = delete;

    [[nodiscard]] const std::vector<Captured>& elements() const { return elements_; }

private:
    struct Saved;
    Run& run_;
    std::vector<Captured> elements_;
    std::unique_ptr<Saved> saved_;
};

/// The next element of the working plane that the program makes behind the block being run; nothing where it makes none
/// within a few hundred statements. `from`: where the tool will stand, programmed frame.
[[nodiscard]] std::optional<Captured> next_element(Run&, const geom::Vec3& from);

/// The elements that a label of a program makes from the label to its end, in the order of motion; nothing where there
/// is no such label or it does not end.
[[nodiscard]] std::optional<std::vector<Captured>> elements_of_label(Run&, const Unit& unit, const std::string& label);

/// The same of a whole program; nothing where it does not end. `from`: where the tool stands, programmed frame.
[[nodiscard]] std::optional<std::vector<Captured>> elements_of_program(Run&, const Unit& unit,
                                                                       std::optional<geom::Vec3> from = {});
/// The same of a turning cycle's contour: U and W are steps along X and Z, A and C belong to the corner.
[[nodiscard]] std::optional<std::vector<Captured>> elements_of_turned_contour(Run&, const Unit& unit, geom::Vec3 from);

/// The elements that a stretch of the program's own statements makes, and what it complains about.
struct BlockRehearsal {
    std::vector<Captured> elements;
    std::vector<base::Diagnostic> complaints;  ///< an error is an alarm
    bool ended = false;                        ///< it ran to the end of the stretch
};
[[nodiscard]] BlockRehearsal elements_of_blocks(Run&, std::uint32_t first, std::uint32_t last);

}  // namespace obrys::interp
