#include "shapes.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace obrys::step_test {

namespace {

const double pi = std::acos(-1.0);

}  // namespace

const std::map<std::string, Shape>& shapes() {
    static const std::map<std::string, Shape> all{
        {"block", {60 * 40 * 20 - pi * 36 * 20 - (1 - pi / 4) * 25 * 20, {0, 0, -20}, {60, 40, 0}}},
        {"ball", {4.0 / 3 * pi * 1000, {-9, -8, -7}, {11, 12, 13}}},
        {"cone", {pi * 100 * 30 / 3, {-10, -10, 0}, {10, 10, 30}}},
        {"ring", {2 * pi * pi * 10 * 9, {-13, -13, -3}, {13, 13, 3}}},
        {"hollow", {8000 - 4.0 / 3 * pi * 512, {-10, -10, -10}, {10, 10, 10}}},
        {"plate", {100 * 70 * 17 + (80 * 50 - (4 - pi) * 64) * 8 - 4 * pi * 16 * 25, {0, 0, -25}, {100, 70, 0}}},
        {"soft",
         {24 * 14 * 4 + 2 * 3 * (24 * 14 + 14 * 4 + 24 * 4) + pi * 9 * (24 + 14 + 4) + 4.0 / 3 * pi * 27,
          {0, 0, 0},
          {30, 20, 10}}},
        {"apart", {2000, {0, 0, 0}, {30, 10, 10}, 2}},
        {"touching", {3000, {0, 0, 0}, {30, 10, 10}, 2}},
        {"turned", {12000, {-30, 0, 0}, {30, 30, 10}, 2}},
        {"shell", {0, {}, {}, 0}},
        {"mixed", {1000, {0, 0, 0}, {10, 10, 10}}},
    };
    return all;
}

std::string step_text(const std::string& shape, const std::string& unit) {
    const std::string command = "\"" OBRYS_STEP_SAMPLES "\" " + shape + " " + unit;
    const auto close = [](std::FILE* f) { pclose(f); };
    const std::unique_ptr<std::FILE, decltype(close)> from(popen(command.c_str(), "r"), close);
    if (!from) throw std::runtime_error("cannot run " + command);
    std::string text;
    std::array<char, 4096> buffer{};
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), from.get())) text.append(buffer.data(), n);
    if (text.empty()) throw std::runtime_error("no STEP file from " + command);
    return text;
}

}  // namespace obrys::step_test
