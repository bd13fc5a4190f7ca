#pragma once
/// What holds at a place of the stream: the modal records and the tool, looked up once.

#include <cstdint>

#include "cl/record.hpp"
#include "shop/tool.hpp"

namespace obrys::motion {

/// What moves are made with.
struct State {
    cl::Feed feed;  ///< 0: none programmed yet
    cl::Spindle spindle;
    cl::Coolant coolant;
    cl::Tolerance tolerance;
    std::optional<cl::PathMode> path;  ///< nothing: as the machine is set
    cl::Datum datum{0, {NAN, NAN, NAN}};
    cl::Frame frame;                                    ///< in which coordinates are programmed
    cl::ToolLength length;                              ///< as far as the program says it
    cl::ToolChange change;                              ///< the last one
    base::Span changed{};                               ///< its place
    cl::StackId changed_from = 0;                       ///< its stack
    bool any_tool = false;                              ///< a tool is in use, in the list or not
    const shop::Tool* tool = nullptr;                   ///< that one; null: none, or not in the list
    std::optional<cl::CompensationBegin> compensation;  ///< radius compensation in force
    std::uint32_t cycles = 0;                           ///< brackets of cycles that are open
    bool leads = false;                                 ///< a way onto a contour or off it that the control makes
    std::uint32_t parts = 0;                            ///< the same of calls and repetitions
};

}  // namespace obrys::motion
