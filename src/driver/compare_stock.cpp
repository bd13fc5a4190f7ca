#include "driver/compare_stock.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "driver/check_program.hpp"
#include "driver/program_blank.hpp"
#include "driver/program_tools.hpp"
#include "mesh/compare.hpp"
#include "mesh/topology.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

constexpr std::size_t most_places = 20;

/// A program that has been run on its stock.
struct Machined {
    Request request;
    Session session;
    std::optional<Checked> checked;
    std::string why_not;  ///< the result cannot be relied upon

    [[nodiscard]] bool is_turned() const { return session.job.machine.kind == shop::MachineKind::lathe; }
    [[nodiscard]] StockCut cut(const base::Span& where, std::uint64_t move) const {
        if (where.file >= session.sources.size()) return {"", 0, move};
        return {session.sources[where.file].name, session.sources.position(where).line, move};
    }
};

/// What is judged besides the stock is left out: part, allowance and clamps.
check::Setup bare_setup(Session& s) {
    MillingRequest milling;
    milling.surface = true;
    check::Setup setup = setup_of(s, milling);
    setup.part.reset(), setup.allowance.reset(), setup.turned_clamps.clear();
    if (setup.milling) setup.milling->clamps.clear(), setup.milling->part.reset();
    return setup;
}

bool open_bare(Machined& m, shop::Scope scope) {
    m.request.scope = scope;
    m.request.prints_nowhere = true;  // it has been run before
    return open(m.request, m.session);
}

void machine(Machined& m, const char* name) {
    const std::string of = std::string(" (") + name + ")";
    if (!open_bare(m, shop::Scope::collisions)) return static_cast<void>(m.why_not = "it cannot be run" + of);
    check::Setup setup = bare_setup(m.session);
    const bool has_stock = m.is_turned() ? setup.stock.has_value() : setup.milling.has_value();
    if (!has_stock) return static_cast<void>(m.why_not = "no stock is given" + of);
    m.checked = check_against(m.session, std::move(setup));
    const check::Result& r = m.checked->result;
    if (!r.unchecked.empty()) m.why_not = r.unchecked.front().text + of;
    for (const check::Finding& f : r.findings)
        if (f.code == codes::program_alarm) m.why_not = "the control would stop: " + f.text + of;
    if (!m.why_not.empty() || m.is_turned()) return;
    if (r.milled == nullptr)
        m.why_not = "nothing was simulated" + of;
    else if (!r.milled->surface.empty() && !mesh::topology(r.milled->surface).closed())
        m.why_not = "its surface is not closed" + of;
}

// --- milling: each surface against the body of the other one

/// The move behind a tag of a surface; nothing: the stock's own face.
std::optional<StockCut> cut_of(const Machined& m, std::uint32_t tag) {
    const auto& moves = m.checked->result.milled->moves;
    if (tag == 0 || tag > moves.size()) return std::nullopt;
    return m.cut(moves[tag - 1].where, moves[tag - 1].index);
}

/// Places of `of`'s surface that lie within the body of `against`, or outside of it.
void add_milled(const Machined& of, const Machined& against, const mesh::Distance& body, bool of_is_b,
                StockComparison& out) {
    mesh::CompareOptions options;
    options.gouge = options.excess = out.tolerance;
    options.places = most_places;
    const mesh::Comparison found = mesh::compare(of.checked->result.milled->surface, body, options);
    const auto add = [&](const mesh::Place& p, bool deeper) {
        const mesh::Nearest there = body.nearest(p.at);
        StockPlace place{std::abs(p.deviation), p.at, of_is_b == deeper, cut_of(of, p.tag), {}};
        place.other = cut_of(against, body.mesh().empty() ? 0 : body.mesh().tag(there.triangle));
        if (!deeper) std::swap(place.by, place.other);
        out.places.push_back(std::move(place));
    };
    for (const mesh::Place& p : found.gouges) add(p, true);
    for (const mesh::Place& p : found.excesses) add(p, false);
    out.count += found.gouge_count + found.excess_count;
}

void compare_milled(const Machined& a, const Machined& b, StockComparison& out) {
    const auto& m = *a.checked->result.milled;
    const auto& n = *b.checked->result.milled;
    // Both surfaces lie that near the true one.
    out.tolerance = m.figures.tolerance_mm + n.figures.tolerance_mm;
    if (m.surface.empty() != n.surface.empty()) {
        StockPlace all{mesh::bounds(m.surface.empty() ? n.surface : m.surface).size().z, {}, n.surface.empty(), {}, {}};
        all.at = mesh::bounds(m.surface.empty() ? n.surface : m.surface).centre();
        out.places.push_back(all), out.count = 1;
    } else if (!m.surface.empty()) {
        add_milled(b, a, mesh::Distance(m.surface), true, out);
        // What B has nothing of is seen from A's side only.
        StockComparison back;
        back.tolerance = out.tolerance;
        add_milled(a, b, mesh::Distance(n.surface), false, back);
        if (out.count == 0) out.places = std::move(back.places), out.count = back.count;
    }
}

// --- turning: sections, which are exact

/// The move that took most of what it should have left.
std::optional<StockCut> cut_into(const Request& request, const geom::Region& left, geom::Vec2 at) {
    Machined m{request, {}, {}, {}};
    if (!open_bare(m, shop::Scope::part)) return std::nullopt;
    check::Setup setup = bare_setup(m.session);
    setup.part = left;
    const Checked checked = check_against(m.session, std::move(setup));
    const check::Finding* best = nullptr;
    const auto distance = [&](const check::Finding& f) { return f.at ? geom::distance(*f.at, at) : INFINITY; };
    for (const check::Finding& f : checked.result.findings)
        if (f.code == codes::gouge && f.move && (best == nullptr || distance(f) < distance(*best))) best = &f;
    if (best == nullptr) return std::nullopt;
    return m.cut(best->where, *best->move);
}

void add_turned(const Machined& deeper, const geom::Region& left_by_it, const geom::Region& left_by_other, bool is_b,
                StockComparison& out) {
    std::vector<sim::turning::Depth> pieces = sim::turning::pieces_outside(left_by_other, left_by_it, out.tolerance);
    std::sort(pieces.begin(), pieces.end(), [](const auto& x, const auto& y) { return x.normal > y.normal; });
    out.count += pieces.size();
    if (pieces.size() > most_places) pieces.resize(most_places);
    for (const sim::turning::Depth& d : pieces)
        out.places.push_back({d.normal, {d.deepest.y, 0, d.deepest.x}, is_b, {}, {}});
    if (pieces.empty()) return;
    StockPlace& worst = out.places[out.places.size() - pieces.size()];
    worst.by = cut_into(deeper.request, left_by_other, pieces.front().deepest);
}

void compare_turned(const Machined& a, const Machined& b, StockComparison& out) {
    const geom::Region &left_a = a.checked->result.stock_after, &left_b = b.checked->result.stock_after;
    out.tolerance = std::max(a.session.job.tolerances.gouge, b.session.job.tolerances.gouge);
    add_turned(b, left_b, left_a, true, out);
    add_turned(a, left_a, left_b, false, out);
}

/// Why there is nothing that could be compared; empty: there is.
std::string nothing_to_cut(const Session& s, const char* name) {
    const std::string of = std::string(" (") + name + ")";
    if (s.main == nullptr) return "a CL stream has no stock" + of;
    if (s.job.scope == shop::Scope::motion) return "the scope is motion" + of;
    base::Diagnostics unsaid;
    const bool has_stock = s.job.stock || s.job.solid_stock || program_blank(*s.main, unsaid);
    if (!has_stock) return "no stock is given" + of;
    return s.job.tools.empty() ? "no tools are given" + of : "";
}

std::vector<shop::Tool> tools_of(const Session& s) {
    base::Diagnostics unsaid;
    std::vector<shop::Tool> tools = s.job.tools;
    for (shop::Tool& own : program_tools(*s.main, s.job.tools, unsaid)) tools.push_back(std::move(own));
    for (shop::Tool& t : tools) t.where = {};
    return tools;
}

/// The stock of milling; files of the same name in other folders are other ones.
std::optional<std::pair<shop::Solid, fs::path>> solid_of(const Session& s) {
    base::Diagnostics unsaid;
    std::optional<shop::Stock> stock = s.job.solid_stock;
    if (!stock && !s.job.stock) stock = program_blank(*s.main, unsaid);
    if (!stock) return std::nullopt;
    auto* file = std::get_if<shop::SolidFile>(&stock->solid);
    if (file != nullptr) file->where = {};
    return std::pair{stock->solid, file != nullptr ? fs::path(s.input).parent_path() : fs::path()};
}

/// What takes material away, and what it is taken from, is the same.
bool is_same_shop(const Session& a, const Session& b) {
    const shop::Machine &m = a.job.machine, &n = b.job.machine;
    const bool turned = a.job.stock.has_value() == b.job.stock.has_value() &&
                        (!a.job.stock || a.job.stock->region == b.job.stock->region);
    return m.name == n.name && m.kind == n.kind && m.chain == n.chain && turned && solid_of(a) == solid_of(b) &&
           tools_of(a) == tools_of(b);
}

bool is_same_motion(const compare::Result& moves) {
    using compare::Aspect;
    return moves.is_equal(Aspect::motion) && moves.is_equal(Aspect::tool) && moves.is_equal(Aspect::events) &&
           moves.is_equal(Aspect::datum);
}

void compare_machined(const Machined& a, const Machined& b, StockComparison& out) {
    if (a.is_turned() != b.is_turned()) return static_cast<void>(out.why = "one is turned and the other milled");
    if (a.is_turned())
        compare_turned(a, b, out);
    else
        compare_milled(a, b, out);
    std::stable_sort(out.places.begin(), out.places.end(),
                     [](const StockPlace& x, const StockPlace& y) { return x.depth > y.depth; });
    if (out.places.size() > most_places) out.places.resize(most_places);
    if (out.count > 0) return static_cast<void>(out.verdict = StockComparison::Verdict::differs);
    for (const Machined* m : {&a, &b})
        if (m->checked->result.milled != nullptr && m->checked->result.milled->thin > 0)
            out.why = "no difference was found, but walls thinner than the simulation sees are left";
    if (out.why.empty()) out.verdict = StockComparison::Verdict::equal;
}

}  // namespace

StockComparison compare_stock(const ComparedSide& a, const ComparedSide& b, const compare::Result& moves, double same_place) {
    StockComparison out;
    out.why = nothing_to_cut(a.session, "A");
    if (out.why.empty()) out.why = nothing_to_cut(b.session, "B");
    if (!out.why.empty()) return out;
    constexpr double fine = 1e-3;  // mm; below what a stock is compared within
    const bool whole = exit_code_of_run(a.session) == 0 && exit_code_of_run(b.session) == 0;
    if (whole && same_place <= fine && is_same_motion(moves) && is_same_shop(a.session, b.session)) {
        out.by_moves = true;
        out.verdict = StockComparison::Verdict::equal;
        return out;
    }
    Machined in_a{a.request, {}, {}, {}}, in_b{b.request, {}, {}, {}};
    machine(in_a, "A");
    out.why = in_a.why_not;
    if (out.why.empty()) machine(in_b, "B"), out.why = in_b.why_not;
    if (out.why.empty()) compare_machined(in_a, in_b, out);
    out.is_missed = out.verdict == StockComparison::Verdict::not_compared;
    return out;
}

}  // namespace obrys::driver
