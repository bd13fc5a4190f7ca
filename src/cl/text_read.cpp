#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "cl/text.hpp"
#include "cl/unknown_tool.hpp"

namespace obrys::cl {

namespace {

/// Takes the words of one line from left to right. After the first wrong word everything fails and `wrong` holds it.
class Words {
public:
    Words(std::string_view line) : line_(line) {}

    [[nodiscard]] bool ok() const { return message_.empty(); }
    [[nodiscard]] const std::string& message() const { return message_; }
    [[nodiscard]] std::size_t wrong_begin() const { return begin_; }
    [[nodiscard]] std::size_t wrong_end() const { return at_; }
    [[nodiscard]] bool at_end() {
        skip_blanks();
        return at_ == line_.size();
    }
    void fail(std::string message) {
        if (ok()) message_ = std::move(message);
    }

    std::string_view word() {
        skip_blanks();
        begin_ = at_;
        while (at_ < line_.size() && !base::is_blank(line_[at_])) ++at_;
        return line_.substr(begin_, at_ - begin_);
    }
    /// The next word without taking it.
    std::string_view peek() {
        skip_blanks();
        std::size_t end = at_;
        while (end < line_.size() && !base::is_blank(line_[end])) ++end;
        return line_.substr(at_, end - at_);
    }
    void expect(std::string_view wanted) {
        if (ok() && word() != wanted) fail("expected \"" + std::string(wanted) + "\"");
    }
    /// True and taken where the next word is `wanted`.
    bool accept(std::string_view wanted) {
        if (!ok() || peek() != wanted) return false;
        word();
        return true;
    }
    double number() {
        if (!ok()) return 0;
        const std::string_view w = word();
        if (w == "?") return std::numeric_limits<double>::quiet_NaN();
        if (w == "inf") return std::numeric_limits<double>::infinity();
        if (w == "-inf") return -std::numeric_limits<double>::infinity();
        const std::optional<double> value = base::parse_double(w);
        if (!value) fail("expected a number or ?");
        return value.value_or(0);
    }
    geom::Vec3 vec() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    template <class Integer>
    Integer integer() {
        if (!ok()) return 0;
        return integer_of<Integer>(word());
    }
    template <class Integer>
    Integer integer_of(std::string_view w) {
        Integer value = 0;
        const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
        if (w.empty() || error != std::errc{} || end != w.data() + w.size()) fail("expected a whole number");
        return value;
    }
    /// The index of the next word in `words`.
    template <std::size_t N>
    std::size_t choice(const std::array<std::string_view, N>& words) {
        if (!ok()) return 0;
        const std::string_view w = word();
        std::string all;
        for (std::size_t i = 0; i < N; ++i) {
            if (w == words[i]) return i;
            all += (i == 0 ? "" : ", ") + std::string(words[i]);
        }
        fail("expected one of: " + all);
        return 0;
    }
    std::string quoted();

private:
    void skip_blanks() {
        while (at_ < line_.size() && base::is_blank(line_[at_])) ++at_;
    }
    char escape();

    std::string_view line_;
    std::size_t at_ = 0, begin_ = 0;
    std::string message_;
};

/// The character an escape stands for; `at_` is behind the backslash.
char Words::escape() {
    const char c = at_ < line_.size() ? line_[at_++] : '\0';
    if (c == '"' || c == '\\') return c;
    if (c == 'n') return '\n';
    unsigned value = 0;
    const char* first = line_.data() + at_;
    if (c == 'x' && at_ + 2 <= line_.size() && std::from_chars(first, first + 2, value, 16).ptr == first + 2) {
        at_ += 2;
        return static_cast<char>(value);
    }
    fail("unknown escape; known are \\\" \\\\ \\n \\xHH");
    return 0;
}

std::string Words::quoted() {
    std::string out;
    if (!ok()) return out;
    skip_blanks();
    begin_ = at_;
    if (at_ == line_.size() || line_[at_] != '"') {
        word();
        fail("expected a text in quotes");
        return out;
    }
    ++at_;
    while (ok() && at_ < line_.size() && line_[at_] != '"') {
        const char c = line_[at_++];
        out += c == '\\' ? escape() : c;
    }
    if (at_ == line_.size()) fail("the closing quote is missing");
    if (ok()) ++at_;
    return out;
}

Linear linear(Words& w, bool rapid) {
    Linear s;
    s.rapid = rapid;
    s.to = w.vec();
    if (w.accept("axis")) s.axis = w.vec();
    return s;
}

Arc arc(Words& w) {
    Arc s;
    s.to = w.vec();
    w.expect("centre");
    s.centre = w.vec();
    w.expect("normal");
    s.normal = w.vec();
    w.expect("sweep");
    s.sweep = w.number();
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
    return s;
}

Datum datum(Words& w) {
    Datum s;
    s.number = w.integer<std::uint32_t>();
    s.origin = w.vec();
    return s;
}

Frame frame(Words& w) {
    Frame s;
    while (w.ok() && !w.peek().empty() && w.peek().front() >= 'a') {
        FramePart p;
        p.kind = static_cast<FrameKind>(w.choice(frame_kinds));
        p.frame.origin = w.vec();
        if (w.accept("by"))
            for (double& v : p.frame.linear) v = w.number();
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

CycleBegin cycle(Words& w) {
    CycleBegin s;
    s.name = w.quoted();
    while (w.ok() && w.peek().starts_with('"')) {
        CycleParameter p;
        p.name = w.quoted();
        p.value = w.number();
        s.parameters.push_back(std::move(p));
    }
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
    if (kind == "coolant") return coolant(w);
    if (kind == "stop") return Stop{static_cast<StopKind>(w.choice<3>({"program", "optional", "end"}))};
    if (kind == "comment" || kind == "message") return Comment{w.quoted(), kind == "message", false};
    if (kind == "print") return Comment{w.quoted(), true, true};
    if (kind == "datum") return datum(w);
    if (kind == "frame") return frame(w);
    if (kind == "tolerance") return tolerance(w);
    if (kind == "setting") return setting(w);
    if (kind == "aux") return auxiliary(w);
    if (kind == "cycle") return cycle(w);
    if (kind == "cycle-end") return CycleEnd{};
    if (kind == "call") return part(w, PartKind::call);
    if (kind == "label") return part(w, PartKind::label);
    if (kind == "repeat") return part(w, PartKind::repetition);
    if (kind == "part-end") return PartEnd{};
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
                return complain(begin, begin + line.size(), "expected the first line \"obrys-cl 1\"");
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
