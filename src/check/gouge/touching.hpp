#pragma once
/// Places in cubes of a lattice that touch each other.

#include <array>
#include <map>
#include <vector>

namespace obrys::check {

using Cube = std::array<long, 3>;

/// Things with a cube of their own, in groups of which each hangs together by sides, edges or corners of the cubes.
template <class T>
[[nodiscard]] std::vector<std::vector<const T*>> touching(const std::vector<T>& all) {
    std::map<Cube, const T*> cubes;
    for (const T& c : all) cubes.emplace(c.cube, &c);
    std::vector<std::vector<const T*>> groups;
    while (!cubes.empty()) {
        std::vector<const T*>& group = groups.emplace_back();
        std::vector<Cube> next{cubes.begin()->first};
        while (!next.empty()) {
            const Cube at = next.back();
            next.pop_back();
            const auto here = cubes.find(at);
            if (here == cubes.end()) continue;
            group.push_back(here->second);
            cubes.erase(here);
            for (long i = -1; i <= 1; ++i)
                for (long j = -1; j <= 1; ++j)
                    for (long k = -1; k <= 1; ++k) next.push_back({at[0] + i, at[1] + j, at[2] + k});
        }
    }
    return groups;
}

}  // namespace obrys::check
