#pragma once
/// Running a stretch of the program without output, to learn which contour elements it makes. Private to interp.

#include <optional>
#include <vector>

#include "interp/complaints.hpp"
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

/// While it lives, the run emits nothing and collects its elements and complaints; at its end the run stands where it
/// stood, with every value as it was.
class Rehearsal {
public:
    Rehearsal(Run& run, Look purpose);
    ~Rehearsal();
    Rehearsal(const Rehearsal&) = delete;
    Rehearsal& operator=(const Rehearsal&) = delete;

    std::vector<Captured> elements;
    Complaints complaints;

private:
    Run& run_;
    RunState saved_;
    std::unique_ptr<PathStage> path_;
};

/// What a stretch of the program made. Its elements are to be had only with what it complained about.
class [[nodiscard]] Looked {
public:
    Looked() = default;
    Looked(Rehearsal&& r, bool ended)
        : elements_(std::move(r.elements)), complaints_(std::move(r.complaints)), ended_(ended) {}

    /// Says every complaint, of the cycle with this name, and gives the elements; nothing where the stretch ended with
    /// an alarm (the run is stopped then) or did not come to its end.
    [[nodiscard]] std::optional<std::vector<Captured>> said(Run&, const std::string& of = {}) &&;

private:
    std::vector<Captured> elements_;
    Complaints complaints_;
    bool ended_ = false;
};

/// The next element of the working plane that the program makes behind the block being run; nothing where it makes none
/// within a few hundred statements. `from`: where the tool will stand, programmed frame. These blocks are run behind
/// the one at hand and complain then. Blocks that are looked at so (Look::next_element) must not call it.
[[nodiscard]] std::optional<Captured> next_element(Run&, const geom::Vec3& from);

/// The elements that a label of a program makes from the label to its end, in the order of motion; no end where there
/// is no such label.
Looked elements_of_label(Run&, const Unit& unit, const std::string& label);
/// The same of a whole program.
Looked elements_of_program(Run&, const Unit& unit);
/// The same of the subprogram with a turning cycle's contour. `from`: where the tool stands, programmed frame.
Looked elements_of_turned_contour(Run&, const Unit& unit, const geom::Vec3& from);
/// The same of a stretch of the program's own statements.
Looked elements_of_blocks(Run&, std::uint32_t first, std::uint32_t last);

/// Runs some statements ahead and forgets them: for tests, which look for a trace.
void look_ahead_in_vain(Run&, std::uint32_t statements);

}  // namespace obrys::interp
