#include "sim/time/times.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace obrys::sim::time {

double sum(const Seconds& s) { return std::accumulate(s.begin(), s.end(), 0.0); }

void merge(std::vector<Spent>& spent) {
    const auto key = [](const Spent& s) { return std::tuple(s.place, s.cause); };
    if (!std::is_sorted(spent.begin(), spent.end(), [&](const Spent& a, const Spent& b) { return key(a) < key(b); }))
        std::stable_sort(spent.begin(), spent.end(), [&](const Spent& a, const Spent& b) { return key(a) < key(b); });
    std::size_t n = 0;
    for (const Spent& s : spent) {
        if (n > 0 && key(spent[n - 1]) == key(s))
            spent[n - 1].seconds += s.seconds;
        else
            spent[n++] = s;
    }
    spent.resize(n);
}

}  // namespace obrys::sim::time
