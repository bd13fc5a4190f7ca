#include "compare_output.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number.hpp"

namespace obrys::cli {

namespace {

using Json = nlohmann::ordered_json;
using Verdict = driver::StockComparison::Verdict;

std::string place(const driver::Session& session, const std::optional<base::Span>& at) {
    if (!at || at->file >= session.sources.size()) return {};
    const auto p = session.sources.position(*at);
    return session.sources[at->file].name + ":" + std::to_string(p.line);
}

std::string of_aspect(const Compared& c, compare::Aspect aspect) {
    const compare::Result& r = c.moves;
    const compare::Difference* d = r.of(aspect);
    if (d == nullptr && aspect == compare::Aspect::motion) return "equal, " + std::to_string(r.moves_a) + " moves";
    if (d == nullptr && r.is_equal(aspect)) return "equal";
    if (d == nullptr) return "equal up to move " + std::to_string(*r.looked_to) + ", not compared behind it";
    const std::string at_a = place(c.a, d->in_a), at_b = place(c.b, d->in_b);
    return (d->is_done ? "differs first at move " : "said otherwise first at move ") + std::to_string(d->move) +
           (at_a.empty() ? "" : ", " + at_a) + (at_b.empty() ? "" : ", " + at_b) + ": " + d->what;
}

std::string millimetres(double v) { return base::fixed(v, 3); }

std::string words_of(const std::optional<driver::StockCut>& cut) {
    if (!cut) return "left as the stock was";
    return "by " + cut->file + ":" + std::to_string(cut->line) + ", move " + std::to_string(cut->move);
}

std::string of_stock(const driver::StockComparison& s) {
    if (s.verdict == Verdict::not_compared) return "not compared: " + s.why;
    if (s.by_moves) return "equal: the same moves with the same tools in the same stock";
    if (s.verdict == Verdict::equal) return "equal within " + millimetres(s.tolerance) + " mm";
    std::string out = "differs at " + std::to_string(s.count) + (s.count == 1 ? " place" : " places");
    for (const driver::StockPlace& p : s.places)
        out += "\n  " + std::string(p.b_is_deeper ? "B" : "A") + " is " + millimetres(p.depth) + " mm deeper at X " +
               millimetres(p.at.x) + " Y " + millimetres(p.at.y) + " Z " + millimetres(p.at.z) +
               (p.by ? ", " + words_of(p.by) : "") + (p.other ? "; the other " + words_of(p.other) : "");
    return out;
}

Json at(const driver::Session& session, const std::optional<base::Span>& at) {
    if (!at || at->file >= session.sources.size()) return nullptr;
    return {{"file", session.sources[at->file].name}, {"line", session.sources.position(*at).line}};
}

Json of_cut(const std::optional<driver::StockCut>& cut) {
    if (!cut) return nullptr;
    return {{"file", cut->file}, {"line", cut->line}, {"move", cut->move}};
}

Json json_of(const driver::StockComparison& s) {
    if (s.verdict == Verdict::not_compared) return {{"compared", false}, {"why", s.why}};
    Json out{{"compared", true},
             {"by_moves", s.by_moves},
             {"tolerance_mm", s.tolerance},
             {"count", s.count},
             {"places", Json::array()}};
    for (const driver::StockPlace& p : s.places)
        out["places"].push_back({{"depth_mm", p.depth},
                                 {"at", {p.at.x, p.at.y, p.at.z}},
                                 {"deeper", p.b_is_deeper ? "b" : "a"},
                                 {"by", of_cut(p.by)},
                                 {"other", of_cut(p.other)}});
    return out;
}

}  // namespace

bool does_the_same(const Compared& c) {
    return c.stock.verdict != Verdict::differs && std::none_of(c.moves.first.begin(), c.moves.first.end(),
                                                               [](const compare::Difference& d) { return d.is_done; });
}

std::string compared_text(const Compared& c) {
    std::string out;
    for (std::size_t i = 0; i < compare::aspect_count; ++i) {
        const auto aspect = static_cast<compare::Aspect>(i);
        out += std::string(compare::name_of(aspect)) + ": " + of_aspect(c, aspect) + "\n";
    }
    if (c.block_stops_a + c.block_stops_b > 0)
        out += "exact stop of single blocks (G9): not compared: " + std::to_string(c.block_stops_a) + " in A, " +
               std::to_string(c.block_stops_b) + " in B\n";
    out += "stock: " + of_stock(c.stock) + "\n";
    for (const std::string& taken : c.moves.assumed) out += "assumed: " + taken + "\n";
    return out;
}

std::string compared_json(const Compared& c) {
    const compare::Result& r = c.moves;
    Json out{{"does_the_same", does_the_same(c)}, {"fully_compared", c.is_full}};
    for (std::size_t i = 0; i < compare::aspect_count; ++i) {
        const auto aspect = static_cast<compare::Aspect>(i);
        Json& equal = out["equal"][std::string(compare::name_of(aspect))];
        equal = r.of(aspect) == nullptr;
        if (equal && !r.is_equal(aspect)) equal = nullptr;  // up to `compared_moves`; behind it nobody knows
    }
    Json& stock = out["equal"]["stock"];
    stock = c.stock.verdict == Verdict::equal;
    if (c.stock.verdict == Verdict::not_compared) stock = nullptr;
    out["moves"] = {{"a", r.moves_a}, {"b", r.moves_b}};
    if (!r.assumed.empty()) out["assumed"] = r.assumed;
    out["compared_moves"] = r.looked_to.value_or(r.moves_a);
    out["stock"] = json_of(c.stock);
    if (c.block_stops_a + c.block_stops_b > 0)
        out["exact_stops"] = {{"compared", false}, {"a", c.block_stops_a}, {"b", c.block_stops_b}};
    out["differences"] = Json::array();
    for (const compare::Difference& d : r.first)
        out["differences"].push_back({{"aspect", compare::name_of(d.aspect)},
                                      {"move", d.move},
                                      {"is_done", d.is_done},
                                      {"what", d.what},
                                      {"a", at(c.a, d.in_a)},
                                      {"b", at(c.b, d.in_b)}});
    out["first_difference"] = r.first.empty() ? Json(nullptr) : out["differences"].front();
    return out.dump(2) + "\n";
}

}  // namespace obrys::cli
