/// What can be wrong with the data of one FK element by itself, and the names of data.
#include <cmath>

#include "path/fk/equations.hpp"

namespace obrys::path {

std::string_view word(FkDatum d) {
    constexpr std::array<std::string_view, 23> words{"",   "",   "X",   "Y",   "PR",   "PA",   "AN",     "LEN",
                                                     "R",  "DR", "CCX", "CCY", "CCPR", "CCPA", "CCA",    "P1",
                                                     "P2", "P3", "PD",  "PAR", "DP",   "CLSD", "FSELECT"};
    return words[static_cast<std::size_t>(d)];
}

FkElement fk_conventional(const Element& e) {
    FkElement k;
    k.tag = e.tag;
    k.arc = is_arc(e);
    k.x = FkValue{e.to.x};
    k.y = FkValue{e.to.y};
    if (!k.arc) return k;
    k.ccx = FkValue{e.centre.x};
    k.ccy = FkValue{e.centre.y};
    k.sense = e.sweep > 0 ? Sense::counter_clockwise : Sense::clockwise;
    return k;
}

namespace {

/// Goes through the data and keeps the first fault.
class Inspector {
public:
    Inspector(const FkElement& e, const FkHandle& before, const FkLookup& find) : e_(e), before_(before), find_(find) {}

    void related(FkDatum d, const std::optional<FkValue>& v, bool angle, bool pole) {
        if (!v) return;
        number(d, v->value, angle);
        if (v->base == FkBase::block && (v->block == e_.tag || find_(v->block) == nullptr))
            say(d, FkReason::unknown_block);
        if (pole && !e_.pole) say(d, FkReason::incomplete);
    }
    void plain(FkDatum d, const std::optional<double>& v, double least) {
        if (!v) return;
        number(d, *v, false);
        if (std::isfinite(*v) && *v < least) say(d, FkReason::bad_value);
    }
    void point(FkDatum d, const FkPoint& p) {
        if (p.x) number(d, *p.x, false);
        if (p.y) number(d, *p.y, false);
        if (p.x.has_value() != p.y.has_value()) say(d, FkReason::incomplete);
    }
    void arcs_only(FkDatum d, bool given) {
        if (given && !e_.arc) say(d, FkReason::bad_value);
    }
    void all();
    std::optional<FkFault> fault;

private:
    void number(FkDatum d, double v, bool angle) {
        if (!std::isfinite(v))
            say(d, FkReason::not_known);
        else if (std::abs(v) > (angle ? 1e4 : fk_most_length))
            say(d, FkReason::bad_value);
    }
    void say(FkDatum d, FkReason r) {
        if (fault) return;
        fault = FkFault{};
        fault->reason = r;
        fault->tag = e_.tag;
        fault->datum = d;
    }
    void lines_and_pairs();

    const FkElement& e_;
    const FkHandle& before_;
    const FkLookup& find_;
};

void Inspector::lines_and_pairs() {
    if (e_.beside.x.has_value() != e_.distance.has_value()) say(FkDatum::pd, FkReason::incomplete);
    if (e_.parallel_distance && !e_.parallel) say(FkDatum::dp, FkReason::incomplete);
    if (e_.parallel && e_.arc) say(FkDatum::par, FkReason::bad_value);
    if (e_.parallel && (*e_.parallel == e_.tag || find_(*e_.parallel) == nullptr))
        say(FkDatum::par, FkReason::unknown_block);
    arcs_only(FkDatum::r, e_.radius.has_value());
    arcs_only(FkDatum::dr, e_.sense.has_value());
    arcs_only(FkDatum::ccx, e_.ccx.has_value());
    arcs_only(FkDatum::ccy, e_.ccy.has_value());
    arcs_only(FkDatum::ccpr, e_.ccpr.has_value());
    arcs_only(FkDatum::ccpa, e_.ccpa.has_value());
    arcs_only(FkDatum::cca, e_.cca.has_value());
    arcs_only(FkDatum::p3, e_.on[2].x.has_value());
    if (e_.cca && e_.cca->base == FkBase::block) say(FkDatum::cca, FkReason::bad_value);
    if (e_.cca && e_.cca->base == FkBase::incremental && !(e_.cca->value > 0 && e_.cca->value <= 2 * geom::pi + 1e-12))
        say(FkDatum::cca, FkReason::bad_value);
    const bool turned = e_.an && e_.an->base == FkBase::incremental;
    if ((e_.tangential || turned) && !before_.has_direction)
        say(turned ? FkDatum::an : FkDatum::tangent, FkReason::no_direction);
}

void Inspector::all() {
    constexpr double positive = 1e-4;  // mm: the control's resolution
    related(FkDatum::x, e_.x, false, false);
    related(FkDatum::y, e_.y, false, false);
    related(FkDatum::pr, e_.pr, false, true);
    related(FkDatum::pa, e_.pa, true, true);
    related(FkDatum::an, e_.an, true, false);
    related(FkDatum::ccx, e_.ccx, false, false);
    related(FkDatum::ccy, e_.ccy, false, false);
    related(FkDatum::ccpr, e_.ccpr, false, true);
    related(FkDatum::ccpa, e_.ccpa, true, true);
    related(FkDatum::cca, e_.cca, true, false);
    plain(FkDatum::len, e_.length, positive);
    plain(FkDatum::r, e_.radius, positive);
    plain(FkDatum::pd, e_.distance, 0);
    plain(FkDatum::dp, e_.parallel_distance, 0);
    point(FkDatum::p1, e_.on[0]);
    point(FkDatum::p2, e_.on[1]);
    point(FkDatum::p3, e_.on[2]);
    point(FkDatum::pd, e_.beside);
    if (e_.pole) {
        const FkPoint pole{e_.pole->x, e_.pole->y};
        const bool centre = (e_.ccpr || e_.ccpa) && !e_.pr && !e_.pa;
        if (e_.pr || e_.pa || centre) point(centre ? FkDatum::ccpr : FkDatum::pr, pole);
    }
    lines_and_pairs();
}

}  // namespace

std::optional<FkFault> fault_in(const FkElement& e, const FkHandle& before, const FkLookup& find) {
    Inspector i(e, before, find);
    i.all();
    return i.fault;
}

}  // namespace obrys::path
