/// Free contours: blocks are handed to the solver ahead of the run until the element of the block being run is known.

#include <cmath>
#include <map>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/whole.hpp"
#include "interp/moves/moves.hpp"
#include "path/fk/fk.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;
using program::Datum;
using program::Special;
using program::SpecialKind;
using program::StatementKind;

/// The contour at hand: what was handed to the solver, and what came back. Tags are statements.
struct FreeContour {
    FreeContour(Vec2 start, std::optional<Vec2> direction, double w) : solver(start, direction, w) {}
    path::FkContour solver;
    const Unit* unit = nullptr;
    std::uint32_t next = 0;  ///< the statement to hand over next
    std::uint32_t done = 0;  ///< the statement whose element came out last
    bool finished = false;
    std::map<std::uint64_t, path::Element> known;
    std::map<std::uint32_t, std::uint64_t> by_number;  ///< block number -> tag
    std::optional<path::FkFault> fault;
};

SolvedContour::SolvedContour(const SolvedContour& other)
    : at_hand(other.at_hand == nullptr ? nullptr : std::make_shared<FreeContour>(*other.at_hand)) {}

namespace {

const Special* special_at(const Unit& unit, std::uint32_t index) {
    const program::Statement& s = unit.statements[index];
    if (s.kind != StatementKind::special) return nullptr;
    const Special& special = unit.specials[static_cast<std::size_t>(unit.words[s.first].payload)];
    const bool free = special.kind >= SpecialKind::free_pole && special.kind <= SpecialKind::free_select;
    return free ? &special : nullptr;
}

bool is_element(SpecialKind k) { return k >= SpecialKind::free_line && k <= SpecialKind::free_arc_tangential; }

struct Field {
    Datum datum, block;
    std::optional<path::FkValue> path::FkElement::*value;
    bool angle;
};
constexpr Field fields[] = {
    {Datum::x, Datum::block_of_x, &path::FkElement::x, false},
    {Datum::y, Datum::block_of_y, &path::FkElement::y, false},
    {Datum::polar_radius, Datum::block_of_polar_radius, &path::FkElement::pr, false},
    {Datum::polar_angle, Datum::block_of_polar_angle, &path::FkElement::pa, true},
    {Datum::gradient, Datum::block_of_gradient, &path::FkElement::an, true},
    {Datum::centre_x, Datum::block_of_centre_x, &path::FkElement::ccx, false},
    {Datum::centre_y, Datum::block_of_centre_y, &path::FkElement::ccy, false},
    {Datum::centre_radius, Datum::block_of_centre_radius, &path::FkElement::ccpr, false},
    {Datum::centre_polar_angle, Datum::block_of_centre_angle, &path::FkElement::ccpa, true},
    {Datum::centre_angle, Datum::centre_angle, &path::FkElement::cca, true},
};

class Reader {
public:
    Reader(Reckoning& run, const FreeContour& contour, const Special& s)
        : run_(run), contour_(contour), s_(s), unit_(length_unit(run.modal)) {}

    path::FkElement element(std::uint64_t tag) {
        path::FkElement e;
        e.tag = tag;
        e.arc = s_.kind == SpecialKind::free_arc || s_.kind == SpecialKind::free_arc_tangential;
        e.tangential = s_.kind == SpecialKind::free_line_tangential || s_.kind == SpecialKind::free_arc_tangential;
        for (const Field& f : fields) e.*f.value = value(f);
        e.length = length(Datum::length);
        e.radius = length(Datum::radius);
        if (e.radius) e.radius = std::abs(*e.radius);
        if (const auto sense = plain(Datum::sense))
            e.sense = *sense > 0 ? path::Sense::counter_clockwise : path::Sense::clockwise;
        e.on[0] = {length(Datum::point1_x), length(Datum::point1_y)};
        e.on[1] = {length(Datum::point2_x), length(Datum::point2_y)};
        e.on[2] = {length(Datum::point3_x), length(Datum::point3_y)};
        e.beside = {length(Datum::beside_x), length(Datum::beside_y)};
        e.distance = length(Datum::beside_distance);
        if (const auto n = plain(Datum::parallel)) e.parallel = tag_of(*n);
        e.parallel_distance = length(Datum::parallel_distance);
        if (const auto c = plain(Datum::closed)) e.closed = *c > 0 ? path::FkClosed::begins : path::FkClosed::ends;
        e.pole = run_.free_pole;
        return e;
    }

private:
    std::optional<double> plain(Datum d) {
        if (!has_datum(s_, d)) return std::nullopt;
        return datum_of(run_, s_, d);
    }
    std::optional<double> length(Datum d) {
        const auto v = plain(d);
        return v ? std::optional(*v * unit_) : std::nullopt;
    }
    /// A block nobody handed over gets a tag that the solver does not know.
    std::uint64_t tag_of(double number) const {
        const auto whole = base::whole<std::uint32_t>(number);
        const auto found = whole ? contour_.by_number.find(*whole) : contour_.by_number.end();
        return found == contour_.by_number.end() ? ~std::uint64_t{0} : found->second;
    }
    std::optional<path::FkValue> value(const Field& f) {
        for (const program::DatumValue& d : s_.data) {
            if (d.datum != f.datum) continue;
            path::FkValue v;
            const double n = number(run_, d.value);
            v.value = f.angle ? geom::radians(n) : n * unit_;
            if (d.incremental) v.base = path::FkBase::incremental;
            if (f.block != f.datum && has_datum(s_, f.block)) {
                v.base = path::FkBase::block;
                v.block = tag_of(datum_of(run_, s_, f.block));
            }
            return v;
        }
        return std::nullopt;
    }

    Reckoning& run_;
    const FreeContour& contour_;
    const Special& s_;
    double unit_;
};

void set_pole(Reckoning& run, const Special& s) {
    const double unit = length_unit(run.modal);
    Vec2 pole = run.free_pole.value_or(Vec2{});
    if (has_datum(s, Datum::x)) pole.x = datum_of(run, s, Datum::x) * unit;
    if (has_datum(s, Datum::y)) pole.y = datum_of(run, s, Datum::y) * unit;
    run.free_pole = pole;
}

void take(FreeContour& c, path::FkResult r) {
    for (path::Element& e : r.elements) c.known.emplace(e.tag, std::move(e));
    if (r.fault && !c.fault) c.fault = std::move(r.fault);
}

/// Hands the next statement over; false where the contour ends.
bool hand_over(Moving& run, FreeContour& c) {
    if (c.next >= c.unit->statements.size()) return false;
    const program::Statement& statement = c.unit->statements[c.next];
    const Special* s = special_at(*c.unit, c.next);
    // The block of a chamfer or rounding has no words: its own belong to the element before it.
    const bool empty = statement.kind == StatementKind::block && statement.first == c.unit->words_end(c.next);
    if (s == nullptr && !empty) return false;
    const std::uint64_t tag = c.next++;
    if (s == nullptr) return true;
    if (s->kind == SpecialKind::free_pole) set_pole(run, *s);
    if (s->kind == SpecialKind::free_select) {
        const double n = datum_of(run, *s, Datum::number);
        take(c, c.solver.select(base::whole<std::size_t>(n, 1, 1000).value_or(0)));
    }
    if (!is_element(s->kind)) return true;
    if (s->block_number != 0) c.by_number[s->block_number] = tag;
    take(c, c.solver.push(Reader(run, c, *s).element(tag)));
    return true;
}

std::string missing_text(const path::FkFault& f) {
    std::string list;
    for (const path::FkDatum d : f.missing) list += (list.empty() ? "" : ", ") + std::string(path::word(d));
    return list.empty() ? "the free contour is not determined here: more data are missing"
                        : "the free contour is not determined here: one of these is missing: " + list;
}

std::string fault_text(const path::FkFault& f) {
    const std::string word(path::word(f.datum));
    switch (f.reason) {
        case path::FkReason::bad_value: return word + " has a value that this element cannot have";
        case path::FkReason::incomplete: return word + " stands without what belongs to it";
        case path::FkReason::unknown_block: return word + " refers to a block that is no element of this contour";
        case path::FkReason::no_direction: return "a tangential element needs a contour element before it";
        case path::FkReason::contradictory:
            return (word.empty() ? std::string("this free contour element") : word) +
                   (std::isfinite(f.miss) ? " contradicts what the other data say, by " + base::fixed(f.miss, 3) + " mm"
                                          : " contradicts what the other data say");
        case path::FkReason::ambiguous:
            return "the data allow " + std::to_string(f.solutions) + " contours from here: FSELECT is missing";
        case path::FkReason::no_such_solution:
            return "FSELECT names a solution that does not exist: there are " + std::to_string(f.solutions);
        case path::FkReason::too_many_pending: return "more than 16 free contour elements wait for data";
        case path::FkReason::too_many_solutions: return "the data of this free contour allow too many contours";
        default: return missing_text(f);
    }
}

void complain(Saying& run, const FreeContour& c) {
    const path::FkFault& f = *c.fault;
    const auto at = static_cast<std::uint32_t>(f.tag);
    const base::Span where = at < c.unit->statements.size() ? c.unit->span(c.unit->statements[at]) : run.here();
    if (f.reason == path::FkReason::not_known)
        unchecked(run, codes::unknown_value, where, "this free contour depends on a value that is not known");
    else
        alarm(run, codes::contour, where, fault_text(f));
}

FreeContour& contour_at(Moving& run, std::uint32_t index) {
    const FreeContour* at_hand = run.free_contour.at_hand.get();
    const bool goes_on =
        at_hand != nullptr && at_hand->unit == &run.unit() && index > at_hand->done && index <= at_hand->next;
    if (goes_on) return *run.free_contour.at_hand;
    const PlaneAxes a = plane_axes(run.modal.plane);
    const geom::Vec3& p = run.programmed_position;
    std::optional<Vec2> direction;
    if (const Vec2 last = run.last_direction.get(); geom::length(last) > 0) direction = last;
    run.free_contour.at_hand =
        std::make_shared<FreeContour>(Vec2{coordinate(p, a.u), coordinate(p, a.v)}, direction, coordinate(p, a.w));
    run.free_contour.at_hand->unit = &run.unit();
    run.free_contour.at_hand->next = index;
    run.free_contour.at_hand->done = index == 0 ? 0 : index - 1;
    return *run.free_contour.at_hand;
}

}  // namespace

void free_contour(Moving& run, const Special& s, std::uint32_t index) {
    if (s.kind == SpecialKind::free_pole) return set_pole(run, s);
    if (s.kind == SpecialKind::free_select) return;
    FreeContour& c = contour_at(run, index);
    while (!c.known.contains(index) && !c.fault && !c.finished && !run.stopped)
        if (!hand_over(run, c)) {
            take(c, c.solver.finish());
            c.finished = true;
        }
    const auto found = c.known.find(index);
    if (found == c.known.end()) {
        if (c.fault) complain(run, c);
        run.programmed_position = run.position = {NAN, NAN, NAN};
        run.free_contour = {};
        return;
    }
    path::Element e = found->second;
    c.known.erase(found);
    c.done = index;
    const PlaneAxes a = plane_axes(run.modal.plane);
    geom::Vec3 to = run.programmed_position;
    coordinate(to, a.u) = e.to.x;
    coordinate(to, a.v) = e.to.y;
    const std::shared_ptr<FreeContour> keep = run.free_contour.at_hand;
    begin_motion(run);
    if (!run.block.rapid) require_feed(run);
    plane_element(run, std::move(e), to, false);
    run.free_contour.at_hand = keep;
}

}  // namespace obrys::interp
