// Cost of milling simulation: zig-zag finishing with a ball of radius 3 mm at a tolerance of 0.01 mm, by the formula of
// ../shared/bench/gen_rs274.py (with random numbers of our own); or the G0 and G1 moves of a program named as argument.
// Prints a table; the time per move should stay flat. usage: bench_milling [PROGRAM.ngc [RUNS [THREADS]]]

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "sim/milling/cut/simulation.hpp"

namespace {

using obrys::geom::Vec3;
namespace milling = obrys::sim::milling;

constexpr double tolerance = 0.01, ball = 3;  // mm

double surface(double x, double y) {
    return -4 + 2 * std::sin(x * 0.12) * std::cos(y * 0.09) + 0.7 * std::sin(x * 0.41 + y * 0.23);
}

double to_micrometre(double v) { return std::round(v * 1000) / 1000; }

std::vector<Vec3> zigzag(std::size_t moves, double length, double step, double row) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> between(0.5, 1.5);
    std::vector<Vec3> tips{{0, 0, 2}};
    double x = 0, y = 0, sign = 1;
    const auto go = [&] { tips.push_back({to_micrometre(x), to_micrometre(y), to_micrometre(surface(x, y))}); };
    for (go(); tips.size() <= moves; go()) {
        x += sign * step * between(random);
        if (x >= 0 && x <= length) continue;
        x = std::clamp(x, 0.0, length);
        go();
        y += row;
        sign = -sign;
    }
    return tips;
}

std::vector<Vec3> read_moves(const char* name) {
    std::ifstream file(name);
    std::vector<Vec3> tips{{0, 0, 20}};
    for (std::string line; std::getline(file, line);) {
        Vec3 p = tips.back();
        bool moves = false;
        for (const char letter : {'X', 'Y', 'Z'}) {
            const std::size_t at = line.find(letter);
            if (at == std::string::npos) continue;
            (letter == 'X' ? p.x : letter == 'Y' ? p.y : p.z) = std::strtod(line.c_str() + at + 1, nullptr);
            moves = true;
        }
        if (moves) tips.push_back(p);
    }
    return tips;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

milling::Cutter cutter_of(milling::CutterKind kind, double corner = 0) {
    milling::Cutter cutter;
    cutter.kind = kind;
    cutter.diameter = 2 * ball;
    cutter.corner_radius = corner;
    cutter.cutting_length = 25;
    return cutter;
}

void run(const std::vector<Vec3>& tips, const milling::Box3& box, int runs, int threads,
         const milling::Cutter& cutter = cutter_of(milling::CutterKind::ball), Vec3 axis = {0, 0, 1}) {
    const auto lattice = milling::make_lattice(box, milling::step_for(tolerance, ball));
    double best = 1e9, removed = 0;
    std::size_t bytes = 0;
    for (int i = 0; i < runs; ++i) {
        const auto start = std::chrono::steady_clock::now();
        milling::Simulation simulation(box, *lattice, tolerance, threads);
        const std::uint32_t tool = simulation.add_tool(milling::shape_of(cutter).shape);
        for (std::size_t n = 1; n < tips.size(); ++n)
            simulation.add({obrys::geom::Straight{tips[n - 1], tips[n]}, axis, tool});
        simulation.flush();
        best = std::min(best, seconds_since(start));
        removed = 0;
        for (std::size_t k = 0; k < simulation.engagements().size(); ++k) removed += simulation.engagements()[k].volume;
        bytes = simulation.bytes();
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto& n = lattice->count;
    std::printf("%8zu moves %8.3f s %7.2f us/move  step %.4f mm, %dx%dx%d nodes, %zu MB held, %ld MB peak, %.1f mm3\n",
                tips.size() - 1, best, 1e6 * best / static_cast<double>(tips.size() - 1), lattice->step.x, n[0], n[1],
                n[2], bytes >> 20, usage.ru_maxrss >> 10, removed);
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 2 ? std::atoi(argv[2]) : 3, threads = argc > 3 ? std::atoi(argv[3]) : 0;
    const milling::Box3 plate{{0, 0, -10}, {100, 100, 0}};
    if (argc > 1) {
        const std::vector<Vec3> tips = read_moves(argv[1]);
        double right = 0;
        for (const Vec3& p : tips) right = std::max(right, p.x);
        run(tips, {{0, 0, -10}, {std::max(100.0, right), 100, 0}}, runs, threads);
        return 0;
    }
    run(zigzag(10'000, 100, 0.4, 0.5), plate, runs, threads);
    run(zigzag(50'000, 100, 0.4, 0.5), plate, runs, threads);
    run(zigzag(100'000, 100, 0.4, 0.25), plate, runs, threads);
    std::puts("end mill; bull nose of corner radius 1 mm; ball leaning by 30 degrees; bull nose leaning likewise");
    const Vec3 leaning{0.3, 0.4, std::sqrt(0.75)};
    run(zigzag(10'000, 100, 0.4, 0.5), plate, 1, threads, cutter_of(milling::CutterKind::end_mill));
    run(zigzag(10'000, 100, 0.4, 0.5), plate, 1, threads, cutter_of(milling::CutterKind::bull_nose, 1));
    run(zigzag(10'000, 100, 0.4, 0.5), plate, 1, threads, cutter_of(milling::CutterKind::ball), leaning);
    run(zigzag(2'000, 100, 0.4, 0.5), plate, 1, threads, cutter_of(milling::CutterKind::bull_nose, 1), leaning);
    std::puts("ball");
    run(zigzag(1'000'000, 150, 0.3, 0.05), {{0, 0, -10}, {150, 100, 0}}, 1, threads);
}
