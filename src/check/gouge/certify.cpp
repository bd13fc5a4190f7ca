#include "check/gouge/certify.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "check/certify_shapes.hpp"
#include "check/gouge/places.hpp"
#include "check/gouge/stock_lack.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr double chord_share = 0.02;  ///< of what is allowed: chords that stand for arcs of a form tool or a bar
constexpr std::size_t moves_looked_at = 400;  ///< moves whose depth is found to the end, and the deepest of each place
constexpr double proved = 1.1;  ///< of what is allowed: what is no deeper and was measured as less is clear
/// A depth of the rays is looked for again if it is so much more than what was found: of that, and of what is allowed.
constexpr double again_deeper_by = 0.1, again_deeper_more = 0.5;
constexpr std::size_t most_again = 12;  ///< moves of one place that are searched again

/// Length of a way as it is seen along a direction.
double way_beside(const geom::PathElement& path, Vec3 direction) {
    constexpr int chords = 16;
    double way = 0;
    for (int i = 0; i < chords; ++i) {
        const Vec3 step = geom::point_at(path, double(i + 1) / chords) - geom::point_at(path, double(i) / chords);
        way += geom::length(step - dot(step, direction) * direction);
    }
    return way;
}

}  // namespace

Certificate::Certificate(const MillingSetup& setup, double allowed)
    : threads_(setup.threads),
      allowed_(allowed),
      part_(setup.part),
      before_(before_of(setup.stock, chord_share * allowed)),
      judge_(*part_, allowed, before_) {}

void Certificate::add_tool(const milling::ToolShape& tool) {
    shapes_.push_back(certified_shape(tool.cutting, chord_share * allowed_));
}

void Certificate::add(std::uint32_t move, const geom::PathElement& path, Vec3 axis, std::uint32_t tool) {
    if (tool < shapes_.size()) queued_.push_back({move, tool, path, axis});
}

void Certificate::carry_out() {
    enum : char { clear, beside, suspect };
    std::vector<char> kind(queued_.size());
    for_all(queued_.size(), threads_, [&](std::size_t i) {
        const certify::Move move = move_of(queued_[i]);
        if (judge_.is_clear(move))
            kind[i] = clear;
        else
            kind[i] = judge_.is_clear(move, certify::Judge::Of::part_in_stock) ? beside : suspect;
    });
    for (std::size_t i = 0; i < queued_.size(); ++i) {
        if (kind[i] == beside) beside_.insert(queued_[i].move);
        if (kind[i] != suspect) continue;
        of_move_[queued_[i].move].push_back(suspects_.size());
        suspects_.push_back({std::move(queued_[i])});
    }
    queued_.clear();
}

/// Of a move that was measured as no deeper than allowed.
bool Certificate::is_proved(const Suspect& s) const {
    const certify::Move move = move_of(s.queued);
    if (judge_.is_clear(move, proved * allowed_, certify::Judge::Of::part_in_stock)) return true;
    return s.depth && (judge_.is_thin(move, s.depth->normal) || judge_.is_no_deeper(move, s.depth->normal));
}

/// To the end; the deeper of what was known and what is found stays.
void Certificate::search(Suspect& s, std::optional<Vec3> from) const {
    if (stopped()) return;
    const certify::Move move = move_of(s.queued);
    const std::optional<certify::Depth> found = judge_.deepest(move, from);
    if (found && !(s.depth && s.depth->depth > found->depth)) s.depth = found;
    s.searched = true;
    if (s.depth && s.depth->depth > allowed_)
        s.state = State::found;
    else if (s.state == State::open && is_proved(s))
        s.state = State::clear;
}

/// Of very many moves that are too deep only the deepest are looked at to the end, and those of which a short search
/// has not shown that they are.
void Certificate::measure(const ThreadBands& threads, const std::function<bool()>& stop) {
    stop_ = stop;
    if (!threads.empty())
        judge_.judge_by({[&threads](Vec3 p, double deviation) { return threads.judged(p, deviation); },
                         [&threads](const certify::Judge::Triangle& t) { return threads.deeper(t); }});
    if (suspects_.size() > moves_looked_at)
        for_all(suspects_.size(), threads_, [&](std::size_t i) {
            Suspect& s = suspects_[i];
            if (stopped()) return;
            s.depth = judge_.rough(move_of(s.queued));
            if (s.depth && s.depth->depth > allowed_) s.state = State::found;
        });
    const auto deep = [&](std::size_t i) { return suspects_[i].depth ? suspects_[i].depth->depth : 0; };
    std::vector<std::size_t> order(suspects_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return deep(a) > deep(b); });
    for_all(
        order.size(), threads_,
        [&](std::size_t i) {
            Suspect& s = suspects_[order[i]];
            if (i < moves_looked_at || s.state != State::found) search(s, {});
        },
        1);
}

std::vector<Certificate::Found> Certificate::found() const {
    std::vector<Found> all;
    for (const Suspect& s : suspects_)
        if (s.state == State::found)
            all.push_back({s.queued.move, *s.depth, way_beside(s.queued.path, s.depth->normal)});
    return all;
}

bool Certificate::may_be(const mesh::Place& rays) const {
    bool moved = false;
    for (const mesh::TagShare& s : rays.shares) {
        moved = moved || s.tag > 0;
        const auto at = s.tag > 0 ? of_move_.find(s.tag - 1) : of_move_.end();
        if (at == of_move_.end()) continue;
        if (std::any_of(at->second.begin(), at->second.end(),
                        [&](std::size_t i) { return suspects_[i].state != State::clear; }))
            return true;
    }
    return !moved;
}

bool Certificate::is_none(const mesh::Place& rays) const {
    const auto by_a_move = [&](const mesh::TagShare& s) { return s.tag > 0 && !beside_.contains(s.tag - 1); };
    return rays.tag > 0 && std::all_of(rays.shares.begin(), rays.shares.end(), by_a_move) && !may_be(rays);
}

/// Of the moves that have a share in a place: those of its worst point first.
std::vector<Certificate::Suspect*> Certificate::suspects_in(const mesh::Place& rays) {
    std::vector<Suspect*> all;
    const auto add = [&](std::uint32_t tag) {
        const auto at = tag > 0 ? of_move_.find(tag - 1) : of_move_.end();
        if (at == of_move_.end()) return;
        for (const std::size_t i : at->second)
            if (std::find(all.begin(), all.end(), &suspects_[i]) == all.end()) all.push_back(&suspects_[i]);
    };
    add(rays.tag);
    for (const mesh::TagShare& s : rays.peak) add(s.tag);
    for (const mesh::TagShare& s : rays.shares) add(s.tag);
    return all;
}

/// Where the rays saw more of a place than was found of its moves, these are searched again, from there.
void Certificate::settle(const mesh::Place& rays) {
    const std::vector<Suspect*> all = suspects_in(rays);
    const double claimed = -rays.deviation;
    const auto reached = [&] {
        return std::any_of(all.begin(), all.end(), [&](const Suspect* s) {
            return s->state == State::found &&
                   s->depth->depth * (1 + again_deeper_by) + again_deeper_more * allowed_ >= claimed;
        });
    };
    std::size_t again = 0;
    for (Suspect* s : all) {
        if (again == most_again || reached()) return;
        if (s->state == State::clear) continue;
        search(*s, rays.at);
        ++again;
    }
}

/// A place of the rays that no move is known to have made. Nothing where all its moves are proved to be clear.
std::optional<Gouge> Certificate::unclaimed(const mesh::Place& rays) {
    const auto all = suspects_in(rays);
    const auto open = std::find_if(all.begin(), all.end(), [](const Suspect* s) { return s->state == State::open; });
    if (open != all.end()) {
        open_.push_back({(*open)->queued.move, rays.at});
        return {};
    }
    const bool beside = std::any_of(rays.shares.begin(), rays.shares.end(),
                                    [&](const mesh::TagShare& s) { return s.tag > 0 && beside_.contains(s.tag - 1); });
    const bool lacks = rays.tag == 0 || (beside && before_.depth(rays.at) < -rays.deviation);
    if (!lacks) return {};
    Gouge g{rays};
    g.lacks = true;
    g.place.shares.clear();
    g.place.peak.clear();
    return g;
}

/// What the stock lacks of the part, if that is not among the gouges: a cut that takes a little hides it.
void Certificate::add_lack(std::vector<Gouge>& gouges) const {
    const std::optional<StockLack> lack = lack_of(*part_, before_, allowed_);
    if (!lack) return;
    const bool said = std::any_of(gouges.begin(), gouges.end(), [&](const Gouge& g) {
        return g.lacks && -g.place.deviation * (1 + again_deeper_by) + allowed_ >= lack->depth;
    });
    if (said) return;
    Gouge g;
    g.place.at = lack->at;
    g.place.deviation = -lack->depth;
    g.lacks = true;
    gouges.push_back(std::move(g));
}

/// Searches the deepest move of each place to the end. False: all were.
bool Certificate::finish_worst(const std::vector<std::vector<std::uint32_t>>& groups) {
    std::vector<Suspect*> worst;
    for (const std::vector<std::uint32_t>& group : groups) {
        Suspect* deepest = nullptr;
        for (const std::uint32_t move : group)
            for (const std::size_t i : of_move_.at(move)) {
                Suspect& s = suspects_[i];
                if (s.state == State::found && (deepest == nullptr || s.depth->depth > deepest->depth->depth))
                    deepest = &s;
            }
        if (deepest != nullptr && !deepest->searched) worst.push_back(deepest);
    }
    for_all(
        worst.size(), threads_, [&](std::size_t i) { search(*worst[i], worst[i]->depth->at); }, 1);
    return !worst.empty() && !stopped();
}

std::vector<Gouge> Certificate::gouges(const std::vector<MilledMove>& moves, const std::vector<mesh::Place>& rays) {
    for (const mesh::Place& p : rays) settle(p);
    std::vector<Found> all = found();
    while (finish_worst(GougePlaces(all, rays, moves, allowed_).groups())) all = found();
    all = found();
    GougePlaces places(all, rays, moves, allowed_);
    std::vector<Gouge> out;
    for (std::size_t p = 0; p < rays.size(); ++p)
        if (!places.is_claimed(p))
            if (std::optional<Gouge> g = unclaimed(rays[p])) out.push_back(std::move(*g));
    std::vector<Gouge> taken = places.taken();
    std::move(taken.begin(), taken.end(), std::back_inserter(out));
    add_lack(out);
    if (!stopped())
        for (const Suspect& s : suspects_)
            if (s.state == State::open)
                open_.push_back({s.queued.move, s.depth ? s.depth->at : geom::point_at(s.queued.path, 0.5)});
    sort_gouges(out);
    return out;
}

}  // namespace obrys::check
