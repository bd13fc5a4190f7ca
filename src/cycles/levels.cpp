#include "cycles/levels.hpp"

#include <algorithm>

namespace obrys::cycles {

double Infeeds::of(int step) const {
    return decrement > 0 ? std::min(first, std::max(first - step * decrement, least)) : first;
}

std::vector<double> levels_of(Course& c, double top, double bottom, const Infeeds& infeeds) {
    std::vector<double> levels;
    double level = top;
    for (int step = 0; level > bottom + same_depth; ++step) {
        const double infeed = infeeds.of(step);
        if (infeed <= 0 || levels.size() >= most_steps / 8) {
            c.fault(Role::infeed, "the infeeds do not reach the depth",
                    "enter a larger plunging depth or a minimum plunging depth");
            return {};
        }
        level = infeeds.decrement > 0 ? level - infeed : top - (step + 1) * infeed;  // equal steps add up no error
        if (level < bottom + same_depth) level = bottom;
        levels.push_back(level);
    }
    return levels;
}

void check_breaks(Course& c, double every, double hole) {
    if (every > 0 && hole / every > double(most_steps) / 8)
        c.fault(Role::chip_break_depth, "the infeed depth for chip breaking is too small for the depth");
}

namespace {

/// On from depth `from` to `level`, with a chip break every so often.
void down_with_breaks(Course& c, double from, double level, const Pecking& p) {
    for (int k = 1; p.break_every > 0 && from - k * p.break_every > level + same_depth && c.room(); ++k) {
        const double depth = from - k * p.break_every;
        c.move_w(depth, p.feed);
        c.move_w(std::min(depth + p.break_distance, p.retract_to), chip_break_feed);
    }
    c.move_w(level, p.feed);
}

}  // namespace

void peck_down(Course& c, const std::vector<double>& levels, const Pecking& p) {
    for (std::size_t i = 0; i < levels.size() && c.room(); ++i) {
        down_with_breaks(c, i == 0 ? p.top : levels[i - 1], levels[i], p);
        if (i + 1 == levels.size()) break;
        const double part = levels.size() > 2 ? double(i) / double(levels.size() - 2) : 0;
        c.rapid_w(p.retract_to);
        c.rapid_w(std::min(p.retract_to, levels[i] + p.first_stop + part * (p.last_stop - p.first_stop)));
    }
}

}  // namespace obrys::cycles
