/// Sources: CATIA: texts of the corpus, and Dassault's "Syntaxes Interpreted by APT Import". NX: the CLSF Manager's
/// page on CIRCLE as quoted in the Siemens NX Manufacturing forum ("i,j,k is the circle or helix axis vector in the MCS
/// (assuming a clockwise direction)"), and ICAM V23's release notes (CIR_360 is NO for NX). Creo: PTC, "CL Output for
/// Circular Interpolation" (right hand rule, several points an arc). SolidWorks CAM: texts of the corpus with the
/// Klartext that their postprocessor made. PowerMill: Delcam, "CLDATA as used by PowerMill" (ISO 4343); the thesis of
/// 2021 on its postprocessor for Acramatic 2100 (the hole's top and the pecks that count from it). Mastercam: its NCI
/// as APT by ICAM's conversion; nothing of its own is known to differ.

#include "dialect/apt/systems.hpp"

#include <string>

#include "base/text.hpp"

namespace obrys::dialect::apt {

namespace {

constexpr std::array systems{
    System{.name = "APT"},
    System{.name = "CATIA", .signs = {"CATIAAPTVERSION", "$$*CATIA0", "$$TOOLCHANGEBEGINNING"}},
    System{.name = "NX",
           .signs = {"TOOLPATH/", "END-OF-PATH", "TLDATA/", "MSYS/", "PAINT/"},
           .sense = -1,
           .same_point_is_circle = false},
    System{.name = "Creo",
           .signs = {"$$->MFGNO", "$$->FEATNO", "$$->CSYS", "$$->CUTCOM_GEOMETRY", "PRO/CLFILE", "$$->END"},
           .several_points = true,
           .rapid_to = RapidTo::from_clearance},
    System{.name = "SolidWorks CAM", .signs = {"CSI_SET_", "TRNTYP/"}, .inserts_notes = true, .system_aims_tool = true},
    System{.name = "PowerMill", .signs = {"POWERMILL", "DUCTPOST"}, .holes_begin_at_surface = true},
    System{.name = "Mastercam", .signs = {"MASTERCAM", "$$MCAM"}},
};

}  // namespace

const System& system_of(std::string_view text) {
    std::string packed;
    for (const char c : text.substr(0, base::telling_bytes))
        if (!base::is_blank(c)) packed += base::upper(c);
    for (const System& s : systems)
        for (const std::string_view sign : s.signs)
            if (!sign.empty() && packed.find(sign) != std::string::npos) return s;
    return systems.front();
}

}  // namespace obrys::dialect::apt
