#include "triangles.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace exact {

std::vector<Triangle> read_stl(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string data((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    constexpr std::size_t head = 84, each = 50;
    std::uint32_t count = 0;
    if (data.size() >= head) std::memcpy(&count, data.data() + 80, 4);
    if (data.size() < head || data.size() != head + each * count) throw std::runtime_error("no binary STL: " + path);
    std::vector<Triangle> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 9> f{};
        std::memcpy(f.data(), data.data() + head + each * i + 12, sizeof f);
        for (std::size_t k = 0; k < 3; ++k) out[i][k] = {f[3 * k], f[3 * k + 1], f[3 * k + 2]};
    }
    return out;
}

V nearest_on(const Triangle& t, V p) {
    const V n = cross(t[1] - t[0], t[2] - t[0]);
    const double size = dot(n, n);
    bool within = size > 0;
    V best = t[0];
    double least = 1e300;
    for (std::size_t i = 0; i < 3; ++i) {
        const V a = t[i], e = t[(i + 1) % 3] - a;
        if (dot(cross(e, p - a), n) < 0) within = false;
        const double ee = dot(e, e);
        const V q = a + (ee > 0 ? std::clamp(dot(p - a, e) / ee, 0.0, 1.0) : 0.0) * e;
        if (const double d = norm(p - q); d < least) least = d, best = q;
    }
    return within ? p - (dot(p - t[0], n) / size) * n : best;
}

Triangles::Triangles(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    if (!triangles_.empty()) divide(0, static_cast<std::uint32_t>(triangles_.size()));
}

void Triangles::divide(std::uint32_t first, std::uint32_t count) {
    const std::size_t own = nodes_.size();
    nodes_.emplace_back();
    Box box;
    for (std::uint32_t i = first; i < first + count; ++i)
        for (const V& p : triangles_[i]) box.add(p);
    nodes_[own].box = box;
    if (count <= 4) {
        nodes_[own].first = first, nodes_[own].count = count;
        return;
    }
    const V s = box.hi - box.lo;
    const int k = s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
    const auto middle = [&](const Triangle& t) { return t[0][k] + t[1][k] + t[2][k]; };
    const std::uint32_t half = count / 2;
    std::nth_element(triangles_.begin() + first, triangles_.begin() + first + half, triangles_.begin() + first + count,
                     [&](const Triangle& a, const Triangle& b) { return middle(a) < middle(b); });
    divide(first, half);
    nodes_[own].first = static_cast<std::uint32_t>(nodes_.size());
    divide(first + half, count - half);
}

double Triangles::distance(V p, double most) const {
    if (nodes_.empty()) return most;
    std::array<std::pair<double, std::uint32_t>, 96> stack;
    std::size_t size = 0;
    stack[size++] = {nodes_[0].box.distance(p), 0};
    while (size > 0) {
        const auto [d, i] = stack[--size];
        if (d >= most) continue;
        const Node& n = nodes_[i];
        for (std::uint32_t t = n.first; n.count > 0 && t < n.first + n.count; ++t)
            most = std::min(most, norm(p - nearest_on(triangles_[t], p)));
        if (n.count > 0) continue;
        std::pair a{nodes_[i + 1].box.distance(p), i + 1}, b{nodes_[n.first].box.distance(p), n.first};
        if (a.first < b.first) std::swap(a, b);
        stack[size++] = a, stack[size++] = b;
    }
    return most;
}

}  // namespace exact
