#pragma once
/// Tools, feeds and curves as they stand, and what the stream has been told: values only. Private to interp.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/shared_value.hpp"
#include "cl/record.hpp"
#include "geom/frame.hpp"
#include "geom/nurbs.hpp"
#include "shop/tool.hpp"

namespace obrys::interp {

/// Control points between G5.2 and G5.3, or of G6.2.
struct ControlCurve {
    bool open = false, own_knots = false;
    geom::Nurbs curve;  ///< programmed frame
};

struct ToolState {
    std::uint32_t number = 0, edge = 0;
    std::string name;
    std::uint32_t prepared = 0;  ///< T programmed, M6 still to come (mills)
    std::string prepared_name;
    std::uint32_t prepared_edge = 1;
    bool waiting = false;
    const shop::Tool* data = nullptr;
    // What nobody has said is not 0: the control holds it from before.
    bool known = false;                       ///< program or job have said which tool is in the spindle
    bool edge_known = false;                  ///< … and which of its edges is in force
    std::optional<std::uint32_t> selected{};  ///< number of the tool that T has prepared last
    double delta_length = 0, delta_radius = 0, delta_corner = 0;  ///< allowances of the call, mm
    double feed = 0;                                              ///< given with the tool (F AUTO), mm/min; 0: none
};

/// What the feed of the stream follows from besides F.
struct FeedShape {
    bool on = false;             ///< something of it was programmed
    bool in_cycle = false;       ///< whose steps have their own feeds
    double programmed = 0;       ///< F of the stream
    double told = 0;             ///< the feed that the stream has now
    geom::Vec3 at;               ///< where the stream stands
    double plunge = 1, arc = 1;  ///< of the element being sent: ModalState::plunge_part, path radius by contour radius
};

/// Polar and cylindrical interpolation: the program moves in a plane that linear and rotary axis make together
/// (surface.cpp).
struct SurfaceMode {
    enum class Kind : std::uint8_t { none, polar, cylinder };
    Kind kind = Kind::none;
    double start = 0;   ///< of C where it was switched on, degrees: the plane's first axis points there
    double angle = 0;   ///< of C where the stream stands, degrees
    double radius = 0;  ///< of the cylinder, mm
    int plane = 18;     ///< before it
    geom::Vec3 at;      ///< where the stream stands in the plane
};

struct FreeContour;

/// The tools that the run knows, and the one in the spindle, which points into their list: also in a copy.
struct ToolRack {
    ToolState tool;
    std::vector<shop::Tool> tools;  ///< of the job, with what the program writes to $TC_DPn

    explicit ToolRack(const std::vector<shop::Tool>& listed) : tools(listed) {}
    ToolRack(const ToolRack& other) : tool(other.tool), tools(other.tools) { point_into_list(other); }
    ToolRack(ToolRack&&) noexcept = default;
    ToolRack& operator=(const ToolRack& other) {
        if (this == &other) return *this;
        tool = other.tool;
        tools = other.tools;
        point_into_list(other);
        return *this;
    }
    ToolRack& operator=(ToolRack&&) noexcept = default;
    ~ToolRack() = default;

private:
    void point_into_list(const ToolRack& other) {
        if (tool.data != nullptr) tool.data = tools.data() + (tool.data - other.tools.data());
    }
};

/// A free contour that is being solved; a copy is solved by itself.
struct SolvedContour {
    std::shared_ptr<FreeContour> at_hand;  ///< null: none

    SolvedContour() = default;
    SolvedContour(const SolvedContour& other);  // free_contour.cpp
    SolvedContour(SolvedContour&&) noexcept = default;
    SolvedContour& operator=(const SolvedContour& other) { return *this = SolvedContour(other); }
    SolvedContour& operator=(SolvedContour&&) noexcept = default;
    ~SolvedContour() = default;
};

/// The zero and the frame that the stream has been told, before its moves.
struct StreamFrame {
    bool begun = false;
    bool current = false;  ///< nothing has changed since
    cl::Datum first, datum;
    std::vector<cl::FramePart> parts;
    base::SharedValue<cl::Cycle> cycle;  ///< the last one
    std::uint32_t open_cycles = 0;       ///< brackets
    cl::ToolLength length;
    std::optional<cl::PathMode> path;
    cl::Feed feed{};  ///< the last one, of no corner alone; 0: none yet
};

}  // namespace obrys::interp
