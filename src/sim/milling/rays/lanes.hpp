#pragma once
/// For loops over the rays of a row that the compiler is to take several at a time.

// With AVX2 four rays go at a time instead of two; without FMA, so the results are the same to the last bit. Functions
// that are chosen at load time and the sanitizers do not go together.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define OBRYS_LANES __attribute__((target_clones("avx2", "default")))
#else
#define OBRYS_LANES
#endif

namespace obrys::sim::milling::detail {

/// Spans have room for a multiple of four.
constexpr int in_full(int count) { return (count + 3) & ~3; }

}  // namespace obrys::sim::milling::detail
