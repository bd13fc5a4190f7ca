#include "report/cutting/force.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "report/cutting/rows.hpp"

namespace obrys::report::cutting {

using check::force::Gap;
using check::force::MoveForce;
using OrderedJson = nlohmann::ordered_json;

namespace {

const check::MilledMove& move_of(const ForceSubject& s, const MoveForce& f) { return s.result.milled->moves[f.move]; }

std::string place_of(const ForceSubject& s, std::size_t move) {
    const base::Span& at = s.result.milled->moves[move].where;
    return s.sources[at.file].name + ":" + std::to_string(s.sources.position(at).line);
}

std::string line_of(const ForceSubject& s, std::size_t move) {
    const base::Span& at = s.result.milled->moves[move].where;
    return std::string(s.sources.line(at.file, s.sources.position(at).line));
}

/// The largest of some moves; NaN where none is known.
struct Most {
    double mean = NAN, peak = NAN, power = NAN, torque = NAN, deflection = NAN;
    void take(const MoveForce& f) {
        mean = std::fmax(mean, f.mean);
        peak = std::fmax(peak, f.peak);
        power = std::fmax(power, f.power);
        torque = std::fmax(torque, f.torque);
        deflection = std::fmax(deflection, f.deflection);
    }
};

Most most_of(const ForceSubject& s) {
    Most most;
    for (const MoveForce& f : s.forces.moves) most.take(f);
    return most;
}

/// Moves of a tool and a reason.
struct GapCount {
    std::uint64_t moves = 0;
    std::size_t first = 0;
};
std::map<std::pair<Gap, std::uint32_t>, GapCount> gaps_of(const ForceSubject& s) {
    std::map<std::pair<Gap, std::uint32_t>, GapCount> all;
    for (const MoveForce& f : s.forces.moves) {
        if (f.gap == Gap::none) continue;
        const std::uint32_t tool = f.gap == Gap::material ? 0 : move_of(s, f).tool;
        GapCount& g = all[{f.gap, tool}];
        if (g.moves++ == 0) g.first = f.move;
    }
    return all;
}

std::string tool_name(const ForceSubject& s, std::uint32_t tool) {
    if (tool == 0) return "";
    const check::ToolUse& use = s.result.tools[tool - 1];
    return "T" + std::to_string(use.number) + (use.name.empty() ? "" : " " + use.name);
}

std::vector<std::string> gap_texts(const ForceSubject& s) {
    std::vector<std::string> all = s.not_whole;
    for (const auto& [key, g] : gaps_of(s)) {
        if (key.first == Gap::engagement) continue;
        const std::string tool = tool_name(s, key.second);
        all.push_back(std::to_string(g.moves) + (g.moves == 1 ? " move" : " moves") +
                      (tool.empty() ? "" : " of " + tool) + ": " + std::string(check::force::text_of(key.first)) +
                      ", first " + place_of(s, g.first));
    }
    return all;
}

/// What is not known, and leaves out a part alone.
std::vector<std::string> remarks(const ForceSubject& s) {
    std::vector<std::string> all;
    for (const auto& [key, g] : gaps_of(s))
        if (key.first == Gap::engagement)
            all.push_back(std::to_string(g.moves) + (g.moves == 1 ? " move" : " moves") + " of " +
                          tool_name(s, key.second) + ": " + std::string(check::force::text_of(key.first)));
    for (std::size_t i = 0; i < s.result.tools.size(); ++i) {
        const auto& listed = s.result.tools[i].listed;
        const bool cuts = std::any_of(s.forces.moves.begin(), s.forces.moves.end(),
                                      [&](const MoveForce& f) { return move_of(s, f).tool == i + 1; });
        if (!listed || !cuts) continue;
        const shop::Tool& t = s.setup.tools[*listed];
        const std::string name = tool_name(s, static_cast<std::uint32_t>(i + 1));
        if (const std::string gap = check::force::deflection_gap(t, s.job); !gap.empty())
            all.push_back("deflection of " + name + ": its " + gap + " is not known");
        if (const auto* use = find_use(s.job, t.number); use == nullptr || !use->feed_per_tooth)
            all.push_back("whether chips are too thin or too thick for " + name + ": its feed_per_tooth is not known");
    }
    if (!s.setup.machine.spindle.power)
        all.emplace_back("whether the spindle has the power: the machine file does not say it");
    if (!s.job.spindle_torque)
        all.emplace_back("whether the spindle has the torque: spindle_torque of the job does not say it");
    return all;
}

std::uint64_t extrapolated(const ForceSubject& s) {
    return static_cast<std::uint64_t>(
        std::count_if(s.forces.moves.begin(), s.forces.moves.end(), [](const MoveForce& f) { return f.extrapolated; }));
}

constexpr std::size_t column = 12;

void put_most(std::string& out, const std::string& name, const Most& m, std::size_t width) {
    out += "  " + padded(name, width);
    for (const double v : {m.mean, m.peak, m.power, m.torque, m.deflection}) out += padded(figure(v, 3), column, true);
    out += "\n";
}

void put_head(std::string& out, const std::string& name, std::size_t width) {
    out += "  " + padded(name, width);
    for (const char* head : {"mean N", "peak N", "power W", "torque Nm", "bends mm"}) out += padded(head, column, true);
    out += "\n";
}

void put_tools(std::string& out, const ForceSubject& s) {
    constexpr std::size_t width = 24;
    std::map<std::uint32_t, Most> tools;
    for (const MoveForce& f : s.forces.moves) tools[move_of(s, f).tool].take(f);
    out += "\nlargest:\n";
    put_head(out, "", width);
    for (const auto& [tool, most] : tools) put_most(out, tool == 0 ? "no tool" : tool_name(s, tool), most, width);
    if (tools.size() > 1) put_most(out, "all", most_of(s), width);
}

void put_lines(std::string& out, const ForceSubject& s, std::size_t count) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, Most>> lines;  // its first move
    for (const MoveForce& f : s.forces.moves) {
        if (f.gap != Gap::none) continue;
        const base::Span& at = move_of(s, f).where;
        auto& line = lines.try_emplace({at.file, at.begin}, f.move, Most{}).first->second;
        line.second.take(f);
    }
    std::vector<std::pair<std::size_t, Most>> sorted;
    for (const auto& [place, line] : lines) sorted.push_back(line);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second.peak > b.second.peak; });
    if (sorted.empty() || count == 0) return;
    out += "\nlines with the largest forces:\n";
    constexpr std::size_t width = 0;
    put_head(out, "", width);
    for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i) {
        put_most(out, "", sorted[i].second, width);
        out.insert(out.size() - 1, "  " + place_of(s, sorted[i].first) + ": " + line_of(s, sorted[i].first));
    }
}

}  // namespace

bool is_whole(const ForceSubject& s) { return gap_texts(s).empty(); }

std::string as_text(const ForceSubject& s, const ForceOptions& options) {
    std::string out = s.name + " (" + s.control + ") on " + s.setup.machine.name +
                      (s.material.empty() ? "" : ", " + s.material) + "\n";
    for (const std::string& gap : gap_texts(s)) out += "not fully computed: " + gap + "\n";
    out += std::to_string(s.forces.moves.size()) + (s.forces.moves.size() == 1 ? " move cuts" : " moves cut") + "\n";
    for (const check::force::ForceFinding& f : s.findings)
        out += place_of(s, f.move) + ": warning: " + f.text +
               (f.moves > 1 ? " (" + std::to_string(f.moves) + " moves)" : "") + " [" + std::string(f.code) + "]\n";
    put_tools(out, s);
    put_lines(out, s, options.lines);
    out += "\n";
    for (const std::string& law : s.forces.laws) out += "law of force: " + law + "\n";
    if (s.forces.ratios_assumed) out += "assumed: radial force 0.6, axial force 0.2 of the tangential one\n";
    if (const std::uint64_t n = extrapolated(s); n > 0)
        out += std::to_string(n) + (n == 1 ? " move makes chips" : " moves make chips") +
               " that the law was not found for [" + std::string(base::codes::force_extrapolated) + "]\n";
    out += s.feed_is_programmed ? "feeds are the programmed ones: how fast the machine really goes is not known\n"
                                : "feeds are the mean ones of each line, as obrys time plans them\n";
    for (const std::string& remark : remarks(s)) out += "not known: " + remark + "\n";
    return out;
}

namespace {

OrderedJson most_json(const Most& m) {
    return {{"mean_N", number(m.mean)},
            {"peak_N", number(m.peak)},
            {"power_W", number(m.power)},
            {"torque_Nm", number(m.torque)},
            {"deflection_mm", number(m.deflection)}};
}

OrderedJson move_json(const ForceSubject& s, const MoveForce& f) {
    const check::MilledMove& m = move_of(s, f);
    OrderedJson out{
        {"move", m.index}, {"file", s.sources[m.where.file].name}, {"line", s.sources.position(m.where).line}};
    out["tool"] = m.tool == 0 ? OrderedJson(nullptr) : OrderedJson(s.result.tools[m.tool - 1].number);
    out["mean_N"] = number(f.mean);
    out["peak_N"] = number(f.peak);
    out["power_W"] = number(f.power);
    out["torque_Nm"] = number(f.torque);
    out["deflection_mm"] = number(f.deflection);
    out["feed_per_tooth_mm"] = number(f.feed_per_tooth);
    out["chip_largest_mm"] = number(f.chip);
    out["vc_m_min"] = number(f.cutting_speed);
    out["edge_part"] = number(f.edge_part);
    out["extrapolated"] = f.extrapolated;
    out["not_known"] = f.gap == Gap::none ? OrderedJson(nullptr) : OrderedJson(check::force::text_of(f.gap));
    return out;
}

}  // namespace

std::string as_json(const ForceSubject& s) {
    OrderedJson out{{"format", "obrys-force"}, {"version", 1}, {"program", s.name}, {"control", s.control}};
    out["machine"] = s.setup.machine.name;
    out["material"] = s.material.empty() ? OrderedJson(nullptr) : OrderedJson(s.material);
    out["laws"] = s.forces.laws;
    out["complete"] = is_whole(s);
    out["not_whole"] = gap_texts(s);
    out["not_known"] = remarks(s);
    out["feed"] = s.feed_is_programmed ? "programmed" : "planned";
    out["max"] = most_json(most_of(s));
    out["moves"] = OrderedJson::array();
    for (const MoveForce& f : s.forces.moves) out["moves"].push_back(move_json(s, f));
    out["findings"] = OrderedJson::array();
    for (const check::force::ForceFinding& f : s.findings) {
        const check::MilledMove& m = s.result.milled->moves[f.move];
        out["findings"].push_back({{"code", f.code},
                                   {"file", s.sources[m.where.file].name},
                                   {"line", s.sources.position(m.where).line},
                                   {"move", m.index},
                                   {"moves", f.moves},
                                   {"value", f.value},
                                   {"limit", f.limit},
                                   {"message", f.text}});
    }
    return out.dump(1) + "\n";
}

}  // namespace obrys::report::cutting
