#pragma once
/// Passes of one thread must wind alike: each turn of the spindle brings the tool to the same place of the groove. A
/// pass with another lead or sense, or one that begins a part of a turn beside the others, destroys the thread.

#include <cstddef>
#include <optional>
#include <vector>

#include "check/collect.hpp"
#include "geom/contour.hpp"
#include "motion/state.hpp"
#include "shop/tool.hpp"

namespace obrys::check {

class ThreadPasses {
public:
    /// `state`: what the moves that are taken are made with; it outlives this.
    ThreadPasses(const motion::State& state, Collector& out) : state_(state), out_(out) {}

    /// Every move, before it cuts: passes that join go on turning with the spindle.
    void follow(const Move& move);
    /// The move that was followed last takes `band` of the stock, in the (z, x) plane.
    void cut(const Move& move, const geom::Region& band, const shop::Tool& tool);
    /// The tool leaves its threads: whether their passes lie in one groove, or in those of several starts.
    void judge();

private:
    /// A straight piece of a pass, by the axis along which it goes farther: Z, or X on a face.
    struct Piece {
        cl::Record record;
        std::uint64_t index = 0;
        bool on_face = false;
        double begin = 0, end = 0;    ///< along the axis, mm
        double height = 0, rise = 0;  ///< across it: where it begins, and how much a mm along the axis
        double turns = 0;             ///< of the spindle where it begins
        double lead = 0;              ///< mm along the axis; > 0
        double change = 0;            ///< of the lead with every revolution, mm
        int spindle = 0;              ///< sense in which it turns; 0: not known
        [[nodiscard]] double height_at(double at) const { return height + rise * (at - begin); }
        [[nodiscard]] double turns_at(double at) const;
        /// Of the groove: +1 or -1, as the tool comes along the axis while the spindle turns.
        [[nodiscard]] int hand() const { return end > begin ? spindle : -spindle; }
    };
    /// Pieces whose bands overlap.
    struct Thread {
        geom::Region band;
        double tangent = 0;   ///< of the wider flank, against what is across the axis
        bool pointed = true;  ///< the insert is narrow: passes beside each other are no widening of the groove
        std::vector<Piece> pieces;
    };
    /// Where both pieces run; nothing where that is less than a turn.
    [[nodiscard]] static std::optional<double> common(const Piece& a, const Piece& b);
    [[nodiscard]] static double beside(const Piece& a, const Piece& b, double at);
    [[nodiscard]] bool differs(const Piece& first, const Piece& piece);
    void judge(const Thread& thread);
    void say_crossed(const Piece& piece, const Piece& other, double shift);

    const motion::State& state_;
    Collector& out_;
    double begins_ = 0, ends_ = 0;  ///< turns of the spindle, of the move that was followed
    bool joins_ = false;            ///< that move was a pass
    std::vector<Thread> threads_;
};

}  // namespace obrys::check
