#include "driver/wording.hpp"

#include <array>

#include "base/text.hpp"

namespace obrys::driver {

namespace {

/// `control`: the beginning of its name.
struct Phrase {
    std::string_view control, general, own;
};

constexpr std::string_view circle = "a circle needs its centre (I, J, K), its radius (CR=) or its opening angle (AR=)";
constexpr std::string_view rs274_circle = "a circle needs its centre (I, J, K) or its radius (R)";
constexpr std::string_view spindle = "start the spindle with M3 or M4 and a speed S";
constexpr std::string_view tool = "select a tool with T and D before it";
constexpr std::string_view diameters = ", X words are diameters until DIAMOF";

constexpr std::string_view no_tool = "radius compensation with tool T0 D0, which selects no radius";
constexpr std::string_view unknown_tool = "radius compensation with tool T0 D0, whose radius is not known";
constexpr std::string_view both_axes = "ANG= with both of the plane's axes";
constexpr std::string_view no_axis = "ANG= with none of the plane's axes";
constexpr std::string_view angle_before = "or write the line before it with ANG= alone";
constexpr std::string_view angle_next = "the next block needs ANG= and the end point";
constexpr std::string_view no_offset = " cuts without its offset (D0)";
constexpr std::string_view no_offset_own = " cuts without its offset";
constexpr std::string_view plane_axes =
    "let PLANE position them (TURN, MOVE), or do so before the first move in the plane";
constexpr std::string_view plane_axes_own = "position them before the first move in the plane";
constexpr std::string_view no_tool_own = "radius compensation without a tool";

constexpr std::array phrases{
    Phrase{"heidenhain", circle, "a circle needs its centre (CC; DIN/ISO: I, J) or its radius (CR … R; DIN/ISO: R)"},
    Phrase{"heidenhain", "the sense of rotation DR is missing: no arc before this one has any",
           "the sense of rotation is missing (DR; DIN/ISO: G2 or G3): no arc before this one has any"},
    Phrase{"heidenhain", spindle, "start the spindle with M3 or M4; its speed S stands in TOOL CALL"},
    Phrase{"heidenhain", tool, "call a tool with TOOL CALL before it (DIN/ISO: T … G17)"},
    Phrase{"heidenhain", diameters, ""},
    Phrase{"heidenhain", no_offset, no_offset_own},
    Phrase{"heidenhain", no_tool, no_tool_own},
    Phrase{"heidenhain", "zero offset", "preset"},
    Phrase{"heidenhain", " D0, which selects no radius", ", whose radius is not known"},
    Phrase{"heidenhain", " D0, whose radius is 0", ", whose radius is 0"},
    Phrase{"sinumerik", plane_axes, plane_axes_own},
    Phrase{"linuxcnc", circle, rs274_circle},
    Phrase{"linuxcnc", no_offset, no_offset_own},
    Phrase{"linuxcnc", plane_axes, plane_axes_own},
    Phrase{"linuxcnc", tool, "select a tool with T and M6 before it"},
    Phrase{"linuxcnc", diameters, ""},
    Phrase{"linuxcnc", no_tool, no_tool_own},
    Phrase{"linuxcnc", unknown_tool, no_tool_own},
    Phrase{"acramatic", circle, "a circle needs its centre (I, J, K) or its radius (P)"},
    Phrase{"acramatic", "add M30; in a subprogram M17 or RET", "add M2 or M30"},
    Phrase{"acramatic", no_offset, no_offset_own},
    Phrase{"acramatic", tool, "select a tool with T and M6 before it"},
    Phrase{"acramatic", diameters, ""},
    Phrase{"acramatic", no_tool, no_tool_own},
    Phrase{"acramatic", unknown_tool, no_tool_own},
    Phrase{"nc-470", circle, "the control has no circles: it moves one axis at a time"},
    Phrase{"nc-470", "add M30; in a subprogram M17 or RET", "add M30"},
    Phrase{"nc-470", no_offset, no_offset_own},
    Phrase{"nc-470", tool, "select a tool with T and M6 before it"},
    Phrase{"nc-470", diameters, ""},
    Phrase{"nc-470", no_tool, no_tool_own},
    Phrase{"nc-470", unknown_tool, no_tool_own},
    Phrase{"apt", circle, "a circle needs its centre and radius (CIRCLE)"},
    Phrase{"apt", "add M2", "add FINI"},
    Phrase{"apt", spindle, "write SPINDL with a speed before it"},
    Phrase{"apt", tool, "load a tool with LOADTL before it"},
    Phrase{"apt", diameters, ""},
    Phrase{"fusion", circle, "a circle needs its centre and its normal"},
    Phrase{"fusion", "add M2", "let the CAM system write the file anew"},
    Phrase{"fusion", spindle, "give the tool of the operation a speed"},
    Phrase{"fusion", tool, "let a tool stand before the operation"},
    Phrase{"fusion", diameters, ""},
    Phrase{"fanuc", circle, rs274_circle},
    Phrase{"fanuc", no_offset, no_offset_own},
    Phrase{"fanuc", plane_axes, plane_axes_own},
    Phrase{"fanuc", tool, "select a tool before it: T and M6 on mills, T0101 on lathes"},
    Phrase{"fanuc", diameters, ", X words are diameters"},
    Phrase{"fanuc", no_tool, no_tool_own},
    Phrase{"fanuc", unknown_tool, no_tool_own},
    Phrase{"fanuc", both_axes, "an angle (A, ,A) with both of the plane's axes"},
    Phrase{"fanuc", no_axis, "an angle (A, ,A) with none of the plane's axes"},
    Phrase{"fanuc", angle_before, "or write the line before it with the angle alone"},
    Phrase{"fanuc", angle_next, "the next block needs an angle (A, ,A) and the end point"},
    Phrase{"haas", circle, rs274_circle},
    Phrase{"haas", no_offset, no_offset_own},
    Phrase{"haas", plane_axes, plane_axes_own},
    Phrase{"haas", tool, "select a tool before it: T and M6 on mills, T101 on lathes"},
    Phrase{"haas", diameters, ", X words are diameters"},
    Phrase{"haas", no_tool, no_tool_own},
    Phrase{"haas", unknown_tool, no_tool_own},
    Phrase{"haas", both_axes, "an angle (A, ,A) with both of the plane's axes"},
    Phrase{"haas", no_axis, "an angle (A, ,A) with none of the plane's axes"},
    Phrase{"haas", angle_before, "or write the line before it with the angle alone"},
    Phrase{"haas", angle_next, "the next block needs an angle (A, ,A) and the end point"},
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Tools have an index there, and no cutting edges by number: "tool T1 D1" is "tool T1", "T5 D2" is "T5.1".
std::string without_edges(std::string text) {
    for (std::size_t at = text.find(" D"); at != std::string::npos; at = text.find(" D", at + 1)) {
        std::size_t number = at, end = at + 2;
        while (number > 0 && is_digit(text[number - 1])) --number;
        while (end < text.size() && is_digit(text[end])) ++end;
        if (number > 0 && number < at && text[number - 1] == 'T' && end > at + 2) {
            const bool index = end == at + 3 && text[at + 2] >= '2';
            text.replace(at, end - at, index ? std::string{'.', static_cast<char>(text[at + 2] - 1)} : std::string());
        }
    }
    return text;
}

}  // namespace

std::string in_words_of(std::string_view control, std::string text) {
    for (const Phrase& p : phrases) {
        if (!control.starts_with(p.control)) continue;
        for (auto at = text.find(p.general); at != std::string::npos; at = text.find(p.general, at + p.own.size()))
            text.replace(at, p.general.size(), p.own);
    }
    return control.starts_with("heidenhain") ? without_edges(std::move(text)) : text;
}

namespace {

bool is_of_word(char c) { return base::is_letter(c) || is_digit(c) || c == '_'; }

std::string digits_at(const std::string& text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && is_digit(text[end])) ++end;
    return text.substr(at, end - at);
}

/// "tool T2 D1", of the stream, as the control's programmer writes it: "tool T0201", or "tool T2" where there is no D.
std::string tools_in_words_of(std::string_view control, bool offset_numbers, std::string text) {
    if (control.starts_with("sinumerik") || control.starts_with("heidenhain")) return text;
    constexpr std::string_view before = "tool T", between = " D";
    const auto two = [](const std::string& digits) { return digits.size() < 2 ? "0" + digits : digits; };
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
        if (at > 0 && is_of_word(text[at - 1])) continue;
        const std::string number = digits_at(text, at + before.size());
        const std::size_t behind = at + before.size() + number.size();
        if (number.empty() || text.compare(behind, between.size(), between) != 0) continue;
        const std::string edge = digits_at(text, behind + between.size());
        const std::size_t end = behind + between.size() + edge.size();
        if (edge.empty() || (end < text.size() && is_of_word(text[end]))) continue;
        return text.replace(at + before.size(), end - at - before.size(),
                            offset_numbers ? two(number) + two(edge) : number);
    }
    return text;
}

/// Where edges are no words of the control its programmer is not asked for one.
std::string edges_in_words_of(std::string_view control, std::string remedy) {
    const bool edge = remedy.starts_with("the list has it with edge = ");
    if (!edge || !control.starts_with("heidenhain")) return remedy;
    return "the list has this tool with another index: add it (edge = index + 1), or correct the program";
}

}  // namespace

void reword(std::string& text, std::string& remedy, std::string_view control, bool offset_numbers) {
    text = in_words_of(control, tools_in_words_of(control, offset_numbers, std::move(text)));
    remedy = in_words_of(control, edges_in_words_of(control, std::move(remedy)));
}

void reword(check::Result& result, std::string_view control, bool offset_numbers) {
    const auto each = [control, offset_numbers](auto& list) {
        for (auto& item : list) reword(item.text, item.remedy, control, offset_numbers);
    };
    each(result.findings);
    each(result.unchecked);
    each(result.assumptions);
    each(result.listed);
}

}  // namespace obrys::driver
