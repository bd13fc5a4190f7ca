#include <cmath>

#include "base/number.hpp"
#include "report/report.hpp"

namespace obrys::report {

namespace {

std::string_view colour_of(base::Severity s) {
    switch (s) {
        case base::Severity::error: return "\x1b[1;31m";
        case base::Severity::warning: return "\x1b[1;33m";
        case base::Severity::note: return "\x1b[1;36m";
    }
    return "";
}

std::string_view colour_of(check::Verdict v) {
    switch (v) {
        case check::Verdict::clean: return "\x1b[1;32m";
        case check::Verdict::findings: return "\x1b[1;31m";
        case check::Verdict::not_fully_checked: return "\x1b[1;33m";
    }
    return "";
}

std::string coordinate(const char* name, double value) {
    return std::isfinite(value) ? std::string(" ") + name + base::fixed(value, 3) : std::string(" ") + name + "?";
}

std::string way(const check::Finding& f, bool lathe) {
    const auto point = [lathe](geom::Vec3 p) {
        return coordinate("X", p.x) + (lathe ? "" : coordinate("Y", p.y)) + coordinate("Z", p.z);
    };
    std::string out = "  move " + std::to_string(*f.move);
    if (f.from && f.to) out += ": from" + point(*f.from) + " to" + point(*f.to) + (lathe ? " mm (X radius)" : " mm");
    return out + "\n";
}

/// The figures that the message does not carry.
std::string amounts(const check::Finding& f) {
    std::string out;
    for (const check::Amount& a : f.amounts) {
        if (a.key != "volume_mm3" && a.key != "contact_length_mm") continue;
        const AmountWords w = amount_words(a.key);
        out += (out.empty() ? "  " : ", ") + w.label + " " + base::fixed(a.value, 3) + " " + w.unit;
    }
    return out.empty() ? out : out + "\n";
}

void paint(std::string& text, std::string_view word, std::string_view colour) {
    const std::size_t at = text.find(word);
    if (at == std::string::npos || at > text.find('\n')) return;
    text.insert(at + word.size(), "\x1b[0m");
    text.insert(at, colour);
}

/// What one move of a group did, in a line.
std::string member(const check::Finding& f, const Subject& s) {
    const Place p = place(s.sources, f.where);
    std::string out = "  ";
    if (!p.file.empty()) out += p.file + ":" + std::to_string(p.line) + ":" + std::to_string(p.column) + ": ";
    if (f.move) out += "move " + std::to_string(*f.move) + ": ";
    out += f.text;
    if (f.more > 0) out += ", and " + std::to_string(f.more) + " more that are not listed";
    return out + "\n";
}

/// The worst of them speaks for all.
std::string finding(const check::Group& group, const Subject& s, const TextOptions& options) {
    const check::Finding& f = s.result.findings[group.worst];
    const base::Diagnostic d{
        f.severity, f.code, f.where, f.text, f.remedy, f.stack, check::related_of(s.result, group)};
    std::string out = base::render(d, s.sources);
    if (options.colours) paint(out, std::string(base::name(f.severity)) + ":", colour_of(f.severity));
    if (group.members.size() > 1 || f.more > 0) out += "  " + passes_line(s, group) + "\n";
    if (group.known) out += "  known: the baseline has it\n";
    if (f.move) out += way(f, s.setup.machine.kind == shop::MachineKind::lathe);
    out += amounts(f);
    if (options.all && group.members.size() > 1)
        for (const std::size_t i : group.members) out += member(s.result.findings[i], s);
    return out;
}

std::string notes(const std::string& heading, const std::vector<check::Note>& list, const Subject& s) {
    std::string out = list.empty() ? "" : "\n" + heading + ":\n";
    for (const check::Note& n : list) {
        const Place p = place(s.sources, n.where);
        out += "  ";
        if (!p.file.empty()) out += p.file + ":" + std::to_string(p.line) + ":" + std::to_string(p.column) + ": ";
        out += n.text;
        if (n.times > 1) out += " (" + std::to_string(n.times) + " times)";
        out += " [" + std::string(n.code) + "]\n";
        if (!p.text.empty() && p.text.size() <= 160) out += "    " + p.text + "\n";
        if (!n.remedy.empty()) out += "    remedy: " + n.remedy + "\n";
        const base::ShownStack stack = base::shown(n.stack);
        const auto call = [&](const base::Span& site) {
            const Place from = place(s.sources, site);
            out += "    called from " + from.file + ":" + std::to_string(from.line) + ": " + from.text + "\n";
        };
        for (const base::Span& site : stack.inner) call(site);
        if (stack.left_out > 0) out += "    … " + std::to_string(stack.left_out) + " more calls\n";
        for (const base::Span& site : stack.outer) call(site);
    }
    return out;
}

/// Figures of a simulated milling, each with how it was obtained.
std::string milled(const check::Result& r) {
    const check::MillingFigures& m = r.milled->figures;
    std::string out = "stock: " + base::fixed(m.before_mm3 / 1000, 3) + " cm3 before, " +
                      base::fixed(m.after_mm3 / 1000, 3) + " cm3 after; removed " +
                      base::fixed(m.before_mm3 - m.after_mm3, 1) + " mm3 over " + base::fixed(m.contact_length_mm, 1) +
                      " mm of feed\nsimulated to " + base::shortest(m.tolerance_mm) + " mm on rays " +
                      base::fixed(m.step.x, 3) + " x " + base::fixed(m.step.y, 3) + " x " + base::fixed(m.step.z, 3) +
                      " mm apart, " + base::fixed(m.memory_mb, 0) + " MB\n";
    if (m.refined_cells > 0)
        out += "surface made finer in " + count_of(m.refined_cells, "cell") + ", down to " +
               base::fixed(m.finest_mm, 4) + " mm wide\n";
    for (const check::ToolUse& t : r.tools)
        if (t.volume_mm3 > 0)
            out += "  tool " + (t.name.empty() ? "T" + std::to_string(t.number) : "\"" + t.name + "\"") + ": " +
                   base::fixed(t.volume_mm3, 1) + " mm3\n";
    return out;
}

std::string figures(const check::Result& r) {
    const check::Stats& t = r.stats;
    std::string out = "\n" + count_of(t.moves, "move") + ": " + std::to_string(t.rapid_moves) + " rapid (" +
                      base::fixed(t.rapid_length_mm, 3) + " mm), " + std::to_string(t.feed_moves) + " feed (" +
                      base::fixed(t.feed_length_mm, 3) + " mm); " + count_of(t.blocks_executed, "block") +
                      " executed\n";
    if (r.before && r.after)
        out += "stock: " + base::fixed(r.before->volume_mm3 / 1000, 3) + " cm3 before, " +
               base::fixed(r.after->volume_mm3 / 1000, 3) + " cm3 after; section " +
               base::fixed(r.before->area_mm2, 3) + " mm2 before, " + base::fixed(r.after->area_mm2, 3) +
               " mm2 after (exact)\n";
    return out + (r.milled == nullptr ? std::string() : milled(r));
}

}  // namespace

std::string to_text(const Subject& s, const TextOptions& options) {
    const check::Result& r = s.result;
    const std::string verdict = verdict_line(r);
    std::string out;
    if (!s.program.empty()) out += s.program + ": ";
    out += options.colours ? std::string(colour_of(r.verdict)) + verdict + "\x1b[0m" : verdict;
    out += "\n";
    for (const check::Group& g : check::groups_of(r)) out += "\n" + finding(g, s, options);
    if (r.findings_dropped > 0) out += "\n" + count_of(r.findings_dropped, "further finding") + " not shown\n";
    out += notes("not checked", r.unchecked, s);
    if (options.quiet) return out;
    out += notes("assumed", r.assumptions, s);
    if (options.listed) out += notes("without effect", r.listed, s);
    return out + figures(r);
}

}  // namespace obrys::report
