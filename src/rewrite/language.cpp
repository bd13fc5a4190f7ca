#include "rewrite/language.hpp"

#include <algorithm>
#include <array>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "shop/files/section.hpp"
#include "write/post.hpp"

namespace obrys::rewrite {

namespace {

namespace codes = base::codes;
using shop::Section;

struct KnownTable {
    std::string_view table;
    std::string_view keys;  ///< blanks between them
};
constexpr std::array known_tables{
    KnownTable{"expressions", "assign word word-computed"},
    KnownTable{"operators",
               "add subtract multiply divide integer-divide modulo equal not-equal less less-equal greater "
               "greater-equal and or not"},
    KnownTable{"functions",
               "sin cos tan asin acos asin-turn acos-turn atan atan2 atan2-turn angle-of sqrt abs square "
               "trunc round round-away round-up round-outwards round-down ln log10 exp min max bound fraction"},
    KnownTable{"parameters", "own declare"},
    KnownTable{
        "flow",
        "file-begin file-end main-begin main-start main-end sub-begin sub-end label jump jump-if jump-equal "
        "jump-not-equal jump-greater jump-less if else end-if while end-while "
        "repeat until again loop end-loop break call argument call-shared return end stop optional-stop alarm message "
        "comment "
        "repeat-section begin-anew by-reference"},
    KnownTable{
        "words",
        "rapid linear machine-rapid machine-linear arc-cw arc-ccw arc-radius-cw arc-radius-ccw radius centre no-move "
        "plane-xy plane-zx plane-yz "
        "absolute incremental incremental-value incremental-letters per-minute per-rev surface revolutions spindle "
        "cw ccw spindle-stop tool tool-has-speed edge flood mist coolant-off comp-left comp-right comp-off "
        "comp-off-alone dwell datum length-on length-off speed-limit surface-limit round chamfer-leg chamfer "
        "centre-absolute "
        "arc-absolute-cw arc-absolute-ccw"},
    KnownTable{"frames", "shift shift-axis turn turn-off mirror mirror-off scale scale-off off"},
    KnownTable{"system",
               "tool-number tool-radius tool-edge feed spindle-speed table-length table-radius table-corner-radius "
               "table-delta-length table-delta-radius table-delta-corner"},
};

/// "Q0-99".
std::optional<Pool> pool_of(std::string_view text) {
    const std::size_t digits = text.find_first_of("0123456789"), dash = text.find('-', 1);
    if (digits == std::string_view::npos || dash == std::string_view::npos || dash < digits) return std::nullopt;
    const auto first = base::parse_integer(text.substr(digits, dash - digits)),
               last = base::parse_integer(text.substr(dash + 1));
    if (!first || !last || *first < 0 || *last < *first || *last > 1'000'000) return std::nullopt;
    return Pool{std::string(text.substr(0, digits)), static_cast<std::uint32_t>(*first),
                static_cast<std::uint32_t>(*last)};
}

/// Its other keys, and what is wrong in these, are of the post.
void read_zeros(const shop::Value& table, Language& l) {
    base::Diagnostics of_the_post;
    Section s(table, "[[datum]]", of_the_post);
    constexpr int most = 100'000;
    const auto first = s.integer("from", 0, most), less = s.integer("less", 0, most);
    const auto last = s.integer("to", 0, most);
    const std::optional<std::string> text = s.text("text");
    if (!first || !text || text->empty()) return;
    const auto number = [](std::int64_t n) { return static_cast<std::uint32_t>(n); };
    l.zeros.push_back({number(*first), number(last.value_or(*first)), number(less.value_or(0)), *text});
}

std::vector<Pool> pools_of(Section& s, std::string_view key) {
    std::vector<Pool> out;
    for (const shop::Value* v : s.text_values(key)) {
        if (auto pool = pool_of(v->text))
            out.push_back(std::move(*pool));
        else
            s.error(codes::job_value, v->where, "'" + v->text + "' is no range of parameters", "as Q0-99");
    }
    return out;
}

/// "A1 B2 C3 …".
void read_arguments(Section& s, Language& l) {
    const std::string text = s.text("arguments").value_or("");
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        if (const auto n = base::parse_integer(std::string_view(text).substr(at + 1, end - at - 1)); n && *n > 0) {
            l.arguments += text[at];
            l.argument_numbers.push_back(static_cast<std::uint32_t>(*n));
        } else {
            s.error(codes::job_value, place(s, "arguments"), "an argument is a letter and the number that it sets");
        }
        at = end + 1;
    }
}

void read_switches(Section& s, std::string_view table, Language& l) {
    if (table == "expressions") {
        const std::string brackets = s.text("brackets").value_or("()");
        if (brackets.size() != 2) s.error(codes::job_value, place(s, "brackets"), "'brackets' are two signs");
        if (brackets.size() == 2) l.open = brackets.substr(0, 1), l.close = brackets.substr(1);
        l.point = s.boolean("point").value_or(false);
        l.sign = s.boolean("sign").value_or(false);
        l.computes = s.boolean("computes").value_or(true);
    } else if (table == "parameters") {
        l.global = pools_of(s, "global"), l.local = pools_of(s, "local");
        l.shift = static_cast<std::uint32_t>(s.integer("shift", 0, 100'000).value_or(0));
        if (const auto at = s.choice("place", {"file", "program", "name"}))
            l.local_place = static_cast<LocalPlace>(*at);
        read_arguments(s, l);
    } else if (table == "flow") {
        l.subs_first = s.boolean("subs-first").value_or(false);
        l.numbered_labels = s.choice("labels", {"names", "numbers"}).value_or(0) == 1;
        l.numbered_programs = s.choice("programs", {"names", "numbers"}).value_or(0) == 1;
        l.end_stops_all = s.boolean("end-stops-all").value_or(true);
        constexpr int most_characters = 200;
        const auto longest = [&](std::string_view key) {
            return static_cast<std::size_t>(s.integer(key, 8, most_characters).value_or(0));
        };
        l.longest_label = longest("longest-label"), l.longest_program = longest("longest-program");
        l.longest_variable = longest("longest-variable");
        l.kept_names = s.texts("kept-names");
        l.step = static_cast<int>(s.integer("step", 0, 1000).value_or(0));
    } else if (table == "frames") {
        l.frames_together = s.boolean("together").value_or(false);
        l.shift_before_turn = s.boolean("shift-before-turn").value_or(false);
    } else if (table == "words") {
        l.across = s.boolean("across").value_or(false);
        l.corner_beside = s.boolean("corner-beside").value_or(true);
        l.feed_ends_surface = s.boolean("feed-ends-surface").value_or(false);
    }
}

std::string lines_of(Section& s, std::string_view key) {
    std::string joined;
    for (const std::string& text : s.texts(key)) joined += (joined.empty() ? "" : "\n") + text;
    return joined;
}

/// How texts are written; the tables are the post's.
void read_texts(Section& file, Language& l) {
    base::Diagnostics of_the_post;
    if (const shop::Entry* e = file.sub_table("text")) {
        Section s(e->value, "[text]", of_the_post);
        l.comments = write::comment_rules(s);
    }
    if (const shop::Entry* e = file.sub_table("file")) {
        Section s(e->value, "[file]", of_the_post);
        l.encoding = write::encoding_of(s);
    }
    if (const shop::Entry* e = file.sub_table("path")) {
        Section s(e->value, "[path]", of_the_post);
        for (const std::string_view key : {"exact", "exact-stop", "free"})
            if (const std::string text = lines_of(s, key); !text.empty() && text.find('{') == std::string::npos)
                l.texts["path." + std::string(key)] = text;
    }
}

void read_table(Section& file, const KnownTable& known, Language& l) {
    const shop::Entry* entry = file.sub_table(known.table);
    if (entry == nullptr) return;
    Section s(entry->value, "[" + std::string(known.table) + "]", file.diagnostics());
    read_switches(s, known.table, l);
    for (std::size_t at = 0; at < known.keys.size();) {
        const std::size_t end = std::min(known.keys.find(' ', at), known.keys.size());
        const std::string_view key = known.keys.substr(at, end - at);
        at = end + 1;
        const shop::Entry* e = shop::find(s.table(), key);
        if (e == nullptr) continue;
        if (e->value.kind != shop::ValueKind::text && e->value.kind != shop::ValueKind::array) continue;
        l.texts[std::string(known.table) + "." + std::string(key)] = lines_of(s, key);
    }
    s.finish();
}

void read_cycle_program(Section& s, Language& l) {
    const std::string name = s.text("kind").value_or("");
    const auto kind = cl::cycle_kind_spelt(name);
    if (!kind) return s.error(codes::job_value, place(s, "kind"), "'" + name + "' is no kind of cycle");
    CycleProgram& p = l.cycles[*kind];
    p.call = s.text("call").value_or("");
    p.feed = s.text("feed").value_or("");
    p.away = s.text("away").value_or("");
    p.text = lines_of(s, "program");
    for (const std::string_view key : {"call", "program"})
        if (shop::find(s.table(), key) == nullptr) s.missing(key);
    s.finish();
}

}  // namespace

std::string filled(std::string_view text, const Places& places) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = std::min(text.find('{', at), text.size());
        out += text.substr(at, open - at);
        if (open == text.size()) break;
        const std::size_t close = std::min(text.find('}', open), text.size() - 1);
        const std::string_view name = text.substr(open + 1, close - open - 1);
        for (const auto& [key, value] : places)
            if (key == name) out += value;
        at = close + 1;
    }
    return out;
}

std::optional<Language> read_language(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics,
                                      const write::LoadText& load) {
    base::Sources texts;
    const auto root = write::whole_post(file, sources, texts, diagnostics, load);
    if (!root) return std::nullopt;
    base::Diagnostics own;
    Language l;
    Section section(*root, "the post", own);
    l.control = section.text("control").value_or("");
    for (const KnownTable& known : known_tables) read_table(section, known, l);
    for (const shop::Value* table : section.tables("cycle-program")) {
        Section s(*table, "[[cycle-program]]", own);
        read_cycle_program(s, l);
    }
    for (const shop::Value* table : section.tables("datum")) read_zeros(*table, l);
    read_texts(section, l);
    for (const base::Diagnostic& d : own.all()) diagnostics.add(d);
    if (own.has_errors()) return std::nullopt;
    const bool has_statements = section.boolean("statements").value_or(true);
    if (has_statements && l.has("expressions.assign") && l.has("flow.end")) return l;
    base::Diagnostic d;
    d.code = codes::job_value;
    d.where = {file, 0, 0};
    d.text = has_statements
                 ? "this post has no tables [expressions] and [flow]: it cannot keep the structure of a program"
                 : "this post writes no statements: those of the post that it extends are of another language";
    d.remedy = has_statements ? "extend a shipped post that has them, or translate without --keep"
                              : "take the post that it extends, or translate without --keep";
    diagnostics.add(std::move(d));
    return std::nullopt;
}

}  // namespace obrys::rewrite
