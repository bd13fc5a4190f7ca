#include "driver/control.hpp"

#include <algorithm>
#include <array>

#include "read/heidenhain/read.hpp"
#include "read/rs274/fanuc_read.hpp"
#include "read/rs274/read.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::driver {

namespace {

constexpr std::array<std::string_view, 2> sinumerik_programs{".SPF", ".MPF"}, sinumerik_definitions{".DEF", ".GUD"};
constexpr std::array<std::string_view, 2> heidenhain_programs{".H", ".I"};
constexpr std::array<std::string_view, 6> rs274_programs{".NGC", ".NC", ".TAP", ".GCODE", ".CNC", ".TXT"};

/// "O<FOO>" lies in FOO, "O100" in 100.
std::string o_word_file(std::string_view program) {
    if (program.starts_with("O<") && program.ends_with(">")) return std::string(program.substr(2, program.size() - 3));
    return std::string(program.substr(program.starts_with("O") ? 1 : 0));
}

/// A file that holds one program.
template <program::Unit (*read)(std::uint32_t, const base::Sources&, program::Names&, base::Diagnostics&)>
std::vector<program::Unit> alone(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                 base::Diagnostics& diagnostics) {
    std::vector<program::Unit> units;
    units.push_back(read(file, sources, names, diagnostics));
    return units;
}

constexpr std::array sinumerik_languages{
    Language{base::BlockNumbers::n_word, read::sinumerik::read, read::sinumerik::likelihood},
};
constexpr std::array heidenhain_languages{
    Language{base::BlockNumbers::leading, alone<read::heidenhain::read>, read::heidenhain::likelihood},
    Language{base::BlockNumbers::n_word, alone<read::heidenhain::read_iso>, read::heidenhain::iso_likelihood},
};

constexpr std::array linuxcnc_languages{
    Language{base::BlockNumbers::n_word, read::rs274::read_linuxcnc, read::rs274::linuxcnc_likelihood},
};

constexpr std::array fanuc_languages{
    Language{base::BlockNumbers::n_word, read::rs274::read_fanuc, read::rs274::fanuc_likelihood},
};
constexpr std::array haas_languages{
    Language{base::BlockNumbers::n_word, read::rs274::read_haas, read::rs274::haas_likelihood},
};

constexpr std::array controls_table{
    Control{"sinumerik-840d", sinumerik_languages, sinumerik_programs, sinumerik_definitions},
    Control{"heidenhain-itnc530", heidenhain_languages, heidenhain_programs, {}},
    Control{"linuxcnc", linuxcnc_languages, rs274_programs, {}, o_word_file},
    Control{"fanuc", fanuc_languages, rs274_programs, {}, o_word_file},
    Control{"haas", haas_languages, rs274_programs, {}, o_word_file},
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
    for (const Control& c : controls_table) {
        const int n = language_of(c, text, file_name).likelihood(text, file_name);
        if (best.control == nullptr || n > best.likelihood) best = {&c, n};
    }
    return best;
}

const Language& language_of(const Control& control, std::string_view text, std::string_view file_name) {
    return *std::max_element(control.languages.begin(), control.languages.end(),
                             [&](const Language& a, const Language& b) {
                                 return a.likelihood(text, file_name) < b.likelihood(text, file_name);
                             });
}

}  // namespace obrys::driver
