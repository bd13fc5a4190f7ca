#include "dialect/heidenhain/iso_cycle_words.hpp"

#include <array>

namespace obrys::dialect::heidenhain {

namespace {

using Role = program::CycleRole;
using W = IsoCycleWord;

constexpr std::array words{
    W{4, "F", Role::dwell},
    W{36, "S", Role::spindle_angle},
    W{53, "P01", Role::datum_number},
    W{56, "P01", Role::clearance},
    W{56, "P02", Role::depth},
    W{56, "P03", Role::infeed},
    W{56, "P04", Role::feed_plunge},
    W{56, "P05", Role::allowance_side},
    W{57, "P01", Role::clearance},
    W{57, "P02", Role::depth},
    W{57, "P03", Role::infeed},
    W{57, "P04", Role::feed_plunge},
    W{57, "P05", Role::allowance_side},
    W{57, "P06", Role::angle},
    W{57, "P07", Role::feed_mill},
    W{58, "P01", Role::clearance},
    W{58, "P02", Role::depth},
    W{58, "P03", Role::infeed},
    W{58, "P04", Role::feed_plunge},
    W{58, "P05", Role::feed_mill},
    W{59, "P01", Role::clearance},
    W{59, "P02", Role::depth},
    W{59, "P03", Role::infeed},
    W{59, "P04", Role::feed_plunge},
    W{59, "P05", Role::feed_mill},
    W{62, "T", Role::tolerance},
    W{62, "P01", Role::tolerance_mode},
    W{62, "P02", Role::tolerance_angle},
    W{72, "F", Role::factor},
    W{73, "H", Role::angle},
    W{74, "P01", Role::clearance},
    W{74, "P02", Role::depth},
    W{74, "P03", Role::infeed},
    W{74, "P04", Role::feed_plunge},
    W{74, "P05", Role::axis_x},
    W{74, "P06", Role::axis_y},
    W{74, "P07", Role::feed_mill},
    W{75, "P01", Role::clearance},
    W{75, "P02", Role::depth},
    W{75, "P03", Role::infeed},
    W{75, "P04", Role::feed_plunge},
    W{75, "P05", Role::axis_x},
    W{75, "P06", Role::axis_y},
    W{75, "P07", Role::feed_mill},
    W{75, "P08", Role::corner_radius},
    W{76, "P01", Role::clearance},
    W{76, "P02", Role::depth},
    W{76, "P03", Role::infeed},
    W{76, "P04", Role::feed_plunge},
    W{76, "P05", Role::axis_x},
    W{76, "P06", Role::axis_y},
    W{76, "P07", Role::feed_mill},
    W{76, "P08", Role::corner_radius},
    W{77, "P01", Role::clearance},
    W{77, "P02", Role::depth},
    W{77, "P03", Role::infeed},
    W{77, "P04", Role::feed_plunge},
    W{77, "P05", Role::radius},
    W{77, "P06", Role::feed_mill},
    W{78, "P01", Role::clearance},
    W{78, "P02", Role::depth},
    W{78, "P03", Role::infeed},
    W{78, "P04", Role::feed_plunge},
    W{78, "P05", Role::radius},
    W{78, "P06", Role::feed_mill},
    W{80, "F", Role::feed_position},
    W{80, "S", Role::setup_distance},
    W{83, "P01", Role::clearance},
    W{83, "P02", Role::depth},
    W{83, "P03", Role::infeed},
    W{83, "P04", Role::dwell},
    W{83, "P05", Role::feed_plunge},
    W{84, "P01", Role::clearance},
    W{84, "P02", Role::depth},
    W{84, "P03", Role::dwell},
    W{84, "P04", Role::feed_plunge},
    W{85, "P01", Role::clearance},
    W{85, "P02", Role::depth},
    W{85, "P03", Role::pitch},
    W{86, "P01", Role::depth},
    W{86, "P02", Role::pitch},
};

}  // namespace

std::span<const IsoCycleWord> all_iso_words() { return words; }

const IsoCycleWord* find_iso_word(int g, std::string_view word) {
    for (const IsoCycleWord& w : words)
        if (w.g == g && w.word == word) return &w;
    return nullptr;
}

int iso_direction(int g) {
    switch (g) {
        case 58:
        case 75:
        case 77: return -1;
        case 59:
        case 76:
        case 78: return 1;
        default: return 0;
    }
}

}  // namespace obrys::dialect::heidenhain
