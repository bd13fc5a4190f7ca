#pragma once
/// The canonical machining calls that LinuxCNC's stand-alone interpreter prints, so that the two can be compared line
/// by line: moves and what belongs to them out of the stream, the rest as the control is told it (interp/heard.hpp).
/// Coordinates are those of the program, in its unit. Source: LinuxCNC 2.9 and 2.10, what `rs274 -g` prints.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/function_ref.hpp"
#include "cl/record.hpp"
#include "geom/frame.hpp"
#include "interp/heard.hpp"
#include "write/canon/calls.hpp"

namespace obrys::write {

class CanonWriter {
public:
    /// `block_number` gives the N number of the block of a place, or nothing.
    using BlockNumber = base::FunctionRef<std::string(const base::Span&)>;
    CanonWriter(base::FunctionRef<void(std::string_view)> out, BlockNumber block_number)
        : calls_(out), block_number_(block_number) {}

    void operator()(const cl::Record& record);
    void hear(const interp::Heard& what, const base::Span& from);
    /// The end of the run. `percents`: lines with `%` alone in the text, two at most; `resets`: how often the control
    /// is reset (twice without, once with a configuration); `refused`: the run ended with an error.
    void finish(int percents, int resets, bool refused);

private:
    /// A cycle whose steps are going by.
    struct OpenCycle {
        cl::CycleKind kind = cl::CycleKind::drill;
        bool taps = false;  ///< the tool is in the hole
    };

    void print(const cl::Record& record);
    void print_lead();
    [[nodiscard]] bool only_leads(const cl::Linear& l) const;
    void take_number(const base::Span& from);
    void begin();
    void take(const cl::AxisEnds& ends);
    void take(const cl::Datum& datum);
    void step(const cl::Record& record);
    void before_step(const cl::Step& s);
    void tap_overrides(const cl::Step& s);
    void synchronise(const cl::Step& s);
    void start_synchronised(double pitch);
    void allow_in_cycle(cl::OverrideKind kind, bool on);
    void close_cycle();
    void move(std::string_view name, const geom::Vec3& to);
    void line(const cl::Linear& l);
    void arc(const cl::Arc& a);
    void thread(const cl::Thread& t);
    void comment(const cl::Comment& c);
    void stop(const cl::Stop& s);
    void program_end();
    [[nodiscard]] geom::Vec3 programmed(const geom::Vec3& stream) const;
    [[nodiscard]] std::string rotary() const;

    void say(const interp::heard::Zero&);
    void say(const interp::heard::SameZero&);
    void say(const interp::heard::OtherZero&);
    void say(const interp::heard::Shift&);
    void say(const interp::heard::Counting&);
    void say(const interp::heard::ToolOffset&);
    void say(const interp::heard::Unit&);
    void say(const interp::heard::Plane&);
    void say(const interp::heard::FeedKind&);
    void say(const interp::heard::FeedNumber&);
    void say(const interp::heard::Joining&);
    void say(const interp::heard::Compensation&);
    void say(const interp::heard::Increments&);
    void say(const interp::heard::Diameters&);
    void say(const interp::heard::RetractLevel&);
    void say(const interp::heard::NoMotion&);
    void say(const interp::heard::ToolWord&);
    void say(const interp::heard::ToolChanged&);
    void say(const interp::heard::ToolNumbered&);
    void say(const interp::heard::ToolEntry&);
    void say(const interp::heard::SpeedKind&);
    void say(const interp::heard::SpeedNumber&);
    void say(const interp::heard::SpindleTurn&);
    void say(const interp::heard::SpindleOrient&);
    void say(const interp::heard::CoolantWord&);
    void say(const interp::heard::Curve&);
    void say(const interp::heard::PalletChange&);

    CanonCalls calls_;
    BlockNumber block_number_;
    std::string at_end_;  ///< a call that waits for the end of the program
    geom::Frame into_program_;
    std::optional<cl::Datum> first_;             ///< zero of the stream
    geom::Vec3 from_first_;                      ///< way to the last one
    std::array<double, 9> offset_{}, stream_{};  ///< of A … W
    std::array<double, 3> length_{}, moved_{};   ///< the tool's, mm; how far it has moved the zero since the last move
    geom::Vec3 at_;                              ///< end of the last move, from the first zero
    std::optional<cl::Record> lead_;             ///< a line that may do no more than lead to an arc
    std::vector<OpenCycle> cycles_;              ///< one in another
    double unit_ = 1;                            ///< mm
    double pitch_ = 0;                           ///< of the thread that is being cut in a cycle, mm; 0: none
    int plane_ = 17;
    bool mist_ = false, flood_ = false;
    bool feed_override_ = true, speed_override_ = true;  ///< as the program says
    bool begun_ = false, ended_ = false, pallet_ = false, tapped_ = false;
};

}  // namespace obrys::write
