#include <cmath>

#include "base/number.hpp"
#include "write/staircase.hpp"

namespace obrys::write {

std::string text_of(const StaircaseSums& sums, const StaircaseForm& form) {
    const auto mm = [](double length) { return base::shortest(std::round(length * 1e4) / 1e4) + " mm"; };
    const auto count = [](std::uint64_t n, const std::string& what) {
        return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
    };
    std::string out;
    if (sums.slopes + sums.arcs > 0)
        out = "staircases: " + count(sums.slopes, "slope") + " and " + count(sums.arcs, "arc") + " in " +
              count(sums.moves, "move") + " along one axis each";
    if (sums.touching > 0)
        out += "; ridges on the contour at most " + mm(sums.ridge) + " high (asked for: " + mm(form.roughness) +
               "), the tool at most " + mm(sums.beside) + " beside its path, away from the part";
    if (sums.either > 0)
        out += "; where nobody says on which side the part is, at most " + mm(sums.either) + " beside the path";
    if (sums.into > 0) out += "; at most " + mm(sums.into) + " into other parts of the contour, which is too narrow";
    if (sums.above > 0) out += "; at most " + mm(sums.above) + " above paths that rise or fall";
    if (sums.rapids > 0) out += (out.empty() ? "" : "; ") + count(sums.rapids, "rapid") + " axis by axis";
    return out;
}

}  // namespace obrys::write
