#include "report/picture/deviation_legend.hpp"

#include <algorithm>

#include "base/number.hpp"

namespace obrys::report::picture {

std::vector<PictureLegend> deviation_legend(const mesh::DeviationColours& colours, double allowed, double full) {
    std::vector<PictureLegend> out{{colours.palette[0], "within " + base::shortest(allowed) + " mm"}};
    const std::size_t steps = (colours.palette.size() - 1) / 2;
    std::vector<bool> there(colours.palette.size());
    for (const std::uint32_t tag : colours.tags) there[tag] = true;
    const auto limit = [&](std::size_t step) {
        return base::fixed(allowed + static_cast<double>(step) / static_cast<double>(steps) * (full - allowed), 3);
    };
    for (const bool gouge : {true, false}) {
        const std::size_t first = gouge ? 1 : 1 + steps;
        std::vector<std::size_t> used;
        for (std::size_t i = 0; i < steps; ++i)
            if (there[first + i]) used.push_back(i);
        for (std::size_t k = 0; k < used.size(); k += std::max<std::size_t>(used.size() - 1, 1)) {
            const std::size_t i = used[k];
            const std::string range = i + 1 == steps ? "over " + limit(i) : limit(i) + " \u2013 " + limit(i + 1);
            out.push_back({colours.palette[first + i], (gouge ? "too deep " : "too high ") + range + " mm"});
        }
    }
    return out;
}

}  // namespace obrys::report::picture
