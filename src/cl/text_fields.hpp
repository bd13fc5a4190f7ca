#pragma once
/// The fields of every record in the order of its line: one table, by which the text form is both written and read.
/// Private to cl. `Io` is Line (text_write.cpp) or Reading (text_read.cpp); what both understand:
///   number, vec, whole, tool_number, quoted, axis_name    the next word or words
///   word("to")                                            stands there
///   flag("rapid", b)                                      stands there where b is true
///   value("radius", x, none)                              word and number where x is another one than `none`
///   vector("axis", v, none), perhaps("held", optional)    the same
///   choice(words, e)                                      the word of an enumerator

#include <type_traits>

#include "cl/cycle.hpp"
#include "cl/record.hpp"
#include "cl/record_words.hpp"
#include "cl/text.hpp"

namespace obrys::cl {

/// What `fields` gets: the record to be written, or the one to be filled.
template <class Io, class T>
using Of = std::conditional_t<Io::writes, const T, T>;

template <class Io, class Circle>
void circle_fields(Io& io, Circle& s) {
    io.vec(s.centre);
    io.word("normal");
    io.vec(s.normal);
    io.word("sweep");
    io.number(s.sweep);
}

template <class Io>
void affine_fields(Io& io, Of<Io, geom::Frame>& frame) {
    io.vec(frame.origin);
    bool linear = frame.linear != geom::Frame{}.linear;
    io.flag("by", linear);
    if (!linear) return;
    for (auto& v : frame.linear) io.number(v);
}

/// The axes of the lines before that of a record.
[[nodiscard]] inline const AxisEnds* ends_before(const Step& s) {
    const auto* programmed = std::get_if<Programmed>(&s);
    return programmed != nullptr ? &programmed->ends : ends_of(s);
}

[[nodiscard]] inline AxisEnds* ends_before(Step& s) {
    auto* programmed = std::get_if<Programmed>(&s);
    return programmed != nullptr ? &programmed->ends : ends_of(s);
}

// --- moves; whether they are rapid stands in the first word of a straight one
template <class Io>
void fields(Io& io, Of<Io, Linear>& s) {
    io.vec(s.to);
    io.vector("axis", s.axis, {0, 0, 1});
    bool seeks = s.seek != Seek::nothing;
    io.flag("seeks", seeks);
    if (seeks) io.choice(sought, s.seek, 1);
}
template <class Io>
void fields(Io& io, Of<Io, Arc>& s) {
    io.vec(s.to);
    io.word("centre");
    circle_fields(io, s);
    io.flag("rapid", s.rapid);
    io.vector("axis", s.axis, {0, 0, 1});
}
template <class Io>
void fields(Io& io, Of<Io, SplineAxis>& a) {
    io.axis_name(a.name);
    for (auto* v : {&a.to, &a.k3, &a.k2, &a.k1}) io.number(*v);
    io.choice(axis_units, a.rotary);
}
template <class Io>
void fields(Io& io, Of<Io, Spline>& s) {
    io.vec(s.to);
    io.word("k3");
    io.vec(s.k3);
    io.word("k2");
    io.vec(s.k2);
    io.word("k1");
    io.vec(s.k1);
    io.vector("axis", s.axis, {0, 0, 1});
    io.each_text(s.axes, [&](auto& a) { fields(io, a); });
}
template <class Io>
void fields(Io& io, Of<Io, AxisEnd>& s) {
    io.axis_name(s.name);
    io.number(s.to);
    io.choice(axis_units, s.rotary);
    io.flag("counted", s.counted);
}
template <class Io>
void fields(Io& io, Of<Io, Thread>& s) {
    io.vec(s.to);
    io.word("pitch");
    io.number(s.pitch);
    io.flag("tap", s.rigid_tap);
    io.value("start", s.start);
    io.value("change", s.change);
    io.vector("axis", s.axis, {0, 0, 1});
}
template <class Io>
void fields(Io& io, Of<Io, MachinePlace>& s) {
    io.choice(place_kinds, s.kind);
    io.whole_if_any(s.number, 1);
    constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
    const std::array to{&s.to.x, &s.to.y, &s.to.z};
    for (std::size_t k = 0; k < 3; ++k) {
        io.flag(names[k], s.axes[k]);
        if (s.axes[k]) io.number(*to[k]);
    }
    io.flag("tip", s.tip);
}

// --- feed, spindle, tools
template <class Io>
void fields(Io& io, Of<Io, Dwell>& s) {
    io.number(s.seconds);
    io.number(s.revolutions);
}
template <class Io>
void fields(Io& io, Of<Io, Feed>& s) {
    io.number(s.value);
    io.choice(feed_units, s.mode);
}
template <class Io>
void fields(Io& io, Of<Io, Spindle>& s) {
    io.number(s.speed);
    io.choice(speed_units, s.mode);
    io.sense(spindle_senses, s.direction);
    io.word("limit");
    io.number(s.limit);
    io.perhaps("held", s.held);
}
template <class Io>
void fields(Io& io, Of<Io, OtherSpindle>& s) {
    io.whole(s.number);
    io.perhaps("speed", s.speed), io.perhaps(spindle_senses, s.direction);
    io.perhaps("held", s.held), io.perhaps("limit", s.limit);
    io.whole("function", s.function);
}
template <class Io>
void fields(Io& io, Of<Io, ToolChange>& s) {
    io.tool_number(s.number);
    io.word("edge");
    io.tool_number(s.edge);
    io.quoted(s.name);
    io.value("raised", s.raised);
    io.value("wider", s.wider);
    io.flag("standing", s.standing);
    io.flag("lengthened", s.with_length);
    io.whole("offset", s.offset);
}
template <class Io>
void fields(Io& io, Of<Io, ToolSelection>& s) {
    io.whole(s.number);
    io.quoted(s.name);
}
template <class Io>
void fields(Io& io, Of<Io, ToolData>& s) {
    io.whole(s.number);
    io.word("edge");
    io.whole(s.edge);
    io.perhaps("length", s.length);
    io.perhaps("radius", s.radius);
}
template <class Io>
void fields(Io& io, Of<Io, ToolLength>& s) {
    io.sense(length_senses, s.sense);
    if (s.sense == 0) return;
    io.word("offset");
    io.whole(s.offset);
    io.perhaps("by", s.by);
}
template <class Io>
void fields(Io& io, Of<Io, Coolant>& s) {
    bool off = !s.flood && !s.mist;
    io.flag("off", off);
    if (off) return;
    io.flag("flood", s.flood);
    io.flag("mist", s.mist);
    if (!s.flood && !s.mist) io.fail("expected one of: off, flood, mist");
}
template <class Io>
void fields(Io& io, Of<Io, Stop>& s) {
    io.choice(stop_kinds, s.kind);
    io.flag("pallets", s.pallets), io.flag("stays", s.stays);
}
template <class Io>
void fields(Io& io, Of<Io, Comment>& s) {
    io.quoted(s.text);
}
template <class Io>
void fields(Io& io, Of<Io, Auxiliary>& s) {
    io.letter(s.letter);
    io.whole(s.number);
    io.whole("extension", s.extension);
}
template <class Io>
void fields(Io& io, Of<Io, Output>& s) {
    io.whole(s.number);
    io.flag("analog", s.analog);
    io.number(s.value);
    io.flag("with-motion", s.with_motion);
}
template <class Io>
void fields(Io& io, Of<Io, Override>& s) {
    io.choice(override_kinds, s.kind);
    io.choice(switches, s.on);
}
template <class Io>
void fields(Io& io, Of<Io, Tolerance>& s) {
    io.number(s.contour);
    io.word("rotary");
    io.number(s.rotary);
    io.choice(filters, s.filter);
}
template <class Io>
void fields(Io& io, Of<Io, PathMode>& s) {
    io.choice(path_kinds, s.kind);
    io.value("tolerance", s.tolerance);
    io.value("merge", s.merge);
    io.whole("way", s.way);
}

// --- zeros and frames
template <class Io>
void fields(Io& io, Of<Io, Datum>& s) {
    io.whole(s.number);
    io.vec(s.origin);
    io.flag("selected", s.selected);
}
template <class Io>
void fields(Io& io, Of<Io, DatumData>& s) {
    io.whole(s.number);
    io.vec(s.origin);
    io.perhaps("turned", s.turn);
    io.flag("added", s.added);
}
template <class Io>
void fields(Io& io, Of<Io, Frame>& s) {
    io.each_word(s.parts, "", [&](auto& p) {
        io.choice(frame_kinds, p.kind);
        affine_fields(io, p.frame);
        io.flag_is("seq+", p.turn.side, std::int8_t{1});
        io.flag_is("seq-", p.turn.side, std::int8_t{-1});
        io.flag("table", p.turn.table_turns);
        io.flag("turns", p.turn.by_control);
    });
}

// --- brackets
template <class Io, class Passes>
void pass_fields(Io& io, Passes& s) {
    io.whole(s.pass);
    io.word("of");
    io.whole(s.passes);
}
template <class Io>
void fields(Io& io, Of<Io, Cycle>& c, Of<Io, CycleBegin>& s) {
    io.spelt(c.kind);
    io.quoted(c.name);
    io.word("at");
    io.vec(s.place);
    bool placed = c.plane != geom::Frame{};
    io.flag("plane", placed);
    if (placed) affine_fields(io, c.plane);
    for (const auto& [word, call] : {std::pair{"modal", CycleCall::modal}, std::pair{"pattern", CycleCall::pattern}})
        io.flag_is(word, s.call, call);
    bool counted = s.pass != 1 || s.passes != 1;
    io.flag("pass", counted);
    if (counted) pass_fields(io, s);
    io.each_word(c.values, "written", [&](auto& v) {
        io.spelt(v.role);
        io.number(v.value);
    });
    bool written = !c.written.empty();
    io.flag("written", written);
    if (!written) return;
    io.each_text(c.written, [&](auto& p) {
        io.quoted(p.name);
        io.number(p.value);
    });
}
template <class Io>
void fields(Io& io, Of<Io, CycleBegin>& s) {
    io.cycle(s);
}
template <class Io>
void fields(Io& io, Of<Io, PartBegin>& s) {
    io.quoted(s.name);
    io.word("pass");
    pass_fields(io, s);
    bool given = !s.arguments.empty();
    io.flag("with", given);
    if (!given) return;
    io.each_text(s.arguments, [&](auto& a) {
        io.quoted(a.name);
        io.number_or_text(a.value, a.text);
    });
}
template <class Io>
void fields(Io& io, Of<Io, CompensationBegin>& s) {
    io.choice(sides, s.side);
    io.word("radius");
    io.number(s.radius);
    io.word("offset");
    io.whole(s.offset);
    io.choice(approaches, s.approach);
    io.flag("sharp", s.sharp);
    io.vector("normal", s.normal, {0, 0, 1});
    io.flag("given", s.given);
    io.whole("nose", s.nose);
}
template <class Io>
void fields(Io& io, Of<Io, Programmed>& s) {
    io.vec(s.from);
    io.word("to");
    io.vec(s.to);
    bool round = s.sweep != 0;
    io.flag("centre", round);
    if (round) circle_fields(io, s);
    io.flag("rapid", s.rapid);
    io.any_choice(corners, s.corner);  // none: no word
    if (s.corner == Corner::none) return;
    io.number(s.size);
    io.value("feed", s.corner_feed);
}
template <class Io>
void fields(Io& io, Of<Io, LeadBegin>& s) {
    io.choice(lead_ends, s.onto);
    io.choice(lead_kinds, s.kind);
    io.word("at");
    io.vec(s.at);
    io.value("length", s.length);
    io.value("radius", s.radius);
    io.value("angle", s.angle);
    io.value("feed", s.feed);
    io.flag("rapid", s.rapid);
}
/// The ends of brackets.
template <class Io, class End>
requires std::is_empty_v<End>
void fields(Io&, End&) {}

}  // namespace obrys::cl
