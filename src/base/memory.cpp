#include "base/memory.hpp"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace obrys::base {

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::size_t skipped = (large_page - first % large_page) % large_page;
    if (bytes < skipped + large_page) return;
    const std::size_t whole = (bytes - skipped) / large_page * large_page;
    static_cast<void>(::madvise(static_cast<char*>(begin) + skipped, whole, MADV_HUGEPAGE));
#endif
}

}  // namespace obrys::base
