// A module that reads no STEP: what it does stands in the file, behind the word FAKE. With it the loader is tested
// without Open CASCADE, and with modules as they should not be.
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "mesh/step_module.hpp"

#ifndef FAKE_ABI
#define FAKE_ABI obrys::mesh::obrys_step_abi
#endif

namespace {

using namespace obrys::mesh;

/// A box, every triangle with corners of its own.
void box(const ObrysStepSink& sink, double x0, double x1, bool hole = false, std::uint32_t beyond = 0) {
    constexpr std::array<std::array<int, 3>, 12> corners{{{0, 2, 1},
                                                          {1, 2, 3},
                                                          {4, 5, 6},
                                                          {5, 7, 6},
                                                          {0, 1, 4},
                                                          {1, 5, 4},
                                                          {2, 6, 3},
                                                          {3, 6, 7},
                                                          {0, 4, 2},
                                                          {2, 4, 6},
                                                          {1, 3, 5},
                                                          {3, 7, 5}}};
    std::vector<double> vertices;
    std::vector<std::uint32_t> triangles;
    for (std::size_t t = hole ? 1 : 0; t < corners.size(); ++t)
        for (const int c : corners[t]) {
            triangles.push_back(static_cast<std::uint32_t>(vertices.size() / 3) + beyond);
            vertices.insert(vertices.end(),
                            {(c & 1) != 0 ? x1 : x0, (c & 2) != 0 ? 10.0 : 0.0, (c & 4) != 0 ? 10.0 : 0.0});
        }
    sink.solid(sink.context, vertices.data(), vertices.size() / 3, triangles.data(), triangles.size() / 3);
}

void act(std::string_view what, const ObrysStepFineness& fineness, const ObrysStepSink& sink, ObrysStepResult& result) {
    const auto is = [&](std::string_view word) { return what.find(word) != std::string_view::npos; };
    if (is("chatter")) std::puts("this is not to be seen"), std::fflush(stdout);
    if (is("crash") || (is("weak") && fineness.other_way == 0)) std::raise(SIGSEGV);
    if (is("leave")) _exit(0);
    if (is("throw")) throw std::runtime_error("which no module does");
    while (is("hang")) pause();
    while (is("endless")) box(sink, 0, 10);
    if (is("memory")) std::vector<char> much(std::size_t{1} << 40, 'x');
    if (is("two")) box(sink, 20, 30);
    if (is("line")) result.line = 2;
    if (is("refuse")) {
        constexpr std::string_view why = "it does not please";
        result.outcome = obrys_step_syntax;
        return sink.problem(sink.context, why.data(), why.size());
    }
    box(sink, is("fineness") ? fineness.deflection * 1000 : 0, 10, is("hole") && fineness.other_way == 0,
        is("beyond") ? 1 : 0);
    if (is("odd")) result.complaints = 2;
    if (is("loose")) result.loose_faces = 3;
    if (is("open")) result.faces_unmeshed = 1;
}

}  // namespace

extern "C" {
__attribute__((visibility("default"))) int obrys_step_abi_version() { return FAKE_ABI; }
__attribute__((visibility("default"))) void obrys_step_read(const char* bytes, std::size_t size,
                                                            const ObrysStepFineness* fineness,
                                                            const ObrysStepSink* sink, ObrysStepResult* result) {
    act({bytes, size}, *fineness, *sink, *result);
}
}
