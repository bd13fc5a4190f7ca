#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "cl/text.hpp"
#include "cl/text_words.hpp"
#include "cl/unknown_tool.hpp"

namespace obrys::cl {

namespace {

Linear linear(Words& w, bool rapid) {
    Linear s;
    s.rapid = rapid;
    s.to = w.vec();
    if (w.accept("axis")) s.axis = w.vec();
    return s;
}

/// Behind `centre`, of an Arc or a programmed one.
template <class Circle>
void circle(Words& w, Circle& s) {
    s.centre = w.vec();
    w.expect("normal");
    s.normal = w.vec();
    w.expect("sweep");
    s.sweep = w.number();
}

Arc arc(Words& w) {
    Arc s;
    s.to = w.vec();
    w.expect("centre");
    circle(w, s);
    s.rapid = w.accept("rapid");
    return s;
}

std::array<char, 8> axis_name(Words& w) {
    std::array<char, 8> out{};
    const std::string name = w.quoted();
    if (name.size() > out.size()) w.fail("an axis name has at most 8 characters");
    for (std::size_t i = 0; i < name.size() && i < out.size(); ++i) out[i] = name[i];
    return out;
}

Spline spline(Words& w) {
    Spline s;
    s.to = w.vec();
    w.expect("k3");
    s.k3 = w.vec();
    w.expect("k2");
    s.k2 = w.vec();
    w.expect("k1");
    s.k1 = w.vec();
    if (w.accept("axis")) s.axis = w.vec();
    while (w.ok() && w.peek().starts_with('"')) {
        SplineAxis a;
        a.name = axis_name(w);
        for (double* v : {&a.to, &a.k3, &a.k2, &a.k1}) *v = w.number();
        a.rotary = w.choice<2>({"mm", "deg"}) == 1;
        s.axes.push_back(a);
    }
    return s;
}

Tolerance tolerance(Words& w) {
    Tolerance s;
    s.contour = w.number();
    w.expect("rotary");
    s.rotary = w.number();
    s.filter = static_cast<Filter>(w.choice<5>({"none", "finishing", "semi-finishing", "roughing", "precision"}));
    return s;
}

PathMode path_mode(Words& w) {
    PathMode s;
    s.kind = static_cast<PathKind>(w.choice(path_kinds));
    if (w.accept("tolerance")) s.tolerance = w.number();
    if (w.accept("merge")) s.merge = w.number();
    if (w.accept("way")) s.way = w.integer<std::uint16_t>();
    return s;
}

Setting setting(Words& w) {
    Setting s;
    const double kind = w.number(), n = w.number(), second = w.number();
    const auto kind_number = base::whole<int>(kind, 0, static_cast<int>(SettingKind::pallet_change));
    const auto first = base::whole<std::int32_t>(n), other = base::whole<std::int32_t>(second);
    if (kind_number && first && other) {
        s.kind = static_cast<SettingKind>(*kind_number);
        s.number = *first;
        s.second = *other;
    } else {
        w.fail("there is no such setting");
    }
    for (double& v : s.values) v = w.number();
    return s;
}

Axis axis(Words& w) {
    Axis s;
    s.name = axis_name(w);
    s.to = w.number();
    s.rotary = w.choice<2>({"mm", "deg"}) == 1;
    s.counted = w.accept("counted");
    return s;
}

Thread thread(Words& w) {
    Thread s;
    s.to = w.vec();
    w.expect("pitch");
    s.pitch = w.number();
    s.rigid_tap = w.accept("tap");
    return s;
}

Feed feed(Words& w) {
    Feed s;
    s.value = w.number();
    s.mode = static_cast<FeedMode>(w.choice<3>({"mm/min", "mm/rev", "1/min"}));
    return s;
}

Spindle spindle(Words& w) {
    Spindle s;
    s.speed = w.number();
    s.mode = static_cast<SpindleMode>(w.choice<2>({"1/min", "m/min"}));
    constexpr std::array<std::int8_t, 3> directions{0, 1, -1};
    s.direction = directions[w.choice<3>({"stop", "cw", "ccw"})];
    w.expect("limit");
    s.limit = w.number();
    if (w.accept("held")) s.held = w.number();
    return s;
}

Coolant coolant(Words& w) {
    Coolant s;
    if (w.accept("off")) return s;
    s.flood = w.accept("flood");
    s.mist = w.accept("mist");
    if (!s.flood && !s.mist) w.choice<3>({"off", "flood", "mist"});
    return s;
}

ToolChange tool(Words& w) {
    ToolChange s;
    s.number = w.accept("?") ? unknown_tool : w.integer<std::uint32_t>();
    w.expect("edge");
    s.edge = w.accept("?") ? unknown_tool : w.integer<std::uint32_t>();
    s.name = w.quoted();
    if (w.accept("raised")) s.raised = w.number();
    if (w.accept("wider")) s.wider = w.number();
    s.standing = w.accept("standing");
    s.with_length = w.accept("lengthened");
    if (w.accept("offset")) s.offset = w.integer<std::uint32_t>();
    return s;
}

ToolData tool_data(Words& w) {
    ToolData s;
    s.number = w.integer<std::uint32_t>();
    w.expect("edge");
    s.edge = w.integer<std::uint32_t>();
    if (w.accept("length")) s.length = w.number();
    if (w.accept("radius")) s.radius = w.number();
    return s;
}

DatumData datum_data(Words& w) {
    DatumData s;
    s.number = w.integer<std::uint32_t>();
    s.origin = w.vec();
    if (w.accept("turned")) s.turn = w.number();
    s.added = w.accept("added");
    return s;
}

LeadBegin lead(Words& w) {
    LeadBegin s;
    s.onto = w.choice<2>({"onto", "off"}) == 0;
    s.kind = static_cast<LeadKind>(w.choice(lead_kinds));
    w.expect("at");
    s.at = w.vec();
    if (w.accept("length")) s.length = w.number();
    if (w.accept("radius")) s.radius = w.number();
    if (w.accept("angle")) s.angle = w.number();
    if (w.accept("feed")) s.feed = w.number();
    s.rapid = w.accept("rapid");
    return s;
}

ToolLength tool_length(Words& w) {
    ToolLength s;
    constexpr std::array<std::int8_t, 3> senses{0, 1, -1};
    s.sense = senses[w.choice<3>({"off", "added", "subtracted"})];
    if (s.sense == 0) return s;
    w.expect("offset");
    s.offset = w.integer<std::uint32_t>();
    if (w.accept("by")) s.by = w.vec();
    return s;
}

MachinePlace machine_place(Words& w) {
    MachinePlace s;
    s.kind = static_cast<PlaceKind>(w.choice(place_kinds));
    if (w.ok() && !w.peek().empty() && w.peek().front() >= '0' && w.peek().front() <= '9')
        s.number = w.integer<std::uint8_t>();
    if ((s.axes[0] = w.accept("x"))) s.to.x = w.number();
    if ((s.axes[1] = w.accept("y"))) s.to.y = w.number();
    if ((s.axes[2] = w.accept("z"))) s.to.z = w.number();
    return s;
}

Datum datum(Words& w) {
    Datum s;
    s.number = w.integer<std::uint32_t>();
    s.origin = w.vec();
    return s;
}

geom::Frame affine(Words& w) {
    geom::Frame f;
    f.origin = w.vec();
    if (w.accept("by"))
        for (double& v : f.linear) v = w.number();
    return f;
}

Frame frame(Words& w) {
    Frame s;
    while (w.ok() && !w.peek().empty() && w.peek().front() >= 'a') {
        FramePart p;
        p.kind = static_cast<FrameKind>(w.choice(frame_kinds));
        p.frame = affine(w);
        s.parts.push_back(p);
    }
    return s;
}

Auxiliary auxiliary(Words& w) {
    Auxiliary s;
    const std::string letter = w.quoted();
    if (letter.size() != 1) w.fail("expected one letter");
    if (!letter.empty()) s.letter = letter[0];
    s.number = w.integer<std::int64_t>();
    return s;
}

template <class Enum>
Enum spelt(Words& w, std::optional<Enum> (*find)(std::string_view), const char* what) {
    const auto found = w.ok() ? find(w.word()) : std::nullopt;
    if (!found) w.fail(std::string("there is no such ") + what);
    return found.value_or(Enum{});
}

/// Behind `plane`: how it is called, the values by role, and what the source has written.
void cycle_words(Words& w, CycleBegin& s, Cycle& cycle) {
    s.call = w.accept("modal") ? CycleCall::modal : w.accept("pattern") ? CycleCall::pattern : CycleCall::single;
    if (w.accept("pass")) {
        s.pass = w.integer<std::uint64_t>();
        w.expect("of");
        s.passes = w.integer<std::uint64_t>();
    }
    while (w.ok() && !w.peek().empty() && w.peek().front() >= 'a' && w.peek() != "written") {
        const CycleRole role = spelt(w, &cycle_role_spelt, "value of a cycle");
        cycle.values.push_back({role, w.number()});
    }
    if (!w.accept("written")) return;
    while (w.ok() && w.peek().starts_with('"')) {
        CycleParameter p;
        p.name = w.quoted();
        p.value = w.number();
        cycle.written.push_back(std::move(p));
    }
}

CycleBegin cycle(Words& w) {
    CycleBegin s;
    Cycle cycle;
    cycle.kind = spelt(w, &cycle_kind_spelt, "cycle");
    cycle.name = w.quoted();
    w.expect("at");
    s.place = w.vec();
    if (w.accept("plane")) cycle.plane = affine(w);
    cycle_words(w, s, cycle);
    s.cycle = std::move(cycle);
    return s;
}

PartBegin part(Words& w, PartKind kind) {
    PartBegin s;
    s.kind = kind;
    s.name = w.quoted();
    w.expect("pass");
    s.pass = w.integer<std::uint64_t>();
    w.expect("of");
    s.passes = w.integer<std::uint64_t>();
    return s;
}

CompensationBegin compensation(Words& w) {
    CompensationBegin s;
    s.side = static_cast<CompensationSide>(w.choice(sides));
    w.expect("radius");
    s.radius = w.number();
    w.expect("offset");
    s.offset = w.integer<std::uint32_t>();
    s.approach = static_cast<Approach>(w.choice(approaches));
    s.sharp = w.accept("sharp");
    if (w.accept("normal")) s.normal = w.vec();
    return s;
}

Programmed programmed(Words& w) {
    Programmed s;
    s.from = w.vec();
    w.expect("to");
    s.to = w.vec();
    if (w.accept("centre")) circle(w, s);
    s.rapid = w.accept("rapid");
    for (std::size_t i = 0; i < corners.size() && s.corner == Corner::none; ++i)
        if (w.accept(corners[i])) s.corner = static_cast<Corner>(i + 1), s.size = w.number();
    if (s.corner != Corner::none && w.accept("feed")) s.corner_feed = w.number();
    return s;
}

std::optional<Step> step(Words& w) {
    const std::string_view kind = w.word();
    if (kind == "rapid" || kind == "linear") return linear(w, kind == "rapid");
    if (kind == "arc") return arc(w);
    if (kind == "spline") return spline(w);
    if (kind == "axis") return axis(w);
    if (kind == "thread") return thread(w);
    if (kind == "dwell") {
        const double seconds = w.number();
        return Dwell{seconds, w.number()};
    }
    if (kind == "feed") return feed(w);
    if (kind == "spindle") return spindle(w);
    if (kind == "tool") return tool(w);
    if (kind == "zero-data") return datum_data(w);
    if (kind == "tool-data") return tool_data(w);
    if (kind == "lead") return lead(w);
    if (kind == "lead-end") return LeadEnd{};
    if (kind == "length") return tool_length(w);
    if (kind == "machine") return machine_place(w);
    if (kind == "coolant") return coolant(w);
    if (kind == "stop") return Stop{static_cast<StopKind>(w.choice<3>({"program", "optional", "end"}))};
    if (kind == "comment" || kind == "message") return Comment{w.quoted(), kind == "message", false};
    if (kind == "print") return Comment{w.quoted(), true, true};
    if (kind == "datum") return datum(w);
    if (kind == "frame") return frame(w);
    if (kind == "tolerance") return tolerance(w);
    if (kind == "path") return path_mode(w);
    if (kind == "setting") return setting(w);
    if (kind == "aux") return auxiliary(w);
    if (kind == "cycle") return cycle(w);
    if (kind == "cycle-end") return CycleEnd{};
    if (kind == "call") return part(w, PartKind::call);
    if (kind == "label") return part(w, PartKind::label);
    if (kind == "repeat") return part(w, PartKind::repetition);
    if (kind == "part-end") return PartEnd{};
    if (kind == "compensation") return compensation(w);
    if (kind == "compensation-end") return CompensationEnd{};
    if (kind == "programmed") return programmed(w);
    w.fail("unknown record kind \"" + std::string(kind) + "\"");
    return std::nullopt;
}

/// `@file:begin-end` and, where it is not the main program, `^stack`.
void origin(Words& w, Record& record) {
    if (!w.ok()) return;
    const std::string_view at = w.word();
    const std::size_t colon = at.find(':'), dash = at.find('-');
    if (!at.starts_with('@') || colon == std::string_view::npos || dash == std::string_view::npos || dash < colon)
        return w.fail("expected the source as @file:begin-end");
    record.from.file = w.integer_of<std::uint32_t>(at.substr(1, colon - 1));
    record.from.begin = w.integer_of<std::uint32_t>(at.substr(colon + 1, dash - colon - 1));
    record.from.end = w.integer_of<std::uint32_t>(at.substr(dash + 1));
    if (!w.ok() || w.at_end()) return;
    const std::string_view stack = w.word();
    if (!stack.starts_with('^')) return w.fail("expected the call stack as ^number, or the end of the line");
    record.stack = w.integer_of<StackId>(stack.substr(1));
    if (w.ok() && !w.at_end()) {
        w.word();
        w.fail("nothing may follow the call stack");
    }
}

}  // namespace

void read_text(const base::Sources& sources, std::uint32_t file, Sink sink, base::Diagnostics& diagnostics) {
    const std::string_view text = sources[file].text;
    const auto complain = [&](std::size_t begin, std::size_t end, std::string message) {
        const base::Span where{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        diagnostics.add({base::Severity::error, base::codes::syntax, where, std::move(message), "", {}, {}});
    };
    bool header = false;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t newline = std::min(text.find('\n', begin), text.size());
        std::string_view line = text.substr(begin, newline - begin);
        if (line.ends_with('\r')) line.remove_suffix(1);
        const bool empty = base::trim(line).empty() || line.starts_with(';');
        if (!empty && !header) {
            if (line != text_header)
                return complain(begin, begin + line.size(), "expected the first line \"obrys-cl 2\"");
            header = true;
        } else if (!empty) {
            Words words(line);
            Record record;
            if (std::optional<Step> s = step(words)) record.step = std::move(*s);
            origin(words, record);
            if (words.ok())
                sink(record);
            else
                complain(begin + words.wrong_begin(), begin + words.wrong_end(), words.message());
        }
        begin = newline + 1;
    }
}

std::vector<Record> read_text(const base::Sources& sources, std::uint32_t file, base::Diagnostics& diagnostics) {
    std::vector<Record> records;
    const auto keep = [&records](const Record& record) { records.push_back(record); };
    read_text(sources, file, Sink(keep), diagnostics);
    return records;
}

}  // namespace obrys::cl
