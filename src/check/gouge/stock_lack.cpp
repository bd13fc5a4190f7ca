#include "check/gouge/stock_lack.hpp"

#include <algorithm>
#include <array>
#include <queue>

namespace obrys::check {

using geom::Vec3;

namespace {

constexpr std::size_t most_looked_at = 20'000;
constexpr double farther_out = 1.1;  ///< of what is known: what is farther out is looked for

/// A piece of the part's surface: nothing of it stands out farther than `most`.
struct PartPiece {
    std::array<Vec3, 3> corners;
    double most = 0;
    bool operator<(const PartPiece& other) const { return most < other.most; }
};

class LackSearch {
public:
    LackSearch(const sim::certify::Before& stock, double allowed) : stock_(stock), allowed_(allowed) {}
    void look(Vec3 p) {
        if (const double out = -stock_.depth(p); out > best_.depth) best_ = {out, p};
    }
    /// The distance grows by no more than the way.
    void add(const std::array<Vec3, 3>& c) {
        const Vec3 centre = (1.0 / 3) * (c[0] + c[1] + c[2]);
        look(centre);
        double reach = 0;
        for (const Vec3& p : c) reach = std::max(reach, geom::distance(p, centre));
        const PartPiece piece{c, reach - stock_.depth(centre)};
        if (piece.most > wanted()) queue_.push(piece);
    }
    void divide() {
        for (std::size_t i = 0; i < most_looked_at && !queue_.empty() && queue_.top().most > wanted(); ++i) {
            const std::array<Vec3, 3> c = queue_.top().corners;
            queue_.pop();
            const Vec3 a = 0.5 * (c[0] + c[1]), b = 0.5 * (c[1] + c[2]), d = 0.5 * (c[2] + c[0]);
            for (const auto& part : {std::array{c[0], a, d}, {a, c[1], b}, {d, b, c[2]}, {a, b, d}}) add(part);
        }
    }
    [[nodiscard]] const StockLack& best() const { return best_; }

private:
    [[nodiscard]] double wanted() const { return std::max(allowed_, farther_out * best_.depth); }

    const sim::certify::Before& stock_;
    double allowed_ = 0;
    StockLack best_{0, {}};
    std::priority_queue<PartPiece> queue_;
};

}  // namespace

std::optional<StockLack> lack_of(const mesh::Distance& part, const sim::certify::Before& stock, double allowed) {
    if (!stock.depth) return {};
    const mesh::Mesh& m = part.mesh();
    LackSearch lack(stock, allowed);
    for (const Vec3& p : m.vertices) lack.look(p);
    if (!stock.convex) {
        for (std::uint32_t t = 0; t < m.triangles.size(); ++t) lack.add(corners(m, t));
        lack.divide();
    }
    if (!(lack.best().depth > allowed)) return {};
    return lack.best();
}

}  // namespace obrys::check
