#include "shop/files/cutting/cost_file.hpp"

#include "base/codes.hpp"
#include "shop/files/section.hpp"

namespace obrys::shop {

namespace {

void take(Section& s, std::string_view key, Range range, double& value) {
    if (const auto v = s.number(key, range)) value = *v;
}
void take(Section& s, std::string_view key, Range range, std::optional<double>& value) {
    if (const auto v = s.number(key, range)) value = *v;
}

void complain(Section& s, std::string_view key, const std::string& text, const std::string& remedy = {}) {
    s.error(base::codes::job_value, place(s, key), text, remedy);
}

/// What [cost] and a variant may both say.
void read_figures(Section& s, CostTable& t) {
    if (auto currency = s.text("currency")) t.currency = *currency;
    take(s, "utilisation", Range::positive, t.utilisation);
    if (t.utilisation > 1) {
        complain(s, "utilisation",
                 "'utilisation' must be at most 1: the part of the paid time in which the machine works",
                 "0.95 for 95 %");
        t.utilisation = 1;
    }
    take(s, "wage", Range::not_negative, t.wage);
    take(s, "overhead", Range::not_negative, t.overhead);
    take(s, "machine", Range::not_negative, t.machine);
    take(s, "material", Range::not_negative, t.material);
    take(s, "pieces", Range::positive, t.pieces);
    take(s, "rounding", Range::positive, t.rounding);
    take(s, "batch", Range::positive, t.batch);
    take(s, "set_up", Range::not_negative, t.set_up_min);
    take(s, "load", Range::not_negative, t.load_s);
    take(s, "fixture", Range::not_negative, t.fixture);
    take(s, "programming", Range::not_negative, t.programming);
    take(s, "scrap", Range::not_negative, t.scrap);
    constexpr double all = 100;
    if (t.scrap >= all) {
        complain(s, "scrap", "'scrap' must be less than 100 %");
        t.scrap = 0;
    }
}

void check_table(Section& s, const CostTable& t) {
    if (t.set_up_min > 0 && !t.batch)
        complain(s, "set_up", "'set_up' is spent once a batch, and how many pieces a batch has is not said",
                 "batch = 50");
    if ((t.fixture > 0 || t.programming > 0) && !t.pieces)
        complain(s, t.fixture > 0 ? "fixture" : "programming", "what is spent in a year needs the pieces of a year",
                 "pieces = 1000");
}

std::vector<CostTool> read_worn(Section& s) {
    std::vector<CostTool> all;
    for (const Value* v : s.tables("tool")) {
        Section t(*v, "[[tool]]", s.diagnostics());
        if (v->kind != ValueKind::table) continue;
        CostTool tool;
        tool.name = t.text("name").value_or("tool");
        for (const std::string_view key : {"price", "life"})
            if (!t.has(key)) t.missing(key);
        take(t, "price", Range::not_negative, tool.price);
        take(t, "life", Range::positive, tool.life_min);
        take(t, "regrind", Range::not_negative, tool.regrind);
        take(t, "change", Range::not_negative, tool.change_min);
        constexpr std::int64_t most_number = 99'999'999;
        if (const auto number = t.integer("number", 0, most_number)) tool.number = static_cast<std::uint32_t>(*number);
        take(t, "cut", Range::not_negative, tool.cut_s);
        constexpr std::int64_t most = 1000;
        if (const auto lives = t.integer("lives", 1, most)) tool.lives = static_cast<double>(*lives);
        t.finish();
        if (tool.life_min > 0) all.push_back(std::move(tool));
    }
    return all;
}

CostVariant read_variant(const Value& v, const CostTable& common, base::Diagnostics& diagnostics) {
    CostVariant variant;
    variant.table = common;
    variant.where = head(v);
    Section s(v, "[[variant]]", diagnostics);
    if (v.kind != ValueKind::table) return variant;
    variant.name = s.text("name").value_or("");
    variant.time_s = s.number("time", Range::positive);
    variant.program = s.text("program").value_or("");
    read_figures(s, variant.table);
    if (s.has("tool")) variant.table.tools = read_worn(s);
    s.finish();
    check_table(s, variant.table);
    if (s.has("time") && s.has("program"))
        complain(s, "program", "a variant has a 'time' or a 'program' that takes it, not both");
    return variant;
}

}  // namespace

std::vector<CostVariant> read_costs(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    std::vector<CostVariant> all;
    const auto root = parse_toml(file, sources, diagnostics);
    if (!root) return all;
    base::Diagnostics found;
    Section s(*root, "the cost table", found);
    CostTable table;
    if (const Entry* e = s.sub_table("cost")) {
        Section c(e->value, "[cost]", found);
        read_figures(c, table);
        table.tools = read_worn(c);
        c.finish();
        check_table(c, table);
        for (const std::string_view key : {"wage", "machine"})
            if (!c.has(key)) c.missing(key);
    } else if (!s.has("cost")) {
        s.missing("cost");
    }
    for (const Value* v : s.tables("variant")) all.push_back(read_variant(*v, table, found));
    s.finish_file(diagnostics);
    if (all.empty()) all.push_back({"", {}, "", table, head(*root)});
    return all;
}

}  // namespace obrys::shop
