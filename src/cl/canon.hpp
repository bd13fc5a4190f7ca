#pragma once
/// The stream as the canonical machining calls that LinuxCNC's stand-alone interpreter prints, so that the two can be
/// compared line by line. The run must tell settings (interp::Environment::tell_settings). Coordinates are those of the
/// program, in its unit. Source: LinuxCNC 2.9 and 2.10, what `rs274 -g` prints.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/function_ref.hpp"
#include "cl/record.hpp"
#include "geom/frame.hpp"

namespace obrys::cl {

class CanonWriter {
public:
    /// `block_number` gives the N number of the block of a place, or nothing.
    using BlockNumber = base::FunctionRef<std::string(const base::Span&)>;
    CanonWriter(base::FunctionRef<void(std::string_view)> out, BlockNumber block_number)
        : out_(out), block_number_(block_number) {}

    void operator()(const Record& record);
    /// The end of the run. `percents`: lines with `%` alone in the text, two at most; `resets`: how often the control
    /// is reset (twice without, once with a configuration); `refused`: the run ended with an error.
    void finish(int percents, int resets, bool refused);

private:
    void print(const Record& record);
    [[nodiscard]] bool only_leads(const Linear& l) const;
    void call(std::string text);
    void begin();
    void take(const AxisEnds& ends);
    void setting(const Setting& s);
    void output(const Output& o);
    void allow(const Override& o);
    bool offsets(const Setting& s);
    bool modes(const Setting& s);
    bool technology(const Setting& s);
    void move(std::string_view name, const geom::Vec3& to);
    void line(const Linear& l);
    void arc(const Arc& a);
    void thread(const Thread& t);
    void stop(const Stop& s);
    void program_end();
    [[nodiscard]] geom::Vec3 programmed(const geom::Vec3& stream) const;
    [[nodiscard]] std::string axes(const std::array<double, 12>& values, std::size_t from, std::size_t to,
                                   std::string_view between) const;

    base::FunctionRef<void(std::string_view)> out_;
    BlockNumber block_number_;
    std::uint64_t lines_ = 0;
    std::string at_end_;  ///< a call that waits for the end of the program
    std::string prefix_ = "N..... ";
    geom::Frame into_program_;
    std::array<double, 9> offset_{}, stream_{};  ///< of A … W
    std::array<double, 3> length_{}, moved_{};   ///< the tool's, mm; how far it has moved the zero since the last move
    geom::Vec3 at_;                              ///< end of the last move, in the stream
    std::optional<Record> lead_;                 ///< a line that may do no more than lead to an arc
    double unit_ = 1;                            ///< mm
    int plane_ = 17;
    bool mist_ = false, flood_ = false, feed_override_ = true;
    bool begun_ = false, ended_ = false, pallet_ = false, tapped_ = false;
};

}  // namespace obrys::cl
