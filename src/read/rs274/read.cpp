#include "read/rs274/read.hpp"

#include <algorithm>

#include "dialect/rs274/linuxcnc.hpp"
#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

/// The text without what an old editor left on lines of its own behind the last one: M2 has ended the program before
/// LinuxCNC comes to them. Beside a word such a sign is a fault there.
std::string_view text_of(const base::Source& source) {
    const std::string_view text = base::without_end_signs(source.text);
    const std::size_t last = text.find_last_not_of(" \t");
    return last == std::string_view::npos || text[last] == '\n' ? text : source.text;
}

bool is_percent(const State& s) { return s.line.rest() == "%"; }

void complain_about_comment(State& s) {
    const bool nested = s.line.fault() == CommentFault::nested;
    const std::uint32_t at = s.line.fault_begin();
    fail(s, at, at + 1, nested ? "a comment stands within a comment" : "this comment is not closed",
         nested ? "end the first one in front of it" : "add )");
}

/// The first block behind the `%` that ends the text: LinuxCNC does not come to it.
void say_behind_percent(State& s) {
    Part& main = s.parts.front();
    for (std::size_t at = s.line.end(); at < s.text.size() && !main.told_unreached;) {
        const std::size_t end = std::min(s.text.find('\n', at), s.text.size());
        const std::string_view line = base::trim(s.text.substr(at, end - at));
        const std::size_t begin = static_cast<std::size_t>(line.data() - s.text.data());
        at = end + 1;
        const bool prose = line.size() > 1 && base::is_letter(line[0]) && base::is_letter(line[1]);
        if (line.empty() || line[0] == '%' || line[0] == '(' || line[0] == ';' || prose) continue;
        main.told_unreached = true;
        base::Diagnostic d;
        d.code = base::codes::not_run;
        d.severity = base::Severity::warning;
        d.where = {s.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + line.size())};
        d.text = "this block stands behind the % that ends the program and is never run";
        d.remedy = "take the % out, or this block and those behind it";
        s.diagnostics.add(std::move(d));
    }
}

/// The last `%`: the text ends here.
void read_percent(State& s) {
    if (s.percent || !s.variant.percent_needs_begin) {
        say_behind_percent(s);
        s.stopped = true;
        return;
    }
    if (s.part->ended) return;
    fail(s, s.line.begin(), s.line.end(), "a % at the end needs one at the begin of the program");
    s.stopped = true;
}

void read_line(State& s) {
    s.failed = false;
    begin_words(s);
    if (s.line.at_end()) return;
    if (is_percent(s)) return read_percent(s);
    if (!s.part->ended && is_too_long(s)) return;
    if (s.line.fault() != CommentFault::none && !s.part->ended) return complain_about_comment(s);
    read_block_head(s);
    if (s.failed) return;
    if (s.variant.o_words && s.line.peek() == 'O') return read_o_line(s);
    if (s.part->ended) return say_unreached(s);
    const int call = s.variant.o_words ? call_number(s) : 0;
    if (call == 98) return read_m98(s);
    if (call == 99) return read_m99(s);
    read_words(s);
    if (!s.failed) check_block(s);
    emit_block(s);
    for (const std::uint16_t m : s.facts.m) note_end(s, m);
}

/// The first line, where it is `%`: byte behind it.
std::uint32_t skip_percent(State& s) {
    std::size_t i = 0;
    while (i < s.text.size() && (base::is_blank(s.text[i]) || s.text[i] == '\n' || s.text[i] == '\r')) ++i;
    const std::size_t line_end = std::min(s.text.find('\n', i), s.text.size());
    if (base::trim(s.text.substr(i, line_end - i)) != "%") return 0;
    s.percent = true;
    return static_cast<std::uint32_t>(line_end);
}

/// Without M2, M30 or `%` LinuxCNC complains when it comes to the end of the text; M2 may stand in a branch, too.
void note_missing_end(State& s) {
    Part& main = s.parts.front();
    if (main.ended || s.stopped || !s.variant.end_is_due) return;
    main.unit.unended =
        s.percent ? "the program ends without M2, M30 or its second %" : "the program ends without M2 or M30";
}

void read_numbered_program(State& s, const ProgramNumber& n) {
    Part& part = s.add_part(n.after_end ? s.diagnostics : s.repeated);
    part.kind = Part::Kind::program_number;
    part.label = n.label;
    part.unit.name = "O" + n.label;
    part.unit.begin = n.begin;
    part.unit.startable = n.after_end;
    s.part = &part;
    s.stopped = false;
    s.sources.fetch(s.file);
    read_lines(s, n.behind);
    end_text(s);
    part.unit.end = std::max(n.behind, s.line.end());
}

/// `O1234` … `M99` as programs of their own, where something may call them.
void read_numbered_programs(State& s, const std::string& file_stem) {
    const std::vector<ProgramNumber> numbers = s.numbers;
    std::set<std::string> known = s.subs;
    std::size_t calls = 0;
    do {  // reading one may show calls of others
        calls = s.called_numbers.size();
        for (const ProgramNumber& n : numbers) {
            const bool wanted = n.after_end || s.calls_any_number || s.called_numbers.contains(n.label) ||
                                file_stem == n.label || file_stem == "O" + n.label;
            if (wanted && known.insert(n.label).second) read_numbered_program(s, n);
        }
    } while (calls != s.called_numbers.size());
}

}  // namespace

void say_unreached(State& s) {
    Part& main = *s.part;
    if (main.kind != Part::Kind::main || main.told_unreached || !s.numbers.empty() || s.line.at_end()) return;
    if (s.line.peek() == '(' || s.line.peek() == ';') return;
    main.told_unreached = true;
    base::Diagnostic d;
    d.code = base::codes::not_run;
    d.severity = base::Severity::warning;
    d.where = {s.file, s.line.begin(), s.line.end()};
    d.text = "this block and those behind it are never run: the program ends before them";
    d.remedy = "take that end out, or these blocks";
    s.diagnostics.add(std::move(d));
}

void read_lines(State& s, std::uint32_t from) {
    const char* begin = s.text.data();
    const char* p = begin + from;
    const char* end = begin + s.text.size();
    const char* aside = p;
    const auto done = [&] { return s.stopped || (s.part->ended && s.part->kind == Part::Kind::program_number); };
    while (p < end && !done()) {
        if (p - aside > static_cast<std::ptrdiff_t>(base::Store::piece)) {
            s.sources.lay_aside(s.file, static_cast<std::uint32_t>(p - begin));
            aside = p;
        }
        if (*p == '\n' || *p == '\r' || base::is_blank(*p)) {
            ++p;
            continue;
        }
        if (!s.part->ended) {
            if (const char* behind = read_literal_block(s, p, end); behind != nullptr) {
                p = behind;
                continue;
            }
        }
        const char* line_end = std::find(p, end, '\n');
        s.line.load(s.text, static_cast<std::uint32_t>(p - begin), static_cast<std::uint32_t>(line_end - begin),
                    s.variant.nested_comments, s.variant.semicolon_comment);
        read_line(s);
        p = line_end;
    }
}

std::vector<program::Unit> read_linuxcnc(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                         base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    State s(file, dialect::rs274::linuxcnc, names, diagnostics, sources);
    s.text = text_of(source);
    s.part = &s.add_part(diagnostics);
    s.part->unit.name = base::to_upper(base::stem(source.name));
    s.part->unit.end = static_cast<std::uint32_t>(source.text.size());
    s.part->unit.reserve(s.text.size());
    read_lines(s, skip_percent(s));
    end_text(s);
    note_missing_end(s);
    read_numbered_programs(s, s.parts.front().unit.name);
    check_styles(s);
    sources.lay_aside(file, static_cast<std::uint32_t>(s.text.size()));
    std::vector<program::Unit> units;
    for (Part& part : s.parts)
        if (!part.dropped) units.push_back(std::move(part.unit));
    return units;
}

}  // namespace obrys::read::rs274
