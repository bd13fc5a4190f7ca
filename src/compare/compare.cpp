#include "compare/compare.hpp"

#include <algorithm>

#include "compare/walk.hpp"

namespace obrys::compare {

namespace {

constexpr std::array<std::string_view, aspect_count> names{"motion",       "feed",  "spindle",    "coolant",   "tool",
                                                           "events",       "datum", "frame",      "tolerance", "cycles",
                                                           "compensation", "parts", "preparation"};

/// Moves, or what stands between them, with which one stream may run ahead of the other before that one is asked.
constexpr std::size_t most_ahead = 256;

}  // namespace

std::string_view name_of(Aspect a) { return names[static_cast<std::size_t>(a)]; }

const Difference* Result::of(Aspect a) const {
    const auto found = std::find_if(first.begin(), first.end(), [&](const Difference& d) { return d.aspect == a; });
    return found == first.end() ? nullptr : &*found;
}

bool Result::is_equal(Aspect a) const { return of(a) == nullptr && !(looked_to && holds(a)); }

Comparison::Comparison(const Tolerance& t)
    : own_{Path(t.length, t.is_axis_by_axis, t.joins_freely), Path(t.length, t.is_axis_by_axis, t.joins_freely)} {
    walk_ = std::make_unique<Walk>(*own_[0], *own_[1], t);
}

Comparison::Comparison(const Path& a, const Path& b, const Tolerance& t) : walk_(std::make_unique<Walk>(a, b, t)) {}

Comparison::~Comparison() = default;

void Comparison::take(Side side, const cl::Record& record) { own_[static_cast<std::size_t>(side)]->take(record); }

void Comparison::end(Side side) { walk_->sides[static_cast<std::size_t>(side)].end(); }

bool Comparison::is_ahead(Side side) const {
    const auto n = static_cast<std::size_t>(side);
    const auto has_many = [&](const ItemPairs& pairs) { return pairs.waiting(n) > most_ahead; };
    return walk_->sides[n].waiting() > most_ahead || std::any_of(walk_->items.begin(), walk_->items.end(), has_many);
}

Comparison::Side Comparison::waits_for() const {
    const auto& [a, b] = walk_->sides;
    if (a.ended() != b.ended()) return a.ended() ? Side::b : Side::a;
    if (a.has_piece() != b.has_piece()) return a.has_piece() ? Side::b : Side::a;
    const auto items = [&](std::size_t side) {
        std::size_t n = 0;
        for (const ItemPairs& pairs : walk_->items) n += pairs.waiting(side);
        return n;
    };
    return items(1) < items(0) ? Side::b : Side::a;
}

void Comparison::advance() {
    walk_->advance();
    for (const std::size_t side : {0U, 1U})
        if (own_[side])
            own_[side]->forget(walk_->sides[side].number(),
                               {walk_->items[0].done(side), walk_->items[1].done(side), walk_->items[2].done(side),
                                walk_->items[3].done(side), walk_->items[4].done(side)});
}

Result Comparison::finish() { return walk_->finish(); }

Result compare(const Path& a, const Path& b, const Tolerance& tolerance) {
    return Comparison(a, b, tolerance).finish();
}

}  // namespace obrys::compare
