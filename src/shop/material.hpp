#pragma once
/// What a workpiece is made of, as far as cutting it is concerned. File format: docs/cutting-data.md.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/source.hpp"

namespace obrys::shop {

/// Kienzle: an edge of width b with a chip of thickness h is pushed by kc11 b h^(1 - mc) against the cut.
struct KienzleLaw {
    double kc11 = 0;      ///< N/mm2, at h = 1 mm
    double mc = 0;        ///< from 0 up to less than 1
    double rake = 0;      ///< degrees, for which kc11 holds
    double thinnest = 0;  ///< mm, of the chips that the values were found for
    double thickest = INFINITY;
    std::string source;
};

/// The linear law: (K c h + K e) b along the cut, square to it, along the edge.
struct LinearLaw {
    double tangential = 0, radial = 0, axial = 0;                 ///< N/mm2: Ktc, Krc, Kac
    double edge_tangential = 0, edge_radial = 0, edge_axial = 0;  ///< N/mm: Kte, Kre, Kae
    std::string tool, source;
};

struct WorkMaterial {
    std::string name;                                     ///< key of its table
    std::vector<std::string> names;                       ///< others: of alloys, numbers
    std::string text;                                     ///< for people
    char iso = ' ';                                       ///< ISO 513: P, M, K, N, S, H; a blank: not said
    int vdi = 0;                                          ///< group of VDI 3323; 0: not said
    std::optional<double> hardness, density, elasticity;  ///< HB, kg/m3, N/mm2
    std::optional<KienzleLaw> kienzle;
    std::optional<LinearLaw> linear;
    base::Span where{};
};

/// By its name or one of its others, whatever their case; null where there is none.
[[nodiscard]] const WorkMaterial* find_material(const std::vector<WorkMaterial>& all, const std::string& name);
/// What to do about a name that none of them has.
[[nodiscard]] std::string material_remedy(const std::vector<WorkMaterial>& all, const std::string& name);

}  // namespace obrys::shop
