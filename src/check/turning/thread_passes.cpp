#include "check/turning/thread_passes.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/turning/rest.hpp"
#include "check/words.hpp"
#include "geom/boolean.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::check {

namespace {

constexpr std::size_t most_pieces = 4000;  ///< of a tool: programs cut threads in tens of passes
constexpr double least_common = 1e-3;      ///< mm2 that bands of one thread share
constexpr double same_lead = 1e-3;         ///< as a part: a lead in inch, rounded
constexpr double same_place = 0.02;        ///< mm, of rounded starts and of allowances between finishing passes
constexpr double tangent_30 = 0.57735026918962576;  ///< between a flank and what is across the axis
constexpr double parallel = 0.09;                   ///< of slopes: five degrees

/// Revolutions on `way` mm, where the first is `lead` long and each further one by `change` more.
double revolutions(double way, double lead, double change) {
    if (change == 0) return way / lead;
    return (std::sqrt(std::max(0.0, lead * lead + 2 * change * way)) - lead) / change;
}

/// Inserts for threads have 60 degrees and less between their flanks; of buttress threads one leans by 45 (DIN 2781) or
/// 30 (DIN 513), and passes may come in along it. Wider inserts are made for turning.
double widest_tangent(const shop::Tool& tool, bool on_face) {
    constexpr double widest_tip = 60, square = 90;
    if (on_face || !(tool.tip_angle <= widest_tip)) return tangent_30;
    const double lean =
        std::max(std::abs(square - tool.entering_angle), std::abs(tool.entering_angle + tool.tip_angle - square));
    return lean < square - 1 ? std::max(tangent_30, std::tan(geom::radians(lean))) : tangent_30;
}

double whole_turns_off(double turns) { return turns - std::round(turns); }

std::string sense(int spindle) { return spindle > 0 ? "clockwise (M3)" : "counter-clockwise (M4)"; }

Finding crossed(std::string text, std::string remedy) {
    Finding f;
    f.code = base::codes::thread_crossed;
    f.text = std::move(text);
    f.remedy = std::move(remedy);
    return f;
}

}  // namespace

double ThreadPasses::Piece::turns_at(double at) const {
    const double way = std::abs(at - begin);
    return turns + ((at > begin) == (end > begin) ? 1 : -1) * revolutions(way, lead, change);
}

void ThreadPasses::follow(const Move& move) {
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    const bool goes_on = joins_ && thread != nullptr;
    joins_ = thread != nullptr;
    if (thread == nullptr) return;
    const double length = geom::distance(move.from, move.to);
    begins_ = goes_on ? ends_ : thread->start / 360;
    ends_ = begins_ + revolutions(length, std::abs(thread->pitch), thread->change);
}

void ThreadPasses::cut(const Move& move, const geom::Region& band, const shop::Tool& tool) {
    const auto& thread = std::get<cl::Thread>(move.record.step);
    const double dz = move.to.z - move.from.z, dx = move.to.x - move.from.x, length = std::hypot(dz, dx);
    const bool known = std::isfinite(length) && std::isfinite(begins_) && std::isfinite(thread.pitch);
    if (thread.rigid_tap || !known || length == 0 || thread.pitch == 0) return;
    Piece p{move.record, move.index, std::abs(dx) > std::abs(dz)};
    const double along = p.on_face ? dx : dz, across = p.on_face ? dz : dx;
    p.begin = p.on_face ? move.from.x : move.from.z;
    p.end = p.begin + along;
    p.height = p.on_face ? move.from.z : move.from.x;
    p.rise = across / along;
    p.turns = begins_;
    p.lead = std::abs(thread.pitch * along / length);
    p.change = thread.change * std::abs(along / length);
    p.spindle = state_.spindle.direction;
    const auto shares = [&](const Thread& t) {
        const auto same_way = [&](const Piece& q) {
            return q.on_face == p.on_face && std::abs(q.rise - p.rise) < parallel && common(q, p);
        };
        return std::any_of(t.pieces.begin(), t.pieces.end(), same_way) && box_of(t.band).meets(box_of(band), 0) &&
               geom::area(geom::intersect(t.band, band)) > least_common;
    };
    const auto found = std::find_if(threads_.begin(), threads_.end(), shares);
    if (found == threads_.end()) {
        constexpr double narrow = 0.25;  // of the lead: no nose of a thread is rounder
        if (threads_.size() >= most_pieces) return;
        threads_.push_back({band,
                            widest_tangent(tool, p.on_face),
                            tool.kind == shop::ToolKind::turning && tool.nose_radius < narrow * p.lead,
                            {}});
        threads_.back().pieces.push_back(std::move(p));
        return;
    }
    const auto first = std::find_if(found->pieces.begin(), found->pieces.end(), [&](const Piece& q) {
        return q.on_face == p.on_face && std::abs(q.rise - p.rise) < parallel && common(q, p);
    });
    if (differs(*first, p) || found->pieces.size() >= most_pieces) return;
    if (geom::area(band) > geom::area(found->band)) found->band = band;
    found->pieces.push_back(std::move(p));
}

std::optional<double> ThreadPasses::common(const Piece& a, const Piece& b) {
    const double from = std::max(std::min(a.begin, a.end), std::min(b.begin, b.end));
    const double to = std::min(std::max(a.begin, a.end), std::max(b.begin, b.end));
    if (to - from < std::min(a.lead, b.lead)) return std::nullopt;
    return (from + to) / 2;
}

/// Another lead or another sense: said at once.
bool ThreadPasses::differs(const Piece& first, const Piece& p) {
    const bool variable = first.change != 0 || p.change != 0;
    // A variable lead goes with the place: one that begins elsewhere has another there.
    const bool moved = variable && std::abs(first.begin - p.begin) > same_place;
    const bool lead = !moved && std::abs(first.lead - p.lead) > same_lead * first.lead;
    const bool change = std::abs(first.change - p.change) > same_lead * first.lead;
    const bool turned = first.spindle != 0 && p.spindle != 0 && first.hand() != p.hand();
    if (!lead && !change && !turned) return false;
    Finding f;
    if (lead || change) {
        f = crossed(lead ? "the pass has a lead of " + mm(p.lead) + ", and a pass before it on this thread one of " +
                               mm(first.lead) + ": the thread is destroyed"
                         : "the lead changes by " + mm(p.change) +
                               " a revolution, and in a pass before it on this "
                               "thread by " +
                               mm(first.change) + ": the thread is destroyed",
                    "program the same lead in all passes of a thread");
        f.amounts = {{"lead_mm", p.lead}, {"lead_before_mm", first.lead}};
    } else if (first.spindle != p.spindle) {
        f = crossed("the spindle turns " + sense(p.spindle) + ", and in a pass before it on this thread " +
                        sense(first.spindle) + ": a thread of the other hand crosses it",
                    "turn the spindle the same way in all passes of a thread");
    } else {
        f = crossed(
            "the pass leads the other way than one before it on this thread while the spindle turns as before: "
            "a thread of the other hand crosses it",
            "cut all passes of a thread the same way");
    }
    f.related.push_back({first.record.from, "pass before it"});
    f.move = p.index;
    out_.finding(p.record, std::move(f));
    return true;
}

/// How far the groove of `a` lies beside that of `b`, mm along the axis, at most half a lead.
double ThreadPasses::beside(const Piece& a, const Piece& b, double at) {
    return whole_turns_off(a.turns_at(at) - b.turns_at(at)) * b.lead;
}

void ThreadPasses::judge() {
    for (const Thread& t : threads_) judge(t);
    threads_.clear();
}

/// The deepest passes make the grooves. The others lie between their flanks, else they cut what must stay; several
/// grooves are starts, a whole part of the lead from each other.
void ThreadPasses::judge(const Thread& thread) {
    if (!thread.pointed || thread.pieces.size() < 2) return;
    const auto variable = [](const Piece& p) { return p.change != 0; };
    if (std::any_of(thread.pieces.begin(), thread.pieces.end(), variable)) return;
    const Piece& last = thread.pieces.back();
    const auto of_last = [&](const Piece& p) -> std::optional<double> {
        const bool same_way = (p.end > p.begin) == (last.end > last.begin) && p.spindle == last.spindle;
        return same_way && std::abs(p.rise - last.rise) < parallel ? common(p, last) : std::nullopt;
    };
    // Depth against the last pass; it lies on the side to which the first of them lies above it.
    const auto above = [&](const Piece& p, double at) { return p.height_at(at) - last.height_at(at); };
    const double side = [&] {
        for (const Piece& p : thread.pieces)
            if (const auto at = of_last(p); at && std::abs(above(p, *at)) > same_place) return above(p, *at);
        return 1.0;
    }();
    const double out = side < 0 ? -1 : 1;
    struct Placed {
        const Piece* piece;
        double height, beside;
    };
    std::vector<Placed> all;
    double lowest = INFINITY;
    for (const Piece& p : thread.pieces)
        if (const auto at = of_last(p)) {
            all.push_back({&p, out * above(p, *at), beside(p, last, *at)});
            lowest = std::min(lowest, all.back().height);
        }
    std::vector<Placed> grooves;
    const auto off = [&](const Placed& a, const Placed& b) {
        return whole_turns_off((a.beside - b.beside) / last.lead) * last.lead;
    };
    for (const Placed& p : all)
        if (p.height <= lowest + same_place && std::none_of(grooves.begin(), grooves.end(), [&](const Placed& g) {
                return std::abs(off(p, g)) <= same_place;
            }))
            grooves.push_back(p);
    const double starts = static_cast<double>(grooves.size());
    for (const Placed& g : grooves) {
        const double turns = off(g, grooves.front()) / last.lead * starts;
        if (std::abs(whole_turns_off(turns)) * last.lead / starts > same_place)
            return say_crossed(*g.piece, *grooves.front().piece, off(g, grooves.front()));
    }
    for (const Placed& p : all) {
        const auto nearest = std::min_element(grooves.begin(), grooves.end(), [&](const Placed& a, const Placed& b) {
            return std::abs(off(p, a)) < std::abs(off(p, b));
        });
        const double shift = off(p, *nearest);
        if (std::abs(shift) > (p.height - lowest) * thread.tangent + same_place)
            return say_crossed(*p.piece, *nearest->piece, shift);
    }
}

void ThreadPasses::say_crossed(const Piece& piece, const Piece& other, double shift) {
    Finding f = crossed("the pass lies " + mm(std::abs(shift)) +
                            " along the axis beside the groove of the thread, whose "
                            "lead is " +
                            mm(other.lead) + ": it cuts away what must stay of it",
                        "begin all passes of a thread at one place, or whole leads from it; of several starts cut each "
                        "one to full depth");
    f.amounts = {{"shift_mm", std::abs(shift)}, {"lead_mm", other.lead}};
    f.related.push_back({other.record.from, "pass in the groove"});
    f.move = piece.index;
    out_.finding(piece.record, std::move(f));
}

}  // namespace obrys::check
