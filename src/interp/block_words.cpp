
#include "interp/say.hpp"

namespace obrys::interp {

void BlockWords::clear() {
    present = used = twice = 0;
    groups = 0;
    m.clear();
    h.clear();
    axes.clear();
    tool_named = false;
    special = suppress = paraxial = corner_end = Modal::linear;
    special_number = surface_word = retract = 0;
    acted = stops_run = rapid = says_straight = polar_path = changes_plane = machine_axis = goes_on = false;
    feed_alone.reset();
    thread_start.reset();
    positioned.clear();
    pending.clear();
    behind.clear();
}

}  // namespace obrys::interp
