#pragma once
/// What looking at a stretch of the program without running it tells: which contour elements it makes. Private to
/// interp.

#include <optional>
#include <vector>

#include "interp/complaints.hpp"
#include "interp/say.hpp"
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

/// What a stretch of the program made. Its elements are to be had only with what it complained about.
class [[nodiscard]] Looked {
public:
    Looked() = default;
    Looked(std::vector<Captured> elements, Complaints complaints, bool ended)
        : elements_(std::move(elements)), complaints_(std::move(complaints)), ended_(ended) {}

    /// Says every complaint, of the cycle with this name, and gives the elements; nothing where the stretch ended with
    /// an alarm (the run is stopped then) or did not come to its end.
    [[nodiscard]] std::optional<std::vector<Captured>> said(Saying&, const std::string& of = {}) &&;

private:
    std::vector<Captured> elements_;
    Complaints complaints_;
    bool ended_ = false;
};

/// What a block may want of the program around it, which lies above it (look_ahead.cpp).
class Onward {
public:
    virtual ~Onward() = default;
    /// Runs the next statement: of a program that a cycle calls.
    virtual void step() = 0;
    /// The next element of the working plane that the program makes behind the block being run; nothing where it makes
    /// none within a few hundred statements. `from`: where the tool will stand, programmed frame. These blocks are run
    /// behind the one at hand and complain then. Blocks that are looked at so (Look::next_element) must not ask.
    [[nodiscard]] virtual std::optional<Captured> next_element(const geom::Vec3& from) = 0;
    /// The elements that a label of a program makes from the label to its end, in the order of motion; no end where
    /// there is no such label.
    virtual Looked label(const Unit& unit, const std::string& label) = 0;
    /// The same of a whole program.
    virtual Looked program(const Unit& unit) = 0;
    /// The same of the subprogram with a turning cycle's contour. `from`: where the tool stands, programmed frame.
    virtual Looked turned_contour(const Unit& unit, const geom::Vec3& from) = 0;
    /// The same of a stretch of the program's own statements.
    virtual Looked blocks(std::uint32_t first, std::uint32_t last) = 0;
};

}  // namespace obrys::interp
