/// How far a surface written as STL lies from the exact one, both ways.
///
/// usage: milling_exact SCENE STL [--enough 0.01] [--each 60] [--most 60000] [--seed 1]
/// Prints how far places of the triangles (corners, middles of edges, interiors) lie from the exact surface, and places of
/// the exact surface from the triangles, the worst of each with its place.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <string>

#include "surface.hpp"
#include "triangles.hpp"

namespace {

using namespace exact;

struct Options {
    double enough = 0.01;
    std::size_t each = 60, most = 60000;
    std::uint64_t seed = 1;
};

struct Worst {
    double d = 0;
    V at;
    std::size_t beyond = 0, places = 0;
    void take(double off, V p, double enough) {
        ++places;
        if (off > enough) ++beyond;
        if (off > d) d = off, at = p;
    }
    void print(const char* what) const {
        std::printf("%s %.6f at %.6f %.6f %.6f, beyond %zu of %zu\n", what, d, at.x, at.y, at.z, beyond, places);
    }
};

/// Corners, middles of edges and some of the inside of triangles: of large ones more.
std::vector<V> places_of(const std::vector<Triangle>& triangles, const Options& options, Random& random) {
    std::vector<V> all;
    const double share = std::min(1.0, static_cast<double>(options.most) / (9.0 * static_cast<double>(triangles.size())));
    for (const Triangle& t : triangles) {
        const double area = norm(cross(t[1] - t[0], t[2] - t[0])) / 2;
        if (uniform(random, 0, 1) > share && area < 1) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            all.push_back(t[i]);
            const double k = uniform(random, 0.2, 0.8);
            all.push_back(k * t[i] + (1 - k) * t[(i + 1) % 3]);
            all.push_back(0.5 * (t[i] + t[(i + 1) % 3]));
        }
        const int inside = 2 + static_cast<int>(std::min(40.0, area));
        for (int i = 0; i < inside; ++i) {
            double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            all.push_back(i == 0 ? (1.0 / 3) * (t[0] + t[1] + t[2]) : t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
        }
    }
    return all;
}

int run(const std::string& scene, const std::string& stl, const Options& options) {
    std::ifstream in(scene);
    if (!in) throw std::runtime_error("cannot be read: " + scene);
    const Solid solid(in);
    const Triangles surface(read_stl(stl));
    Random random(options.seed);
    Worst inside, outside, missing;
    for (const V& p : places_of(surface.all(), options, random)) {
        const Off off = off_surface(solid, p, options.enough, random);
        (off.within ? inside : outside).take(off.found, p, options.enough);
    }
    for (const V& p : samples(solid, options.each, options.enough / 20, random))
        missing.take(surface.distance(p), p, options.enough);
    std::printf("triangles %zu\n", surface.all().size());
    inside.print("within");
    outside.print("outside");
    missing.print("missing");
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    if (argc < 3) {
        std::fprintf(stderr, "usage: milling_exact SCENE STL [--enough MM] [--each N] [--most N] [--seed N]\n");
        return 2;
    }
    for (int i = 3; i + 1 < argc; i += 2) {
        const std::string name = argv[i];
        if (name == "--enough") options.enough = std::atof(argv[i + 1]);
        if (name == "--each") options.each = std::strtoul(argv[i + 1], nullptr, 10);
        if (name == "--most") options.most = std::strtoul(argv[i + 1], nullptr, 10);
        if (name == "--seed") options.seed = std::strtoull(argv[i + 1], nullptr, 10);
    }
    try {
        return run(argv[1], argv[2], options);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "milling_exact: %s\n", e.what());
        return 2;
    }
}
