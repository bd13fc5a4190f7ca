#include "make/made.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "cl/text.hpp"

namespace obrys::make {

namespace {

/// Seconds of a straight move under constant cutting speed: a revolution takes as long as the radius is, and no less
/// than at the speed limit. `r`: radius at both ends.
double straight_seconds(double length, double r0, double r1, double feed, const Cutting& c) {
    const double least = c.speed * 1000 / (geom::full_turn * c.speed_limit);  // radius below which the limit holds
    double from = std::abs(r0), to = std::abs(r1);
    if (from > to) std::swap(from, to);
    double mean = 0;
    if (to <= least) {
        mean = least;
    } else if (from >= least) {
        mean = (from + to) / 2;
    } else {
        const double part = (least - from) / (to - from);
        mean = part * least + (1 - part) * (least + to) / 2;
    }
    return length / feed * mean * geom::full_turn / (c.speed * 1000) * 60;
}

double seconds_of(const groove::Move& m, Vec2 from, const Order& order) {
    const Placing& p = order.placing;
    const double feed = order.cutting.feed * m.feed;
    if (m.kind == groove::Move::Kind::dwell) return m.seconds;
    if (m.kind == groove::Move::Kind::feed)
        return straight_seconds(geom::distance(from, m.to), p.on_machine(from).y, p.on_machine(m.to).y, feed,
                                order.cutting);
    constexpr int parts = 64;
    const Vec2 r = from - m.centre;
    double seconds = 0;
    Vec2 before = from;
    for (int i = 1; i <= parts; ++i) {
        const double a = m.sweep * i / parts, c = std::cos(a), s = std::sin(a);
        const Vec2 next = m.centre + Vec2{c * r.x - s * r.y, s * r.x + c * r.y};
        seconds += straight_seconds(geom::length(r) * std::abs(m.sweep) / parts, p.on_machine(before).y,
                                    p.on_machine(next).y, feed, order.cutting);
        before = next;
    }
    return seconds;
}

void add_times(Made& made, const Order& order) {
    Vec2 at;
    bool placed = false;
    for (const groove::Move& m : made.path.moves) {
        if (m.kind == groove::Move::Kind::rapid)
            made.rapid_time += placed ? geom::distance(at, m.to) / order.cutting.rapid * 60 : 0;
        else
            made.feed_time += seconds_of(m, at, order);
        at = m.to;
        placed = true;
    }
}

std::string profile_of(const std::vector<groove::Piece>& pieces, const Placing& placing, bool downward) {
    std::string text;
    const auto point = [&](Vec2 uv, const groove::Piece* arc) {
        const Vec2 zx = placing.on_machine(uv);
        text += "  {z = " + base::shortest(zx.x) + ", x = " + base::shortest(zx.y);
        if (arc != nullptr && arc->sweep != 0) {
            const bool left = (arc->sweep > 0) == downward;
            const bool counter = left != placing.mirrors();
            text += ", r = " + base::shortest(geom::distance(arc->from, arc->centre)) + ", direction = \"" +
                    (counter ? "ccw" : "cw") + "\"";
        }
        text += "},\n";
    };
    if (downward) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (i == 0) point(pieces[i].from, nullptr);
            point(pieces[i].to, &pieces[i]);
        }
    } else {
        for (std::size_t i = pieces.size(); i-- > 0;) {
            if (i + 1 == pieces.size()) point(pieces[i].to, nullptr);
            point(pieces[i].from, &pieces[i]);
        }
    }
    return text;
}

/// Surface, contour and surface again, in the order of the machine's z.
std::string contour_profile(const groove::Contour& c, const Placing& placing, double begin, double end) {
    const auto point = [&](double u) {
        const Vec2 zx = placing.on_machine({u, c.surface(u)});
        return "  {z = " + base::shortest(zx.x) + ", x = " + base::shortest(zx.y) + "},\n";
    };
    const auto& left = c.wall(groove::Side::left).pieces;
    const auto& right = c.wall(groove::Side::right).pieces;
    if (!placing.turned)
        return point(begin) + profile_of(left, placing, true) + profile_of(right, placing, false) + point(end);
    return point(end) + profile_of(right, placing, true) + profile_of(left, placing, false) + point(begin);
}

}  // namespace

Made make_groove(const Order& order, groove::Strategy strategy) {
    Made made;
    made.strategy = strategy;
    made.request = request_for(order, strategy);
    auto contours = groove::contours_of(made.request.shape, made.request.insert.width);
    if (auto* refusal = std::get_if<groove::Refusal>(&contours)) {
        made.refusal = std::move(*refusal);
        return made;
    }
    made.contours = std::get<groove::Contours>(std::move(contours));
    auto path = groove::path_of(made.request, *made.contours, strategy);
    if (auto* refusal = std::get_if<groove::Refusal>(&path)) {
        made.refusal = std::move(*refusal);
        return made;
    }
    made.path = std::get<groove::Path>(std::move(path));
    made.proof = prove(made.request, *made.contours, strategy, made.path.moves);
    add_times(made, order);
    return made;
}

bool is_safe(const Made& made) {
    return !made.refusal && made.proof.gouge <= no_depth && made.proof.rapid_in_stock <= no_depth;
}

std::string_view verdict_of(const Made& made) {
    if (made.refusal) return "refused";
    return is_safe(made) && made.proof.rest <= made.proof.rest_bound + rest_accuracy ? "clean" : "findings";
}

int exit_code_of(const Made& made) { return verdict_of(made) == "clean" ? 0 : 1; }

std::vector<cl::Record> stream_of(const Order& order, const Made& made) {
    std::vector<cl::Record> records;
    const auto add = [&](cl::Step step) { records.push_back({std::move(step), {}, 0}); };
    const auto point = [&](Vec2 uv) {
        const Vec2 zx = order.placing.on_machine(uv);
        return geom::Vec3{zx.y, 0, zx.x};
    };
    add(cl::ToolChange{order.tool, 1, {}});
    add(cl::Spindle{order.cutting.speed, cl::SpindleMode::surface, 1, order.cutting.speed_limit, {}});
    double feed = 0;
    for (const groove::Move& m : made.path.moves) {
        const double wanted = order.cutting.feed * m.feed;
        const bool cuts = m.kind == groove::Move::Kind::feed || m.kind == groove::Move::Kind::arc;
        if (cuts && wanted != feed) add(cl::Feed{feed = wanted, cl::FeedMode::per_rev});
        switch (m.kind) {
            case groove::Move::Kind::rapid: add(cl::Linear{point(m.to), {0, 0, 1}, true}); break;
            case groove::Move::Kind::feed: add(cl::Linear{point(m.to)}); break;
            case groove::Move::Kind::dwell: add(cl::Dwell{m.seconds}); break;
            case groove::Move::Kind::arc: {
                // about y: from z to x is counter-clockwise, as drawn
                const double sweep = order.placing.mirrors() ? -m.sweep : m.sweep;
                add(cl::Arc{point(m.to), point(m.centre), {0, 1, 0}, sweep});
                break;
            }
        }
    }
    add(cl::Spindle{});
    add(cl::Stop{cl::StopKind::end});
    return records;
}

std::optional<std::string> job_of(const Order& order, const Made& made, const std::string& program,
                                  const std::string& control) {
    if (order.placing.surface != Surface::outside || !made.contours) return std::nullopt;
    const groove::Contour& finished = made.contours->finished;
    const double beside = 4 * made.request.insert.width + 10;
    const double begin = finished.wall(groove::Side::left).top().x - beside;
    const double end = finished.wall(groove::Side::right).top().x + beside;
    const bool finish = made.strategy == groove::Strategy::finishing;
    const auto surface = [&](double u) {
        const Vec2 zx = order.placing.on_machine({u, finished.surface(u)});
        return "  {z = " + base::shortest(zx.x) + ", x = " + base::shortest(zx.y) + "},\n";
    };
    std::string text = "program = \"" + program + "\"\ncontrol = \"" + control + "\"\nmachine = \"lathe-generic\"\n\n";
    text += "[[tool]]\nnumber = " + std::to_string(order.tool) +
            "\nkind = \"groove\"\nwidth = " + base::shortest(made.request.insert.width) +
            "\ncorner_radius = " + base::shortest(made.request.insert.corner_radius) + "\nreference = \"" +
            (order.placing.turned ? "right" : "left") + "\"\n\n[stock]\nprofile = [\n";
    text += finish                 ? contour_profile(made.contours->rough, order.placing, begin, end)
            : order.placing.turned ? surface(end) + surface(begin)
                                   : surface(begin) + surface(end);
    text += "]\n\n[part]\nprofile = [\n" + contour_profile(finished, order.placing, begin, end) + "]\n";
    if (!finish)
        text +=
            "\n[allowance]\nprofile = [\n" + contour_profile(made.contours->rough, order.placing, begin, end) + "]\n";
    return text;
}

std::vector<Made> compare_strategies(const Order& order) {
    std::vector<Made> all;
    for (const groove::Named& n : groove::strategies()) {
        if (n.strategy == groove::Strategy::side_stepping_high && order.request.shape.slope == 0) continue;
        all.push_back(make_groove(order, n.strategy));
    }
    return all;
}

}  // namespace obrys::make
