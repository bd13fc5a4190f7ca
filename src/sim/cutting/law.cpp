#include "sim/cutting/law.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::cutting {

Law kienzle_law(const shop::KienzleLaw& law) {
    Law l;
    l.cut = {law.kc11, radial_ratio * law.kc11, axial_ratio * law.kc11};
    l.exponent = law.mc;
    l.thinnest = law.thinnest;
    l.thickest = law.thickest;
    l.ratios_assumed = true;
    l.name = "Kienzle";
    l.source = law.source;
    return l;
}

Law linear_law(const shop::LinearLaw& law) {
    Law l;
    l.cut = {law.tangential, law.radial, law.axial};
    l.edge = {law.edge_tangential, law.edge_radial, law.edge_axial};
    l.least_chip = usual_least_chip;
    l.name = "linear";
    l.source = law.source;
    return l;
}

Law law_for(const shop::WorkMaterial& material, double chip) {
    const bool kienzle = material.kienzle && (!material.linear || !(chip < material.kienzle->thinnest));
    return kienzle ? kienzle_law(*material.kienzle) : linear_law(*material.linear);
}

double edge_share(const Law& law, double chip) { return chip < law.least_chip ? chip / law.least_chip : 1; }

EdgeForce force(const Law& law, double chip) {
    if (!(chip > 0)) return {};
    const double cut = law.exponent == 0 ? chip : std::pow(chip, 1 - law.exponent);
    const double edge = edge_share(law, chip);
    return {law.cut.tangential * cut + law.edge.tangential * edge, law.cut.radial * cut + law.edge.radial * edge,
            law.cut.axial * cut + law.edge.axial * edge};
}

}  // namespace obrys::sim::cutting
