// Which jobs concern which tile of rays, and tiles shared out among threads. A tile's jobs run in the program's order
// and sums are formed in the order of the tiles, so that the number of threads changes nothing.

#include <algorithm>

#include "base/parallel.hpp"
#include "sim/milling/cut/job.hpp"

namespace obrys::sim::milling {
namespace {

/// Jobs of each tile of a direction, one tile after the other.
struct Bins {
    std::vector<std::uint32_t> begin;  ///< of tile t: order[begin[t]] to order[begin[t + 1]]
    std::vector<std::uint32_t> order;
    std::vector<Tally> tallies;  ///< for each of `order`
};

template <class Visit>
void visit_tiles(const Dexels& dexels, int axis, std::span<const Job> jobs, Visit&& visit) {
    for (std::uint32_t n = 0; n < jobs.size(); ++n) {
        const TileRange r = tiles_of(jobs[n], dexels, axis);
        for (int tb = r.b0; tb < r.b1; ++tb)
            for (int ta = r.a0; ta < r.a1; ++ta)
                if (may_touch(jobs[n], dexels.lattice(), axis, ta, tb))
                    visit(static_cast<std::size_t>(tb * dexels.tiles_a(axis) + ta), n);
    }
}

Bins make_bins(const Dexels& dexels, int axis, std::span<const Job> jobs) {
    Bins bins;
    const auto tiles = static_cast<std::size_t>(dexels.tiles_a(axis)) * static_cast<std::size_t>(dexels.tiles_b(axis));
    bins.begin.resize(tiles + 1);
    visit_tiles(dexels, axis, jobs, [&](std::size_t tile, std::uint32_t) { ++bins.begin[tile + 1]; });
    for (std::size_t t = 0; t < tiles; ++t) bins.begin[t + 1] += bins.begin[t];
    bins.order.resize(bins.begin.back());
    bins.tallies.resize(bins.begin.back());
    std::vector<std::uint32_t> next = bins.begin;
    visit_tiles(dexels, axis, jobs, [&](std::size_t tile, std::uint32_t n) { bins.order[next[tile]++] = n; });
    return bins;
}

struct Task {
    int axis = 0;
    std::size_t tile = 0;
    std::uint32_t jobs = 0;
};

std::vector<Task> tasks_of(const std::array<Bins, 3>& bins) {
    std::vector<Task> tasks;
    for (int axis = 0; axis < 3; ++axis) {
        const auto& begin = bins[static_cast<std::size_t>(axis)].begin;
        for (std::size_t t = 0; t + 1 < begin.size(); ++t)
            if (begin[t + 1] > begin[t]) tasks.push_back({axis, t, begin[t + 1] - begin[t]});
    }
    // The large ones first, so that no thread is left with one at the end.
    std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) { return a.jobs > b.jobs; });
    return tasks;
}

}  // namespace

void cut_all(Dexels& dexels, std::span<const Job> jobs, std::span<Tally> tallies, int threads) {
    std::array<Bins, 3> bins;
    base::with_threads(threads, [&] {
        base::one_by_one(3, [&](std::size_t axis) { bins[axis] = make_bins(dexels, static_cast<int>(axis), jobs); });
        const std::vector<Task> tasks = tasks_of(bins);
        for (const Task& task : tasks) {  // tiles part from those of copies before several threads ask for them
            const auto across = static_cast<std::size_t>(dexels.tiles_a(task.axis));
            (void)dexels.tile(task.axis, static_cast<int>(task.tile % across), static_cast<int>(task.tile / across));
        }
        base::one_by_one(tasks.size(), [&](std::size_t i) {
            const Task& task = tasks[i];
            Bins& b = bins[static_cast<std::size_t>(task.axis)];
            const auto across = static_cast<std::size_t>(dexels.tiles_a(task.axis));
            const int ta = static_cast<int>(task.tile % across), tb = static_cast<int>(task.tile / across);
            const std::size_t begin = b.begin[task.tile];
            cut_tile(dexels.tile(task.axis, ta, tb), dexels.lattice(), task.axis, ta, tb, jobs,
                     std::span(b.order).subspan(begin, task.jobs), std::span(b.tallies).subspan(begin, task.jobs));
        });
    });
    for (const Bins& b : bins)
        for (std::size_t i = 0; i < b.order.size(); ++i) join(tallies[b.order[i]], b.tallies[i]);
}

}  // namespace obrys::sim::milling
