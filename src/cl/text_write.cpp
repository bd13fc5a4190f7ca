#include <cmath>

#include "base/number.hpp"
#include "base/text.hpp"
#include "cl/text.hpp"
#include "cl/unknown_tool.hpp"

namespace obrys::cl {

namespace {

void number(std::string& out, double value) {
    out += ' ';
    out += std::isnan(value) ? "?" : base::shortest(value);
}

void vec(std::string& out, geom::Vec3 v) {
    number(out, v.x);
    number(out, v.y);
    number(out, v.z);
}

/// A blank and the text in quotes; control characters, quotes and backslashes escaped, all other bytes as they are.
void quoted(std::string& out, std::string_view text) {
    constexpr std::string_view hex = "0123456789abcdef";
    out += " \"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (byte < 0x20 || byte == 0x7F) {
            out += "\\x";
            out += hex[byte >> 4];
            out += hex[byte & 15];
        } else {
            out += c;
        }
    }
    out += '"';
}

void axis_name(std::string& out, const std::array<char, 8>& name) {
    std::size_t length = 0;
    while (length < name.size() && name[length] != 0) ++length;
    quoted(out, {name.data(), length});
}

void affine(std::string& out, const geom::Frame& frame) {
    vec(out, frame.origin);
    if (frame.linear == geom::Frame{}.linear) return;
    out += " by";
    for (const double v : frame.linear) number(out, v);
}

/// Of an Arc or a programmed one.
template <class Circle>
void circle(std::string& out, const Circle& s) {
    out += " centre";
    vec(out, s.centre);
    out += " normal";
    vec(out, s.normal);
    out += " sweep";
    number(out, s.sweep);
}

struct StepWriter {
    std::string& out;

    void operator()(const Linear& s) const {
        out += s.rapid ? "rapid" : "linear";
        vec(out, s.to);
        if (s.axis == geom::Vec3{0, 0, 1}) return;
        out += " axis";
        vec(out, s.axis);
    }
    void operator()(const Arc& s) const {
        out += "arc";
        vec(out, s.to);
        circle(out, s);
        if (s.rapid) out += " rapid";
    }
    void operator()(const Spline& s) const {
        out += "spline";
        vec(out, s.to);
        out += " k3";
        vec(out, s.k3);
        out += " k2";
        vec(out, s.k2);
        out += " k1";
        vec(out, s.k1);
        if (!(s.axis == geom::Vec3{0, 0, 1})) {
            out += " axis";
            vec(out, s.axis);
        }
        for (const SplineAxis& a : s.axes) {
            axis_name(out, a.name);
            for (const double v : {a.to, a.k3, a.k2, a.k1}) number(out, v);
            out += a.rotary ? " deg" : " mm";
        }
    }
    void operator()(const Axis& s) const {
        out += "axis";
        axis_name(out, s.name);
        number(out, s.to);
        out += s.rotary ? " deg" : " mm";
        if (s.counted) out += " counted";
    }
    void operator()(const Thread& s) const {
        out += "thread";
        vec(out, s.to);
        out += " pitch";
        number(out, s.pitch);
        if (s.rigid_tap) out += " tap";
    }
    void operator()(const Dwell& s) const {
        out += "dwell";
        number(out, s.seconds);
        number(out, s.revolutions);
    }
    void operator()(const Feed& s) const {
        out += "feed";
        number(out, s.value);
        out += s.mode == FeedMode::per_minute ? " mm/min" : s.mode == FeedMode::per_rev ? " mm/rev" : " 1/min";
    }
    void operator()(const Spindle& s) const {
        out += "spindle";
        number(out, s.speed);
        out += s.mode == SpindleMode::rpm ? " 1/min" : " m/min";
        out += s.direction > 0 ? " cw" : s.direction < 0 ? " ccw" : " stop";
        out += " limit";
        number(out, s.limit);
        if (!s.held) return;
        out += " held";
        number(out, *s.held);
    }
    void operator()(const ToolChange& s) const {
        const auto number_of = [](std::uint32_t n) { return n == unknown_tool ? "?" : std::to_string(n); };
        out += "tool " + number_of(s.number) + " edge " + number_of(s.edge);
        quoted(out, s.name);
        if (s.raised != 0) out += " raised", number(out, s.raised);
        if (s.wider != 0) out += " wider", number(out, s.wider);
        if (s.standing) out += " standing";
        if (s.with_length) out += " lengthened";
        if (s.offset != 0) out += " offset " + std::to_string(s.offset);
    }
    void operator()(const ToolData& s) const {
        out += "tool-data " + std::to_string(s.number) + " edge " + std::to_string(s.edge);
        if (s.length) out += " length", number(out, *s.length);
        if (s.radius) out += " radius", number(out, *s.radius);
    }
    void operator()(const DatumData& s) const {
        out += "zero-data " + std::to_string(s.number);
        vec(out, s.origin);
        if (s.turn) out += " turned", number(out, *s.turn);
        if (s.added) out += " added";
    }
    void operator()(const ToolLength& s) const {
        out += s.sense > 0 ? "length added" : s.sense < 0 ? "length subtracted" : "length off";
        if (s.sense == 0) return;
        out += " offset " + std::to_string(s.offset);
        if (!s.by) return;
        out += " by";
        vec(out, *s.by);
    }
    void operator()(const MachinePlace& s) const {
        out += "machine ";
        out += place_kinds[static_cast<std::size_t>(s.kind)];
        if (s.number != 1) out += ' ' + std::to_string(s.number);
        constexpr std::array<const char*, 3> names{" x", " y", " z"};
        const std::array<double, 3> to{s.to.x, s.to.y, s.to.z};
        for (std::size_t k = 0; k < 3; ++k)
            if (s.axes[k]) out += names[k], number(out, to[k]);
    }
    void operator()(const Coolant& s) const {
        out += "coolant";
        if (!s.flood && !s.mist) out += " off";
        if (s.flood) out += " flood";
        if (s.mist) out += " mist";
    }
    void operator()(const Stop& s) const {
        out += "stop";
        out += s.kind == StopKind::program ? " program" : s.kind == StopKind::optional ? " optional" : " end";
    }
    void operator()(const Comment& s) const {
        out += s.terminal ? "print" : s.message ? "message" : "comment";
        quoted(out, s.text);
    }
    void operator()(const Datum& s) const {
        out += "datum " + std::to_string(s.number);
        vec(out, s.origin);
    }
    void operator()(const Frame& s) const {
        out += "frame";
        for (const FramePart& p : s.parts) {
            out += ' ';
            out += frame_kinds[static_cast<std::size_t>(p.kind)];
            affine(out, p.frame);
        }
    }
    void operator()(const Tolerance& s) const {
        constexpr std::array<const char*, 5> filters{" none", " finishing", " semi-finishing", " roughing",
                                                     " precision"};
        out += "tolerance";
        number(out, s.contour);
        out += " rotary";
        number(out, s.rotary);
        out += filters[static_cast<std::size_t>(s.filter)];
    }
    void operator()(const PathMode& s) const {
        out += "path ";
        out += path_kinds[static_cast<std::size_t>(s.kind)];
        if (s.tolerance != 0) out += " tolerance", number(out, s.tolerance);
        if (s.merge != 0) out += " merge", number(out, s.merge);
        if (s.way != 0) out += " way " + std::to_string(s.way);
    }
    void operator()(const Setting& s) const {
        out += "setting " + std::to_string(static_cast<int>(s.kind)) + ' ' + std::to_string(s.number) + ' ' +
               std::to_string(s.second);
        for (const double v : s.values) number(out, v);
    }
    void operator()(const Auxiliary& s) const {
        out += "aux";
        quoted(out, {&s.letter, 1});
        out += ' ' + std::to_string(s.number);
    }
    void operator()(const CycleBegin& s) const {
        const Cycle& c = *s.cycle;
        out += "cycle ";
        out += spelling(c.kind);
        quoted(out, c.name);
        out += " at";
        vec(out, s.place);
        if (c.plane != geom::Frame{}) {
            out += " plane";
            affine(out, c.plane);
        }
        if (s.call != CycleCall::single) out += s.call == CycleCall::modal ? " modal" : " pattern";
        if (s.pass != 1 || s.passes != 1) out += " pass " + std::to_string(s.pass) + " of " + std::to_string(s.passes);
        for (const CycleValue& v : c.values) {
            out += ' ';
            out += spelling(v.role);
            number(out, v.value);
        }
        if (c.written.empty()) return;
        out += " written";
        for (const CycleParameter& p : c.written) {
            quoted(out, p.name);
            number(out, p.value);
        }
    }
    void operator()(const CycleEnd&) const { out += "cycle-end"; }
    void operator()(const PartBegin& s) const {
        out += s.kind == PartKind::call ? "call" : s.kind == PartKind::label ? "label" : "repeat";
        quoted(out, s.name);
        out += " pass " + std::to_string(s.pass) + " of " + std::to_string(s.passes);
    }
    void operator()(const PartEnd&) const { out += "part-end"; }
    void operator()(const CompensationBegin& s) const {
        out += "compensation ";
        out += sides[static_cast<std::size_t>(s.side)];
        out += " radius";
        number(out, s.radius);
        out += " offset " + std::to_string(s.offset) + ' ';
        out += approaches[static_cast<std::size_t>(s.approach)];
        if (s.sharp) out += " sharp";
        if (s.normal == geom::Vec3{0, 0, 1}) return;
        out += " normal";
        vec(out, s.normal);
    }
    void operator()(const CompensationEnd&) const { out += "compensation-end"; }
    void operator()(const Programmed& s) const {
        out += "programmed";
        vec(out, s.from);
        out += " to";
        vec(out, s.to);
        if (s.sweep != 0) circle(out, s);
        if (s.rapid) out += " rapid";
        if (s.corner == Corner::none) return;
        out += ' ';
        out += corners[static_cast<std::size_t>(s.corner) - 1];
        number(out, s.size);
        if (s.corner_feed != 0) out += " feed", number(out, s.corner_feed);
    }
    void operator()(const LeadBegin& s) const {
        out += s.onto ? "lead onto " : "lead off ";
        out += lead_kinds[static_cast<std::size_t>(s.kind)];
        out += " at";
        vec(out, s.at);
        if (s.length != 0) out += " length", number(out, s.length);
        if (s.radius != 0) out += " radius", number(out, s.radius);
        if (s.angle != 0) out += " angle", number(out, s.angle);
        if (s.feed != 0) out += " feed", number(out, s.feed);
        if (s.rapid) out += " rapid";
    }
    void operator()(const LeadEnd&) const { out += "lead-end"; }
};

}  // namespace

void append_text(std::string& out, const Record& record) {
    std::visit(StepWriter{out}, record.step);
    out += " @" + std::to_string(record.from.file) + ':' + std::to_string(record.from.begin) + '-' +
           std::to_string(record.from.end);
    if (record.stack != 0) out += " ^" + std::to_string(record.stack);
}

std::string to_text(const Record& record) {
    std::string out;
    append_text(out, record);
    return out;
}

std::string to_text(const std::vector<Record>& records) {
    std::string out(text_header);
    out += '\n';
    for (const Record& record : records) {
        append_text(out, record);
        out += '\n';
    }
    return out;
}

TextWriter::TextWriter(base::FunctionRef<void(std::string_view)> out) : out_(out) {
    line_ = text_header;
    line_ += '\n';
    out_(line_);
}

void TextWriter::operator()(const Record& record) {
    line_.clear();
    append_text(line_, record);
    line_ += '\n';
    out_(line_);
}

}  // namespace obrys::cl
