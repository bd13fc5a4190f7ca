#pragma once
/// What the loadable module that reads STEP files and its loader agree on: plain C, nothing of Open CASCADE in it, and
/// no exception comes out. The module is the library `libobrys-step.so`; it is found by the names of the two functions.

#include <cstddef>
#include <cstdint>

namespace obrys::mesh {

extern "C" {

/// Raised whenever something in this header changes; a module of another number is not used.
enum { obrys_step_abi = 1 };

struct ObrysStepFineness {
    double deflection;  ///< how far a triangle's edge may leave the surface, mm
    double angle;       ///< and how far it may turn from one edge to the next, radians
    int other_way;      ///< 0: the usual way of making triangles; else another, slower one, where that left holes
};

/// Where the module says what it found; everything handed over is valid during the call only.
struct ObrysStepSink {
    void* context;
    /// A body of its own: x, y, z of each vertex in mm, three vertices a triangle, counter-clockwise seen from outside.
    /// Equal vertices are not joined, and triangles may be without area.
    void (*solid)(void* context, const double* vertices, std::size_t vertex_count, const std::uint32_t* triangles,
                  std::size_t triangle_count);
    /// What is wrong, in words, UTF-8, not terminated; at most once, where the outcome is not `obrys_step_ok`.
    void (*problem)(void* context, const char* text, std::size_t size);
};

enum ObrysStepOutcome {
    obrys_step_ok = 0,
    obrys_step_syntax = 1,    ///< no STEP file, or a damaged one
    obrys_step_no_solid = 2,  ///< nothing in it bounds material: no geometry, surfaces only, or what is not understood
    obrys_step_failed = 3,    ///< could not be made into triangles
    obrys_step_memory = 4,
};

struct ObrysStepResult {
    int outcome;                   ///< ObrysStepOutcome
    std::uint64_t line;            ///< where the file is damaged, from 1; 0 where that is not known
    std::uint64_t complaints;      ///< entries that were not understood as they are; what they say may be missing
    std::uint64_t loose_faces;     ///< outside of solids; left out
    std::uint64_t faces_unmeshed;  ///< of solids, where no triangles could be made: these have holes
};

using ObrysStepAbi = int (*)();
using ObrysStepRead = void (*)(const char* bytes, std::size_t size, const ObrysStepFineness* fineness,
                               const ObrysStepSink* sink, ObrysStepResult* result);

/// What a module exports: `int obrys_step_abi_version()` and `void obrys_step_read(…)` of these types.
}

inline constexpr char step_abi_symbol[] = "obrys_step_abi_version";
inline constexpr char step_read_symbol[] = "obrys_step_read";

}  // namespace obrys::mesh
