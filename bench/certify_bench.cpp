// Cost of certified gouges: zig-zag finishing of a part of some 200 000 triangles, which is the exact envelope of the
// ball's way, so that every move touches it all along. usage: bench_certify [ROWS]
// Prints the time of all moves on one thread and on all, and that of a search for the deepest place where the part is
// raised by 0.02 mm.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "sim/certify/certify.hpp"

namespace {

using obrys::geom::Vec3;
namespace certify = obrys::sim::certify;
namespace mesh = obrys::mesh;

constexpr double tolerance = 0.01, radius = 3, size = 100, height = 25;  // mm

double surface(double x, double y) {
    return -4 + 2 * std::sin(x * 0.12) * std::cos(y * 0.09) + 0.7 * std::sin(x * 0.41 + y * 0.23);
}

/// Height of the part where the ball's tip may run anywhere on the surface.
double envelope(double x, double y) {
    constexpr double step = 0.15;
    double z = 1e9;
    for (double dx = -radius; dx <= radius; dx += step)
        for (double dy = -radius; dy <= radius; dy += step)
            if (const double r2 = dx * dx + dy * dy; r2 <= radius * radius)
                z = std::min(z, surface(x + dx, y + dy) + radius - std::sqrt(radius * radius - r2));
    return z;
}

/// Closed: the field, its walls and a floor.
mesh::Mesh part_of(std::uint32_t rows, double raised) {
    mesh::Mesh m;
    const auto id = [&](std::uint32_t i, std::uint32_t j) { return j * (rows + 1) + i; };
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (std::uint32_t i = 0; i <= rows; ++i) {
            const double x = i * size / rows, y = j * size / rows;
            m.vertices.push_back({x, y, envelope(x, y) + raised});
        }
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < rows; ++i) {
            m.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            m.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    std::vector<std::uint32_t> rim;
    for (std::uint32_t i = 0; i < rows; ++i) rim.push_back(id(i, 0));
    for (std::uint32_t j = 0; j < rows; ++j) rim.push_back(id(rows, j));
    for (std::uint32_t i = rows; i > 0; --i) rim.push_back(id(i, rows));
    for (std::uint32_t j = rows; j > 0; --j) rim.push_back(id(0, j));
    const auto base = static_cast<std::uint32_t>(m.vertices.size()), n = static_cast<std::uint32_t>(rim.size());
    for (const std::uint32_t v : rim) m.vertices.push_back({m.vertices[v].x, m.vertices[v].y, -10});
    m.vertices.push_back({size / 2, size / 2, -10});
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t k = (i + 1) % n;
        m.triangles.push_back({rim[i], base + i, base + k});
        m.triangles.push_back({rim[i], base + k, rim[k]});
        m.triangles.push_back({base + n, base + k, base + i});
    }
    return m;
}

std::vector<Vec3> zigzag(std::size_t moves) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> between(0.5, 1.5);
    std::vector<Vec3> tips;
    double x = 0, y = 0, sign = 1;
    const auto go = [&] { tips.push_back({x, y, surface(x, y)}); };
    for (go(); tips.size() <= moves; go()) {
        x += sign * 0.4 * between(random);
        if (x >= 0 && x <= size) continue;
        x = std::clamp(x, 0.0, size);
        go();
        y += 0.5;
        sign = -sign;
    }
    return tips;
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void run(const char* name, const certify::Judge& judge, const certify::Shape& tool, const std::vector<Vec3>& tips) {
    std::vector<char> clear(tips.size() - 1);
    const auto move = [&](std::size_t i) {
        return certify::Move{obrys::geom::Straight{tips[i], tips[i + 1]}, {0, 0, 1}, &tool};
    };
    const double start = now();
    for (std::size_t i = 0; i < clear.size(); ++i) clear[i] = judge.is_clear(move(i)) ? 1 : 0;
    const double one = now() - start;
    tbb::parallel_for(std::size_t{0}, clear.size(), [&](std::size_t i) { clear[i] = judge.is_clear(move(i)) ? 1 : 0; });
    const double all = now() - start - one;
    std::vector<std::size_t> met;
    for (std::size_t i = 0; i < clear.size(); ++i)
        if (clear[i] == 0) met.push_back(i);
    const std::size_t looked_at = std::min<std::size_t>(met.size(), 1000);
    const double before = now();
    double deepest = 0;
    for (std::size_t i = 0; i < looked_at; ++i)
        if (const auto found = judge.deepest(move(met[i]))) deepest = std::max(deepest, found->depth);
    std::printf("%-24s %8zu moves %7.3f s, %7.3f s on all cores; %zu not clear", name, clear.size(), one, all,
                met.size());
    if (looked_at > 0)
        std::printf(", %.0f us for the depth of each, %.4f at most", 1e6 * (now() - before) / double(looked_at),
                    deepest);
    std::puts("");
}

}  // namespace

int main(int argc, char** argv) {
    const auto rows = static_cast<std::uint32_t>(argc > 1 ? std::atoi(argv[1]) : 316);
    const certify::Shape ball{{0, radius, 0, radius, radius}, {radius, radius, radius, height, 0}};
    const certify::Shape mill{{radius, 0, radius, height, 0}};
    const std::vector<Vec3> tips = zigzag(50'000);
    for (const double raised : {0.0, 0.02}) {
        const mesh::Distance part(part_of(rows, raised));
        const certify::Judge judge(part, tolerance);
        std::printf("part of %zu triangles, raised by %.2f mm\n", part.mesh().triangles.size(), raised);
        run("ball R3", judge, ball, tips);
        std::vector<Vec3> away = tips;
        for (Vec3& p : away) p.z += 20;
        run("ball R3, 20 mm above", judge, ball, away);
    }
    const mesh::Distance part(part_of(rows, -1.2));
    run("end mill D6, 1.2 above", certify::Judge(part, tolerance), mill, tips);
}
