#pragma once
/// What the writer has in hand for some records.

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "geom/vec.hpp"
#include "write/commands.hpp"
#include "write/values.hpp"

namespace obrys::write {

/// The rotary axes turn in the block that tilts the plane.
struct PlaneTurn {
    bool rapid = false;
    std::optional<double> about{};  ///< mm before the tip: what stays there; nothing: the linear axes stand
    bool is_written = false;        ///< the words of the plane have done it
};

struct Lead {
    Command command = Command::onto_tangent_line;
    bool onto = true, rapid = false;
    Values values;
};

/// Calls and repetitions that are open.
struct OpenPart {
    bool in_layout = false;  ///< else it is a contour of a cycle, or the like
    bool whole = true;       ///< it may be called by itself
};

/// Cycles of the control's own, one behind the other, as the text has them.
struct CycleSeries {
    bool open = false;
    std::string defined;         ///< cycle in force, as printed
    std::string called;          ///< the last one without its place
    std::set<std::string> says;  ///< letters of words that the series keeps
    double level = 0;            ///< Z, as programmed, where it has begun
    bool rises = false;          ///< the cycle that was written ends below where the tool stands behind it

    /// Whether a cycle with these words can be one of it: a word that it keeps and the cycle does not say would hold
    /// for that, too.
    [[nodiscard]] bool takes(const std::set<std::string>& own) const {
        return std::includes(own.begin(), own.end(), says.begin(), says.end());
    }
    /// Whether nothing but the place differs from the last cycle; what there is besides is remembered.
    [[nodiscard]] bool is_again(std::string without_place) {
        const bool same = open && without_place == called;
        called = std::move(without_place);
        return same;
    }
    void end() {
        open = false;
        defined.clear();
        says.clear();
    }
};

/// Taps that the text makes.
struct TapState {
    std::string stops;           ///< the one that was written stops the spindle by itself: the word for that
    bool spindle_ready = false;  ///< for the one that is being written
    bool returns = false;        ///< the next tapping move is the way back of the last one
    geom::Vec3 from;             ///< where that one began

    /// A tapping move from here: whether it is the way back of the one before.
    [[nodiscard]] bool is_way_back(bool taps, const geom::Vec3& here) {
        const bool back = taps && std::exchange(returns, false);
        returns = taps && !back;
        if (!back) from = here;
        return back;
    }
};

}  // namespace obrys::write
