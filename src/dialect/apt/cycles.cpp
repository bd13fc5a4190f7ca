/// Sources: the corpus (DRILL, DEEP2 and their FEDTO, RAPTO, RTRCTO: distances from the point, as the Klartext made of
/// them shows); PTC's couplets DEPTH, CLEAR, RETURN, STEP; ICAM, release notes V23 (STEP, BACK of DEEP and BRKCHP).

#include "dialect/apt/cycles.hpp"

#include <algorithm>
#include <array>

namespace obrys::dialect::apt {

namespace {

constexpr std::array holes{
    HoleWord{"BORE", Hole::feed_out},    HoleWord{"BRKCHP", Hole::chip_break}, HoleWord{"CBORE", Hole::drill},
    HoleWord{"CSINK", Hole::drill},      HoleWord{"DEEP", Hole::peck},         HoleWord{"DEEP2", Hole::peck},
    HoleWord{"DRILL", Hole::drill},      HoleWord{"FACE", Hole::drill},        HoleWord{"PECK", Hole::peck},
    HoleWord{"REAM", Hole::feed_out},    HoleWord{"SPOT", Hole::drill},        HoleWord{"SPTFAC", Hole::drill},
    HoleWord{"TAP", Hole::tap_floating},
};

constexpr std::array couplets{
    Couplet{"1STPECK", HoleValue::first_step}, Couplet{"BACK", HoleValue::back},
    Couplet{"CLEAR", HoleValue::clearance},    Couplet{"DEPTH", HoleValue::depth},
    Couplet{"DWELL", HoleValue::dwell},        Couplet{"FEDTO", HoleValue::depth},
    Couplet{"INCR", HoleValue::step},          Couplet{"IPM", HoleValue::inch_minute},
    Couplet{"IPR", HoleValue::inch_turn},      Couplet{"MMPM", HoleValue::feed_minute},
    Couplet{"MMPR", HoleValue::feed_turn},     Couplet{"PERMIN", HoleValue::plain_minute},
    Couplet{"PERREV", HoleValue::plain_turn},  Couplet{"PITCH", HoleValue::pitch},
    Couplet{"RAPTO", HoleValue::rapid_to},     Couplet{"RETURN", HoleValue::retract},
    Couplet{"RTRCTO", HoleValue::retract},     Couplet{"STEP", HoleValue::step},
    Couplet{"SUBPECK", HoleValue::step},       Couplet{"TPI", HoleValue::threads_inch},
};

template <class Table>
auto find_in(const Table& table, std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.name == name; });
    return found == table.end() ? nullptr : &*found;
}

}  // namespace

const HoleWord* find_hole(std::string_view upper) { return find_in(holes, upper); }
const Couplet* find_couplet(std::string_view upper) { return find_in(couplets, upper); }

}  // namespace obrys::dialect::apt
