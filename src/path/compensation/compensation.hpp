#pragma once
/// Cutter radius compensation: programmed contour in, path of the cutter's (or the nose's) centre out, element by
/// element with a bounded look-ahead. Corner behaviour is data, so that one stage serves every control.
///
/// SINUMERIK words and where their meaning is taken from (Siemens, Function Manual Basic Functions, W1 Tool offset, 2D
/// TRC; Programming Manual Fundamentals, Tool radius compensation):
///   G41/G42  left / right; selected and deselected on a G0/G1 block only; no selection where G40 follows at once
///   NORM     straight to the point normal to the contour's first (last) point
///   KONT     as NORM unless the approach (retract) point lies behind the contour; then round the contour point as at
///            an outer corner, by G450 or G451. The text at hand does not say more, its pictures were not: we take
///            "behind" as across the tangent at that point, and the straight part as the tangent from the approach
///            point to the circle about the contour point; from within that circle as NORM.
///   G450     outer corner: arc about the corner; it belongs to the following block, so that block's events come
///            before it; blocks without motion in the plane are run at the arc's start. DISC= is ignored (0).
///   G451     outer corner: crossing of the parallels; arc beyond the corner limit (MD20210, 100 degrees)
///   inner corners: crossing of the parallels; where a block is too short for it, a later block within the look-ahead
///            (MD20240) is taken and the blocks between are left out; such blocks are reported as `bridged` faults
///   new D or G41<->G42 while active: the block's start has the old offset, its end the new one (lines only)
///   not modelled: G460-G462 (approach cut short where it crosses a parallel), CDON between blocks that are not
///            neighbours, KONTC, KONTT, spirals for a new D on an arc
///
/// HEIDENHAIN words (iTNC 530 User's Manual, "Tool radius compensation", "Miscellaneous functions for contouring
/// behavior"), all of them data in Setting:
///   RL/RR   arc at outer corners, crossing at inner ones, start and end normal to the contour (Approach::normal) and
///           by lines only; Clearance::reported. Where elements cannot be reached the control stops with "Tool radius
///           too large"; an `interference` it does not see without M120.
///   M97     CornerEnd::crossing in the block that ends at the corner
///   M98     CornerEnd::open in the block that ends at the corner
///   M120    Clearance::avoided with `window` from LA, from this block on (until R0, M120 without LA or LA0, a called
///           program). The manual says what it does, not how; ours is the walk of clearance.hpp. A block counts
///           here if it moves in the plane, and inserted chamfers and roundings count too.
///   M90     no effect on the path
///   not modelled: a spline instead of the arc at outer corners (MP7680)
/// RS-274 (LinuxCNC): Method::held_move, a strategy of its own (held_move.hpp); preset.hpp sets it up.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "path/compensation/contour_loop.hpp"
#include "path/compensation/held_move.hpp"
#include "path/compensation/join.hpp"
#include "path/compensation/output.hpp"
#include "path/element.hpp"
#include "path/setting.hpp"

namespace obrys::path {

class Compensation {
public:
    /// `look_ahead`: elements moving in the plane held back at most to find a crossing; 1 = none is ever left out.
    explicit Compensation(std::size_t look_ahead = 3) : look_ahead_(look_ahead) {}

    /// Takes the next programmed element, uncompensated coordinates. Elements that move nothing only hand on their
    /// events. Output is connected as long as the input is.
    std::vector<Fault> push(Element&& e, const Setting& s, OutputSink out);
    /// Emits everything held back; the last element ends at its normal. Compensation stays selected.
    std::vector<Fault> flush(OutputSink out);
    /// The block that switches off (G40) has been read, its move comes later. Method::held_move settles the held move
    /// here; a fault arises in that block, its tag is that of the last element. Else nothing happens.
    std::vector<Fault> switch_off(OutputSink out);
    /// True while push would hand elements through unchanged and nothing is held back.
    [[nodiscard]] bool idle() const { return window_.empty() && !active_ && carried_.empty() && held_.idle(); }

private:
    void take_plane(Element e, const Setting& s, OutputSink out);
    void take_still(Element e, OutputSink out);
    void add_approach(Element e, const Setting& s);
    void add_contour(Element e, const Setting& s, OutputSink out);
    void add_retract(Element e, const Setting& s);
    void drop_selection(const Element& next, OutputSink out);
    void advance(bool last, OutputSink out);
    bool step(bool last, OutputSink out);
    bool settled(const Join& j, bool may_wait);
    void finish_last(OutputSink out);
    bool bridge();
    void append(Item item);
    bool step_clear(bool last, OutputSink out);
    void no_exit(OutputSink out);
    void drop(std::size_t index);
    void leave_out(std::size_t index);
    void watch(double end);
    [[nodiscard]] Chain chain_back(const Item& past) const;
    void keep_behind(const Item& item);
    void commit(const Join& j, OutputSink out);
    void finish_front(geom::Vec2 end, double place, OutputSink out);
    void emit(Element e, Kind kind, OutputSink out);

    std::size_t look_ahead_;
    bool active_ = false;           ///< an approach was taken and no retract yet
    double offset_ = 0;             ///< at the end of the newest contour element, positive left
    std::deque<Item> window_;       ///< front: the element whose start is settled
    std::uint64_t items_ = 0;       ///< taken so far
    std::deque<Item> past_;         ///< items behind the path whose zones are still looked at
    Events carried_;                ///< events waiting for the next output
    std::optional<geom::Vec2> at_;  ///< where the output stands while active
    geom::Vec2 tip_;                ///< Setting::tip of the approach; everything inside is about the centre
    std::vector<Fault> faults_;
    HeldMove held_;  ///< takes all elements whose setting asks for it
};

}  // namespace obrys::path
