#include "driver/control.hpp"

#include <array>

#include "read/heidenhain/read.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::driver {

namespace {

constexpr std::array<std::string_view, 2> sinumerik_programs{".SPF", ".MPF"}, sinumerik_definitions{".DEF", ".GUD"};
constexpr std::array<std::string_view, 1> klartext_programs{".H"};

std::vector<program::Unit> read_klartext(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                         base::Diagnostics& diagnostics) {
    std::vector<program::Unit> units;
    units.push_back(read::heidenhain::read(file, sources, names, diagnostics));
    return units;
}

constexpr std::array controls_table{
    Control{"sinumerik-840d", base::BlockNumbers::n_word, sinumerik_programs, sinumerik_definitions,
            read::sinumerik::read, read::sinumerik::likelihood},
    Control{"heidenhain-itnc530",
            base::BlockNumbers::leading,
            klartext_programs,
            {},
            read_klartext,
            read::heidenhain::likelihood},
};

}  // namespace

std::span<const Control> all_controls() { return controls_table; }

const Control* find_control(std::string_view name) {
    for (const Control& c : controls_table)
        if (c.name == name) return &c;
    return nullptr;
}

Guess guess_control(std::string_view text, std::string_view file_name) {
    Guess best;
    for (const Control& c : controls_table)
        if (const int n = c.likelihood(text, file_name); best.control == nullptr || n > best.likelihood) best = {&c, n};
    return best;
}

}  // namespace obrys::driver
