#include "compare/items.hpp"

#include "compare/role.hpp"

namespace obrys::compare {

namespace {

/// Pieces of the way, or items, on which a counterpart is waited for. A record that comes later than this is no
/// counterpart; the number keeps memory flat, and is large enough that a record out of its place is still shown beside
/// the one that was meant.
constexpr std::size_t longest_wait = 1000;

/// M30 of a program in which nothing turns or flows any more: one without it ends there as well.
bool ends_quietly(const Item& item) {
    const auto* stop = std::get_if<cl::Stop>(&item.step);
    if (stop == nullptr || stop->kind != cl::StopKind::end || !item.holding) return false;
    return item.holding->spindle.direction == 0 && item.holding->coolant == cl::Coolant{};
}

/// Both programs end; what the control does then besides (it goes back to the beginning, changes pallets) is not the
/// same.
bool ends_otherwise(const Item& a, const Item& b) {
    const auto* x = std::get_if<cl::Stop>(&a.step);
    const auto* y = std::get_if<cl::Stop>(&b.step);
    return x != nullptr && y != nullptr && !(*x == *y);
}

/// What is written from a program that says its end has to say it.
bool needs_end(const Likeness& like, std::size_t side) { return like.is_written_from_a() && side == 0; }

std::string difference_of(const cl::Step& a, const cl::Step& b) {
    const auto* begin = std::get_if<cl::CompensationBegin>(&a);
    const auto* other = std::get_if<cl::CompensationBegin>(&b);
    if (begin != nullptr && other != nullptr && begin->side == other->side &&
        Likeness::are_of_unknown_offsets(*begin, *other))
        return "radius compensation by offset " + std::to_string(begin->offset) + ", in the other by offset " +
               std::to_string(other->offset) +
               ": neither radius is known, so that nobody knows whether the tool goes the same way";
    return words(a) + "; in the other " + words(b);
}

}  // namespace

void ItemPairs::place(std::size_t side, std::size_t moves, std::size_t settled, std::size_t piece) {
    Side& s = sides_[side];
    for (std::size_t i = s.next + s.at.size(); i < settled && (*s.items)[i].moves <= moves; ++i) s.at.push_back(piece);
}

void ItemPairs::drop() {
    for (Side& s : sides_) s.next = s.items->size(), s.at.clear();
}

void ItemPairs::compare(const Likeness& like, const Reached& reached, Found& found) {
    auto& [a, b] = sides_;
    while (!over_ && !a.at.empty() && !b.at.empty()) {
        compare_pair(like, found);
        for (Side& s : sides_) ++s.next, s.at.pop_front();
    }
    for (const std::size_t side : {0U, 1U})
        if (!over_ && is_lone(side, reached)) {
            const bool quiet =
                reached.ended && !needs_end(like, side) && is_quiet_end(side) && reached.at_rest[1 - side];
            if (!quiet)
                add_lone(side, found);
            else if (!like.is_written_from_a())
                add_unsaid_end(side, found);
        }
    if (over_) drop();
}

bool ItemPairs::is_lone(std::size_t side, const Reached& reached) const {
    const Side &s = sides_[side], &other = sides_[1 - side];
    if (s.at.empty() || !other.at.empty()) return false;
    const bool long_ago = reached.piece - s.at.front() > longest_wait || s.at.size() > longest_wait;
    return reached.ended || (reached.here[1 - side] && long_ago);
}

/// Nothing else stands behind it.
bool ItemPairs::is_quiet_end(std::size_t side) const {
    const Side& s = sides_[side];
    return s.at.size() == 1 && ends_quietly(s.head());
}

void ItemPairs::add_lone(std::size_t side, Found& found) {
    const Item& item = sides_[side].head();
    over_ = true;
    if (side == 0)
        found.add(aspect_, &item, static_cast<const Item*>(nullptr), item.moves,
                  words(item.step) + ", which the other does not have");
    else
        found.add(aspect_, static_cast<const Item*>(nullptr), &item, item.moves,
                  "the other has " + words(item.step) + ", too");
}

/// The machine stands still in both; what M30 does besides (the program from its beginning, reset) is said by one
/// alone.
void ItemPairs::add_unsaid_end(std::size_t side, Found& found) const {
    if (found.has(aspect_)) return;
    const Item& item = sides_[side].head();
    const Item* const none = nullptr;
    found.add(aspect_, side == 0 ? &item : none, side == 0 ? none : &item, item.moves,
              side == 0 ? "the end of the program, which the other does not say"
                        : "the other says the end of the program, this one does not");
    found.all.back().is_done = false;
}

namespace {

/// A dwell in revolutions of a spindle that is known to turn is one in seconds.
cl::Step in_seconds(const Item& item) {
    const auto* dwell = std::get_if<cl::Dwell>(&item.step);
    if (dwell == nullptr || dwell->seconds != 0 || !item.holding) return item.step;
    const double seconds = cl::seconds_of(*dwell, item.holding->spindle);
    return std::isnan(seconds) ? item.step : cl::Dwell{seconds, 0};
}

}  // namespace

void ItemPairs::compare_pair(const Likeness& like, Found& found) {
    const Item &a = sides_[0].head(), &b = sides_[1].head();
    over_ = !like.steps(a.step, b.step) && !like.steps(in_seconds(a), in_seconds(b));
    if (over_) return found.add(aspect_, &a, &b, a.moves, difference_of(a.step, b.step));
    if (a.changes_side != b.changes_side)
        found.add(aspect_, &a, &b, a.moves,
                  a.changes_side
                      ? "compensation changes its side in one block; in the other it ends before"
                      : "compensation ends before it begins anew; in the other it changes its side in one block");
    if (aspect_ == Aspect::cycles || aspect_ == Aspect::compensation) return;  // they tell places of their own
    if (aspect_ == Aspect::events) compare_state(like, found);
    if (ends_otherwise(a, b) && like.same_control() && !like.is_written_from_a() && !found.has(aspect_)) {
        found.add(aspect_, &a, &b, a.moves, difference_of(a.step, b.step));
        found.all.back().is_done = false;
    }
    over_ = sides_[0].at.front() != sides_[1].at.front();
    if (over_)
        found.add(aspect_, &a, &b, a.moves,
                  words(a.step) + " before move " + std::to_string(a.moves) + "; in the other before " +
                      std::to_string(b.moves));
}

/// Spindle and coolant while the tool stands: at dwells, stops and functions of the machine (a chuck that opens); the
/// end of a program stops both.
void ItemPairs::compare_state(const Likeness& like, Found& found) const {
    const Item &a = sides_[0].head(), &b = sides_[1].head();
    const auto* stop = std::get_if<cl::Stop>(&a.step);
    const bool waits = has_state(a.step) && (stop == nullptr || stop->kind != cl::StopKind::end);
    if (!waits || !a.holding || !b.holding) return;
    const Holding &h = *a.holding, &k = *b.holding;
    // What was written may stop for longer what the program lets run: its own control's stop does that, and says so.
    const bool rests = stop != nullptr && like.is_written_from_a() && k.spindle.direction == 0 && !k.spindle.held &&
                       k.coolant == cl::Coolant{};
    if (rests) return;
    if (!found.has(Aspect::spindle) && !like(h.spindle, k.spindle))
        found.add(Aspect::spindle, &a, &b, a.moves, words(h.spindle) + "; in the other " + words(k.spindle));
    if (!found.has(Aspect::coolant) && !like(h.coolant, k.coolant))
        found.add(Aspect::coolant, &a, &b, a.moves, words(h.coolant) + "; in the other " + words(k.coolant));
}

}  // namespace obrys::compare
