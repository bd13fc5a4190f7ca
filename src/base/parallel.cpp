#include "base/parallel.hpp"

#ifdef OBRYS_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <optional>
#endif

namespace obrys::base {

#ifdef OBRYS_TBB

using Range = tbb::blocked_range<std::size_t>;

void in_pieces(std::size_t n, std::size_t grain, FunctionRef<void(const Piece&)> work) {
    tbb::parallel_for(Range(0, n, std::max<std::size_t>(grain, 1)),
                      [&](const Range& some) { work(Piece(some.begin(), some.end())); });
}

void one_by_one(std::size_t n, FunctionRef<void(std::size_t)> work) {
    tbb::parallel_for(
        Range(0, n, 1),
        [&](const Range& some) {
            for (std::size_t i = some.begin(); i < some.end(); ++i) work(i);
        },
        tbb::simple_partitioner());
}

void with_threads(int threads, FunctionRef<void()> work) {
    // Asked for more threads than there are processors, oneTBB would keep to the latter.
    std::optional<tbb::global_control> more;
    if (threads > tbb::this_task_arena::max_concurrency())
        more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    arena.execute([&] { work(); });
}

#else

void in_pieces(std::size_t n, std::size_t /*grain*/, FunctionRef<void(const Piece&)> work) {
    if (n > 0) work(Piece(0, n));
}

void one_by_one(std::size_t n, FunctionRef<void(std::size_t)> work) {
    for (std::size_t i = 0; i < n; ++i) work(i);
}

void with_threads(int /*threads*/, FunctionRef<void()> work) { work(); }

#endif

}  // namespace obrys::base
