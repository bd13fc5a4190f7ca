#pragma once
/// Between the programmed contour and the stream: corners (CHF, CHR, RND) and radius compensation (G41, G42).
/// Blocks pass here only while one of them is at work; straight programs never do. Private to interp.

#include <optional>
#include <vector>

#include "interp/stream/stream.hpp"
#include "path/compensation/contour_path.hpp"

namespace obrys::interp {

class PathStage {
public:
    /// True while anything is held back or compensation is at work.
    [[nodiscard]] bool active() const { return active_; }
    /// An element is held back: what is told now comes behind it.
    [[nodiscard]] bool holds() const { return holds_; }
    /// Its elements are in the stream's own frame, not in the programmed one (Traits::compensates_in_fixed_plane).
    [[nodiscard]] bool in_fixed_plane() const { return active_ && fixed_plane_; }
    void set_fixed_plane(bool fixed) { fixed_plane_ = fixed; }
    /// Takes one element of the block being run, in plane coordinates of the programmed frame.
    void push(Moving&, path::Element&& element, bool rapid);
    /// As above with a setting of its own, of an element that nobody has programmed.
    void push(Moving&, path::Element&& element, const path::Setting& setting);
    /// The block that was run is behind: whether it moved in the plane counts under radius compensation.
    void end_block(const Reckoning& run) {
        if (run.modal.compensation == Modal::compensation_off)
            idle_blocks_ = 0;
        else if (!block_moved_)
            ++idle_blocks_;
        block_moved_ = false;
    }
    /// Keeps a record that must come out before the next element.
    void hold(cl::Record record);
    /// The same of what the control is told.
    void hold(Heard what, const base::Span& from);
    /// The block that ends compensation has been read.
    void switch_off(Telling&);
    /// Emits everything held back.
    void flush(Telling&);
    /// The same; the tool stands where it is then, not at the contour's point.
    void stop(Telling&);
    /// As above, and compensation is in force no longer: the tool goes on from where its centre stands.
    void end_compensation(Telling&);
    /// The program has switched compensation off: the stream is told before the next element, or at once.
    void tell_end(Telling&);
    /// A smooth way begins, that the control makes by itself; every one has its end.
    void tell_lead(Reckoning&, const cl::LeadBegin& begin);
    void tell_lead_end(Telling&);

private:
    /// What an element's tag stands for.
    struct Origin {
        base::Span from;
        cl::StackId stack = 0;
        bool rapid = false;
        double radius = 0;  ///< of the tool, mm
        double offset = 0;  ///< of the centre from the contour, mm, positive left
        double plunge_part = 1;
        Modal feed_reference = Modal::feed_at_tool;
        bool avoids = false;  ///< looks ahead and leaves out what the tool does not fit into
        bool fixed_plane = false;
        double pulled_out = 0;     ///< part of the way to the crossing that the corner before it goes farther out
        bool asks_corner = false;  ///< by a word of its block
        cl::AxisEnds ends{};       ///< of axes that move along
    };

    /// Says where a corner is joined over more blocks without motion than the control sees past.
    void judge_idle_blocks(Saying&, const path::Element&, const path::Setting&);
    /// A chamfer or rounding of a block is left without the element that it leads to.
    void say_open_corner(Reckoning& run);
    [[nodiscard]] static double arc_feed(const Origin& origin, const path::Output& out);
    [[nodiscard]] path::CornerRequest corner_request(Moving&);
    void take(Moving&, path::Element&& element, const path::Setting& setting, bool rapid);
    struct HeardThere {
        Heard what;
        base::Span from;
    };

    void send_event(Telling&, const cl::Record& record);
    void send_kept(Telling&, int event);
    void tell_begin(Moving&, const path::Setting& s);
    void tell_programmed(Moving&, const path::Element& e, bool rapid);
    [[nodiscard]] int keep(cl::Record&& record);
    /// Room for a record that is to be kept; its number is that of events before it.
    [[nodiscard]] cl::Record& next_event();
    /// About a corner with a feed of its own: that feed, and back to the one that the stream has been told before it.
    /// Which one that is shows when the corner comes out: what stands behind its block has been told by then.
    void put_corner_feed(const Reckoning&, double feed, path::CornerRequest&);
    void output(Telling&, const path::Output& out);
    void report(Reckoning&, const path::PathFaults& faults);
    void report(Reckoning&, const path::Fault& fault);
    void report(Reckoning&, const path::CornerFault& fault);
    void forget();

    path::ContourPath path_;
    std::vector<Origin> origins_;  ///< by tag
    /// The first `event_count_` of them; those behind have been, and are there to be filled again.
    std::vector<cl::Record> events_;
    std::size_t event_count_ = 0;
    path::Events waiting_;
    std::vector<HeardThere> heard_;   ///< the first is event -1, the second -2 …
    std::optional<geom::Vec2> last_;  ///< end of the last element that was emitted
    bool active_ = false, fixed_plane_ = false;
    bool flushing_ = false, holds_ = false, said_outer_corner_ = false;
    std::uint32_t idle_blocks_ = 0;  ///< without motion in the plane since the last element
    bool block_moved_ = false;
    path::Side side_ = path::Side::off;            ///< of the last element
    std::optional<path::EndDirection> direction_;  ///< at its end
    std::optional<cl::CompensationBegin> told_;    ///< what the stream, or a record that waits, has begun
    bool begun_ = false;                           ///< the stream has
    bool lead_told_ = false, lead_begun_ = false;  ///< the same of smooth ways
};

/// What the modal state says to radius compensation; a tool whose radius is not known is reported.
[[nodiscard]] path::Setting compensation_setting(Moving&);
/// The chamfer or rounding that the block asks for at its end, without feeds.
[[nodiscard]] path::CornerRequest corner_of_block(const Moving&);
/// An element as it is programmed, no corner at its end; false, and `out` as it was, where it has no place in the
/// stream (a circle that a frame makes an ellipse).
[[nodiscard]] bool programmed_element(const Reckoning&, const path::Element& element, bool rapid, bool in_stream,
                                      cl::Programmed& out);
/// mm in the frame of the stream.
[[nodiscard]] double radius_in_stream(const Telling&, double radius);
/// Radius compensation is in force no longer.
void switch_compensation_off(Telling&);
/// Emits an element of the working plane as a record of the stream.
/// `in_stream`: it is in the stream's own frame already.
void emit_element(Telling&, const path::Element& element, bool rapid, bool in_stream = false);

}  // namespace obrys::interp
