/// One statement: its first word says which file reads the rest.

#include <algorithm>

#include "base/text.hpp"
#include "base/whole.hpp"
#include "read/apt/state.hpp"

namespace obrys::read::apt {

using dialect::apt::Major;
using dialect::apt::MajorWord;
using program::Code;
using program::Modal;

namespace {

bool of_apt(std::string_view upper) {
    const MajorWord* word = dialect::apt::find_major(upper);
    return word != nullptr && (word->major == Major::apt_arc || word->major == Major::part_word);
}

/// The word of the statement. TLON, TLLFT and TLRGT may stand before one of APT's motions, RAPID before a point.
const Token& major_token(State& s) {
    const auto& t = s.line.tokens;
    if (t.size() < 3 || t[0].kind != TokenKind::word || t[1].kind != TokenKind::comma || t[2].kind != TokenKind::word)
        return t[0];
    const std::string before = upper_of(t[0]);
    if (before.starts_with("TL") && of_apt(upper_of(t[2]))) return t[2];
    if (before != "RAPID") return t[0];
    s.rapid = true;
    return t[2];
}

/// PPRINT, PARTNO, INSERT …: what stands behind the word, a slash between them or not.
std::string_view text_behind(const State& s) {
    std::string_view rest = s.scanner.rest_of_line(s.line.tokens.front().end);
    rest = base::trim(rest);
    if (rest.starts_with("/")) rest.remove_prefix(1);
    return base::trim(rest);
}

void tell_note(State& s) {
    const std::string_view rest = text_behind(s);
    if (rest.empty()) return;
    begin_block(s);
    s.build.unit().texts.push_back(base::as_utf8(rest));
    s.build.word(Code::comment, program::Form::index, static_cast<std::int32_t>(s.build.unit().texts.size() - 1),
                 s.line.begin, s.line.end);
    end_block(s);
}

/// The statement that begins with a text word ends with its line, whatever signs stand there.
void read_text(State& s, Major major) {
    const std::uint32_t end = s.line.tokens.front().end +
                              static_cast<std::uint32_t>(s.scanner.rest_of_line(s.line.tokens.front().end).size());
    s.line.end = end;
    if (major == Major::text || s.system.inserts_notes) return tell_note(s);
    refuse(s, "the line goes to the control as it stands, and what it does there is not known");
}

void tell_function(State& s, int m) {
    begin_block(s);
    s.build.literal(Code::m, m, s.line.begin, s.line.end);
    end_block(s);
}

void read_units(State& s, const Arguments& a) {
    const std::string unit = a.begin() != a.end() ? upper_of(*a.begin()) : "";
    if (unit == "MM" || unit == "INCHES" || unit == "INCH" || unit == "IN") {
        refuse_rest(s, a, 1);
        return set_unit(s, unit == "MM" ? 1 : 25.4);
    }
    fail(s, a.begin(), "this is no unit of length that is read here", "write UNITS/MM or UNITS/INCHES");
}

/// SYN/'TLAXIS','$$*TLAXIS': the first of each pair is another spelling of the second.
void read_synonyms(State& s, const Arguments& a) {
    std::vector<std::string> words;
    for (const Token& t : a)
        if (t.kind == TokenKind::word || t.kind == TokenKind::text) words.push_back(upper_of(t));
    if (words.empty() || words.size() % 2 != 0) return fail(s, a.begin(), "SYN wants pairs of words");
    for (std::size_t i = 0; i < words.size(); i += 2) s.synonyms[words[i]] = words[i + 1];
    s.build.ignored("SYN", s.line.begin, s.line.end);
}

void read_setup(State& s, const Arguments& a) {
    const std::string word = a.begin() != a.end() ? upper_of(*a.begin()) : "";
    if (word != "START" && word != "END") return refuse(s, "only START and END of a clamping are known");
    refuse_rest(s, a, 2);
    if (word == "END" || ++s.setups < 2) return s.build.ignored("SETUP", s.line.begin, s.line.end);
    refuse(s, "the part is clamped anew, and how it lies then is not said");
}

void read_multax(State& s, const Arguments& a) {
    const bool plain = a.begin() == a.end() || upper_of(*a.begin()) == "ON" || upper_of(*a.begin()) == "OFF";
    if (plain) {
        refuse_rest(s, a, 1);
        return s.build.ignored("MULTAX", s.line.begin, s.line.end);
    }
    refuse(s, "how many vectors a point has by MULTAX is not followed");
}

void read_transform(State& s, const Arguments& a) {
    const bool moved = std::any_of(a.begin(), a.end(),
                                   [](const Token& t) { return t.kind == TokenKind::number && t.number.value != 0; });
    if (a.begin() != a.end() && upper_of(*a.begin()) == "WORLD" && !moved)
        return s.build.ignored("TRNTYP/WORLD", s.line.begin, s.line.end);
    refuse(s, "points are written in a system other than the part's");
}

void read_stop(State& s, const Arguments& a, int m) {
    refuse_rest(s, a, 0);
    tell_function(s, m);
}

void read_end(State& s, const Arguments& a) {
    drop_circle(s);
    refuse_rest(s, a, 0);
    tell_function(s, 30);
    s.ended = true;
}

/// The next point is at rapid, whatever else the words say of it.
void read_rapid(State& s, const Arguments& a) {
    refuse_rest(s, a, 0);
    s.rapid = true;
}

void read_tool_path(State& s) {
    const auto& t = s.line.tokens;
    if (t.size() > 1 && upper_of(t[1]) == "PATH") return s.build.ignored("TOOL PATH", s.line.begin, s.line.end);
    refuse(s, "of TOOL only TOOL PATH is known");
}

void read_path_end(State& s) {
    drop_circle(s);
    s.path_closed = true;
    s.build.ignored("END-OF-PATH", s.line.begin, s.line.end);
}

/// Messages of the postprocessor switched on and off (ICAM): the path is the same.
bool is_diagnosis(const Arguments& a) {
    constexpr double diagnoses = 15;
    return a.begin() != a.end() && a.begin()->kind == TokenKind::number && a.begin()->number.value == diagnoses;
}

void read_known(State& s, const MajorWord& w, const Arguments& a) {
    switch (w.major) {
        case Major::go_to: return read_point(s, a);
        case Major::from: return read_from(s, a);
        case Major::go_delta: return read_delta(s, a);
        case Major::circle: return read_circle(s, a);
        case Major::along: return read_direction(s, a, false);
        case Major::apt_arc: return read_apt_arc(s);
        case Major::rapid: return read_rapid(s, a);
        case Major::feed: return read_feed(s, a);
        case Major::spindle: return read_spindle(s, a);
        case Major::load_tool: return read_load(s, a, false);
        case Major::load: return read_load(s, a, true);
        case Major::tool_data: return read_cutter(s, a);
        case Major::tool_kind: return read_tool_kind(s, a);
        case Major::coolant: return read_coolant(s, a);
        case Major::compensate: return read_compensation(s, a);
        case Major::cycle: return read_cycle(s, a);
        case Major::tool_axis: return read_direction(s, a, true);
        case Major::multax: return read_multax(s, a);
        case Major::delay: return read_delay(s, a);
        case Major::stop: return read_stop(s, a, 0);
        case Major::optional_stop: return read_stop(s, a, 1);
        case Major::end: return read_end(s, a);
        case Major::tool_path: return read_tool_path(s);
        case Major::path_end: return read_path_end(s);
        case Major::shift: return read_shift(s, a, false);
        case Major::origin: return read_shift(s, a, true);
        case Major::units: return read_units(s, a);
        case Major::system: return read_system(s, a);
        case Major::placement: return read_placement(s, a);
        case Major::transform: return read_transform(s, a);
        case Major::setup: return read_setup(s, a);
        case Major::synonym: return read_synonyms(s, a);
        case Major::quiet: return s.build.ignored(w.name, s.line.begin, s.line.end);
        case Major::text:
        case Major::insert: return read_text(s, w.major);
        case Major::mode:
        case Major::part_word:
        case Major::not_run: break;
    }
    if (w.name == "PPFUN" && is_diagnosis(a)) return s.build.ignored(w.name, s.line.begin, s.line.end);
    refuse(s, w.note);
}

/// Those whose words nobody has to understand, or that are said as a whole.
bool takes_anything(Major m) {
    return dialect::apt::is_text(m) || m == Major::quiet || m == Major::not_run || m == Major::part_word ||
           m == Major::mode || m == Major::apt_arc || m == Major::tool_path;
}

/// The sign or word that is no part of `WORD` or `WORD/item,item,…`; null: it has that form.
const Token* out_of_form(const Line& line, const Token& major, const Arguments& a) {
    const Token* const end = line.tokens.data() + line.tokens.size();
    const Token* next = &major + 1;
    if (next != end && next->kind != TokenKind::slash) return next;
    bool due = true;
    for (const Token& t : a) {
        const bool item = t.kind == TokenKind::word || t.kind == TokenKind::number || t.kind == TokenKind::text;
        if (due ? !item : t.kind != TokenKind::comma) return &t;
        due = !due;
    }
    return due && a.begin() != a.end() ? a.end() - 1 : nullptr;
}

bool assigns(const Line& line) {
    return std::any_of(line.tokens.begin(), line.tokens.end(),
                       [](const Token& t) { return t.kind == TokenKind::equals; }) ||
           (line.tokens.size() > 1 && line.tokens[1].kind == TokenKind::close);
}

void read_unknown(State& s, const Token& t, const std::string& word) {
    if (assigns(s.line))
        return refuse(s,
                      "it is of an APT part program, not of cutter locations: an APT processor makes GOTO and CIRCLE "
                      "of it");
    const std::string_view near = dialect::apt::nearest_major(word);
    begin_block(s);
    s.build.problem(Code::unknown, t.begin, t.end,
                    near.empty() ? std::string("no statement of cutter locations begins so")
                                 : "did you mean " + std::string(near) + "?");
    end_block(s);
}

}  // namespace

namespace {

/// Creo's `$$-> CSYS / twelve numbers`: what the points behind it count from, in the part.
void read_comment_system(State& s, std::string_view packed) {
    std::vector<double> n;
    for (std::string_view rest = packed.substr(packed.find('/') + 1); !rest.empty();) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        if (const auto v = base::parse_double(rest.substr(0, end))) n.push_back(*v);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    s.line.begin = static_cast<std::uint32_t>(s.line.comment.data() - s.text.data()) - 2;
    s.line.end = s.line.begin + 2 + static_cast<std::uint32_t>(s.line.comment.size());
    if (n.size() == 12) return place_part(s, n);
    refuse(s, "twelve numbers are due: where the points behind it count from is not known");
}

/// Words beyond the most that are kept have been passed by: nothing is guessed from those before.
void say_too_long(State& s) {
    fail(s, &s.line.tokens.back(),
         "a statement of more than " + std::to_string(Line::most_tokens) + " words, numbers and signs is not read",
         "end its line, or take out a $ by which lines go on that are none of it");
}

}  // namespace

void read_comment(State& s) {
    // What CAM systems say in comments of their own and posts read.
    std::string packed;
    for (const char c : s.line.comment)
        if (!base::is_blank(c) && c != '\r' && c != '\n' && c != '$') packed += base::upper(c);
    if (packed.starts_with("->CSYS/")) return read_comment_system(s, packed);
    if (!packed.starts_with("->CUTCOM_GEOMETRY_TYPE/") || packed.ends_with("OUTPUT_ON_CENTER")) return;
    const auto begin = static_cast<std::uint32_t>(s.line.comment.data() - s.text.data());
    assume(s, begin, begin + static_cast<std::uint32_t>(s.line.comment.size()),
           "points are said to lie on the contour where CUTCOM is on: they are run as they stand, which is the tool's "
           "centre",
           "let the CAM system write the points of the tool's centre");
}

void read_statement(State& s) {
    if (s.line.unended) return fail(s, nullptr, "the text ends behind $, which wants a further line");
    s.path_closed = false;
    const Token& t = major_token(s);
    if (t.kind == TokenKind::number && s.line.too_long) return say_too_long(s);
    if (t.kind == TokenKind::number)
        return read_point(s, {s.line.tokens.data(), s.line.tokens.data() + s.line.tokens.size()});
    if (t.kind != TokenKind::word) return fail(s, &t, "a statement begins with a word");
    std::string word = upper_of(t);
    if (const auto other = s.synonyms.find(word); other != s.synonyms.end()) {
        if (other->second.starts_with("$$")) return s.build.ignored(word, s.line.begin, s.line.end);
        word = other->second;
    }
    if (word != s.word_before) s.word_before = word, s.known = dialect::apt::find_major(word);
    const MajorWord* known = s.known;
    if (known == nullptr && dialect::apt::is_text(Major::text)) {
        // PPRINT-text and the like: the word runs into what follows
        for (const std::string_view head : {"PPRINT", "PARTNO", "INSERT"})
            if (word.starts_with(head) && !s.line.tokens.empty()) {
                known = dialect::apt::find_major(head);
                s.line.tokens.front().end = s.line.tokens.front().begin + static_cast<std::uint32_t>(head.size());
            }
    }
    if (s.line.too_long && (known == nullptr || !dialect::apt::is_text(known->major))) return say_too_long(s);
    if (known == nullptr || (!dialect::apt::is_text(known->major) && assigns(s.line) && known->major != Major::apt_arc))
        return read_unknown(s, t, word);
    const Arguments a = arguments(s.line);
    const Token* foreign = takes_anything(known->major) ? nullptr : out_of_form(s.line, t, a);
    if (foreign != nullptr)
        return fail(s, foreign,
                    "behind " + word + " a slash is due, and words and numbers with one comma between them");
    read_known(s, *known, a);
}

}  // namespace obrys::read::apt
