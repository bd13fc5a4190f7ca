#include "driver/control.hpp"

#include <algorithm>
#include <array>

#include "read/apt/read.hpp"
#include "read/fusion/read.hpp"
#include "read/heidenhain/read.hpp"
#include "read/rs274/acramatic_read.hpp"
#include "read/rs274/fanuc/read.hpp"
#include "read/rs274/nc470_read.hpp"
#include "read/rs274/read.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::driver {

namespace {

constexpr std::array<std::string_view, 2> sinumerik_programs{".SPF", ".MPF"}, sinumerik_definitions{".DEF", ".GUD"};
constexpr std::array<std::string_view, 2> heidenhain_programs{".H", ".I"};
constexpr std::array<std::string_view, 6> rs274_programs{".NGC", ".NC", ".TAP", ".GCODE", ".CNC", ".TXT"};

constexpr std::array<std::string_view, 7> apt_programs{".APTSOURCE", ".APT", ".NCL", ".CLS", ".CLF", ".CLDATA", ".CL"};

constexpr std::array<std::string_view, 1> fusion_programs{".CNC"};

/// "O<FOO>" lies in FOO, "O100" in 100.
std::string o_word_file(std::string_view program) {
    if (program.starts_with("O<") && program.ends_with(">")) return std::string(program.substr(2, program.size() - 3));
    return std::string(program.substr(program.starts_with("O") ? 1 : 0));
}

/// A file that holds one program, for any machine.
template <program::Unit (*read)(std::uint32_t, const base::Sources&, program::Names&, base::Diagnostics&)>
std::vector<program::Unit> alone(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                 base::Diagnostics& diagnostics, const shop::Machine*) {
    std::vector<program::Unit> units;
    units.push_back(read(file, sources, names, diagnostics));
    return units;
}
/// A file of several programs, for any machine.
template <std::vector<program::Unit> (*read)(std::uint32_t, const base::Sources&, program::Names&, base::Diagnostics&)>
std::vector<program::Unit> several(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                   base::Diagnostics& diagnostics, const shop::Machine*) {
    return read(file, sources, names, diagnostics);
}

read::rs274::FanucOptions fanuc_options(const shop::Machine* machine) {
    using dialect::rs274::FanucMachine;
    using dialect::rs274::GSystem;
    using dialect::rs274::WholeNumbers;
    read::rs274::FanucOptions o;
    if (machine == nullptr) return o;
    o.machine = machine->kind == shop::MachineKind::lathe ? FanucMachine::lathe : FanucMachine::mill;
    const char system = machine->control.g_code_system.value_or('A');
    o.system = system == 'B' ? GSystem::b : system == 'C' ? GSystem::c : GSystem::a;
    o.whole_numbers =
        machine->control.whole_numbers_count.value_or(true) ? WholeNumbers::increments : WholeNumbers::units;
    const bool generic = machine->name.ends_with("-generic");  // the shipped ones have a C axis for whoever needs it
    for (const shop::MachineAxis& axis : machine->axes)
        if (!generic) o.c_axis = o.c_axis.value_or(false) || axis.name == "C";
    o.whole_numbers_known = machine->control.whole_numbers_count.has_value();
    return o;
}

std::vector<program::Unit> read_fanuc(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                      base::Diagnostics& diagnostics, const shop::Machine* machine) {
    return read::rs274::read_fanuc(file, sources, names, diagnostics, fanuc_options(machine));
}
std::vector<program::Unit> read_haas(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                     base::Diagnostics& diagnostics, const shop::Machine* machine) {
    return read::rs274::read_haas(file, sources, names, diagnostics, fanuc_options(machine));
}

constexpr program::RemarkSigns semicolon{.to_line_end = ';'}, brackets{.brackets = true},
    klartext{.to_line_end = ';', .star_blocks = true, .goes_on = '~'};

constexpr std::array sinumerik_languages{
    Language{base::BlockNumbers::n_word, several<read::sinumerik::read>, read::sinumerik::likelihood, semicolon},
};
constexpr std::array heidenhain_languages{
    Language{base::BlockNumbers::leading, alone<read::heidenhain::read>, read::heidenhain::likelihood, klartext},
    Language{base::BlockNumbers::n_word, alone<read::heidenhain::read_iso>, read::heidenhain::iso_likelihood, klartext},
};

constexpr std::array linuxcnc_languages{
    Language{base::BlockNumbers::n_word, several<read::rs274::read_linuxcnc>, read::rs274::linuxcnc_likelihood},
};

constexpr std::array fanuc_languages{
    Language{base::BlockNumbers::n_word, read_fanuc, read::rs274::fanuc_likelihood, brackets},
};
constexpr std::array haas_languages{
    Language{base::BlockNumbers::n_word, read_haas, read::rs274::haas_likelihood, brackets},
};

constexpr std::array acramatic_languages{
    Language{base::BlockNumbers::n_word, several<read::rs274::read_acramatic>, read::rs274::acramatic_likelihood,
             semicolon},
};
constexpr std::array nc470_languages{
    Language{base::BlockNumbers::n_word, several<read::rs274::read_nc470>, read::rs274::nc470_likelihood, brackets},
};
constexpr std::array apt_languages{
    Language{base::BlockNumbers::none, alone<read::apt::read>, read::apt::likelihood},
};

constexpr std::array fusion_languages{
    Language{base::BlockNumbers::none, alone<read::fusion::read>, read::fusion::likelihood},
};

/// src/emc/sai of LinuxCNC, common/tool.tbl; inches.
constexpr std::string_view linuxcnc_tools =
    "T1 P1 D0.125 Z0.511\nT2 P2 D0.0625 Z0.1\nT3 P3 D0.201 Z1.273\nT99999 P123 Z0.1\n";

constexpr std::array controls_table{
    Control{"sinumerik-840d",
            sinumerik_languages,
            sinumerik_programs,
            sinumerik_definitions,
            nullptr,
            false,
            false,
            read::sinumerik::is_definition_file,
            {},
            read::sinumerik::is_own_word},
    Control{"heidenhain-itnc530", heidenhain_languages, heidenhain_programs, {}},
    Control{"linuxcnc", linuxcnc_languages, rs274_programs, {}, o_word_file, false, false, nullptr, linuxcnc_tools},
    // G64 is the one of its group that holds when the control is switched on (lists of G codes: FANUC operator's
    // manual; Haas Mill Operator's Manual 96-8000).
    Control{"fanuc", fanuc_languages, rs274_programs, {}, o_word_file, true, true},
    Control{"haas", haas_languages, rs274_programs, {}, o_word_file, true, true},
    Control{"acramatic-2100", acramatic_languages, rs274_programs, {}},
    Control{"nc-470", nc470_languages, rs274_programs, {}},
    Control{"apt-cl", apt_languages, apt_programs, {}},
    Control{"fusion", fusion_languages, fusion_programs, {}},
};

}  // namespace

std::span<const Control> all_controls() { return controls_table; }

const Control* find_control(std::string_view name) {
    for (const Control& c : controls_table)
        if (c.name == name) return &c;
    return nullptr;
}

const Language& language_of(const Control& control, std::string_view text, std::string_view file_name) {
    return *std::max_element(control.languages.begin(), control.languages.end(),
                             [&](const Language& a, const Language& b) {
                                 return a.likelihood(text, file_name, nullptr) < b.likelihood(text, file_name, nullptr);
                             });
}

}  // namespace obrys::driver
