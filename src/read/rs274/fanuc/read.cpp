#include "read/rs274/fanuc/read.hpp"

#include <algorithm>

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using dialect::rs274::FanucMachine;

namespace {

std::size_t line_end(std::string_view text, std::size_t at) {
    while (at < text.size() && text[at] != '\n' && text[at] != '\r') ++at;
    return std::min(at, text.size());
}

/// Length of `O1234`, `:1234`, `ONAME`, `<NAME>` at the begin of a line without blanks in front; 0 where none stands
/// there.
std::size_t header_length(std::string_view line) {
    if (line.size() < 2) return 0;
    if (line[0] == '<') {  // <NAME>, series 30i and 0i-F
        const std::size_t end = line.find('>');
        return end == std::string_view::npos || end == 1 ? 0 : end + 1;
    }
    if (base::upper(line[0]) != 'O' && line[0] != ':') return 0;
    std::size_t n = 1;
    while (n < line.size() &&
           (base::is_digit(line[n]) || (line[0] != ':' && base::is_letter(line[n])) || (n > 1 && line[n] == '_')))
        ++n;
    return n > 1 ? n : 0;
}

/// "O12" of `O0012` and `:0012`.
std::string program_name(std::string_view header) {
    if (header[0] == '<') return base::to_upper(header.substr(1, header.size() - 2));
    std::string_view rest = header.substr(1);
    const bool number = rest.find_first_not_of("0123456789") == std::string_view::npos;
    while (number && rest.size() > 1 && rest[0] == '0') rest.remove_prefix(1);
    return "O" + base::to_upper(rest);
}

bool looks_like_block(std::string_view line) {
    if (!line.empty() && line[0] == '/') line.remove_prefix(1);
    if (line.size() < 2) return false;
    return line[0] == '#' ||
           (base::is_letter(line[0]) &&
            (base::is_digit(line[1]) || std::string_view("+-.#[").find(line[1]) != std::string_view::npos));
}

/// The part of a text between its `%` signs, or behind the leader in front of the first program.
struct Extent {
    std::size_t begin = 0, end = 0;
    bool has_sign = false;    ///< `%` at its begin
    bool has_leader = false;  ///< text stands in front of it
    bool has_rest = false;    ///< and behind it
};

/// What the lines in front of a `%` were.
struct LinesBefore {
    bool any = false, blocks = false;
    bool program = false;  ///< a program's number or its end stands there: the sign ends it
};

bool ends_program(std::string_view line) {
    const std::string upper = base::to_upper(line);
    for (const std::string_view word : {"M30", "M2", "M02", "M99"})
        if (const std::size_t at = upper.find(word);
            at != std::string::npos && (at + word.size() == upper.size() || !base::is_digit(upper[at + word.size()])))
            return true;
    return false;
}

/// Position of the first header of a program behind `at`; npos where none stands there.
std::size_t find_header(std::string_view text, std::size_t at) {
    while (at < text.size()) {
        const std::size_t end = line_end(text, at);
        std::string_view line = base::trim(text.substr(at, end - at));
        if (!line.empty() && line[0] == '%') line = base::trim(line.substr(1));
        if (header_length(line) > 0) return at;
        at = end + 1;
    }
    return std::string_view::npos;
}

/// Begin of the line from `at` on in which the next `%` stands; the text's end where there is none.
std::size_t next_sign_line(std::string_view text, std::size_t at) {
    std::size_t sign = std::min(text.find('%', at), text.size());
    if (sign == text.size()) return sign;
    while (sign > at && text[sign - 1] != '\n' && text[sign - 1] != '\r') --sign;
    return sign;
}

/// Of the text from `from` on.
Extent extent_of(std::string_view text, std::size_t from) {
    Extent e{from, text.size(), false, false, false};
    std::size_t header = std::string_view::npos;
    LinesBefore before;
    for (std::size_t at = from; at < text.size();) {
        if (before.program && before.blocks) at = next_sign_line(text, at);
        const std::size_t end = line_end(text, at);
        const std::string_view line = base::trim(text.substr(at, end - at));
        if (!line.empty() && line[0] == '%') {
            const bool more = text.find_first_not_of(" \t\r\n%", end) != std::string_view::npos;
            const bool same_line = header_length(base::trim(line.substr(1))) > 0;  // %O1234
            const bool leader =
                !before.blocks || (!before.program && (same_line || find_header(text, end) != std::string_view::npos));
            if (e.has_sign || !(more || same_line) || !leader) {
                e.end = at;
                e.has_rest = more;
                break;
            }
            e.begin = same_line ? text.find('%', at) + 1 : end;
            e.has_sign = true;
            e.has_leader = before.any;
            header = std::string_view::npos;
            before = {};
        } else if (!line.empty()) {
            if (header == std::string_view::npos && header_length(line) > 0 && !before.blocks && before.any &&
                !e.has_sign)
                header = at;
            before.program = before.program || header_length(line) > 0 || ends_program(line);
            before.blocks = before.blocks || looks_like_block(line);
            before.any = true;
        }
        at = end + 1;
    }
    if (!e.has_sign && header != std::string_view::npos) {
        e.begin = header;
        e.has_leader = true;
    }
    return e;
}

void note(FanucState& s, std::size_t begin, std::size_t end, std::string_view code, std::string text) {
    base::Diagnostic d;
    d.severity = base::Severity::note;
    d.code = code;
    d.where = {s.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    d.text = std::move(text);
    s.diagnostics.add(std::move(d));
}

/// Blocks behind the last `%` are never run; other text says nothing to the control.
void note_rest(FanucState& s, const Extent& e) {
    for (std::size_t at = line_end(s.text, e.end) + 1; at < s.text.size(); at = line_end(s.text, at) + 1) {
        const std::size_t end = line_end(s.text, at);
        if (!looks_like_block(base::trim(std::string_view(s.text).substr(at, end - at)))) continue;
        base::Diagnostic d;
        d.severity = base::Severity::warning;
        d.code = base::codes::not_run;
        d.where = {s.file, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)};
        d.text = "this block stands behind the % that ends the program and is never run";
        d.remedy = "take the % out, or these blocks; a further program begins with its number (O2)";
        return s.diagnostics.add(std::move(d));
    }
    note(s, e.end, line_end(s.text, e.end), base::codes::no_effect, "the text behind the last % is not read");
}

void note_extent(FanucState& s, const Extent& e) {
    if (!e.has_sign)
        note(s, e.begin, e.begin, base::codes::assumption, "the program has no % at its begin: it begins here");
    if (e.has_leader)
        note(s, 0, std::min<std::size_t>(line_end(s.text, 0), e.begin), base::codes::no_effect,
             "the text in front of the program is not read");
    if (e.has_rest) note_rest(s, e);
}

void begin_program(FanucState& s, std::string name, std::size_t at) {
    const bool first = s.part == nullptr;
    if (s.part != nullptr) {
        close_program(s);
        s.unit().end = static_cast<std::uint32_t>(at);
    }
    s.part = &s.parts.emplace_back(s.file, s.variant, s.names, s.diagnostics, s.text);
    s.unit().name = std::move(name);
    s.unit().startable = true;
    s.unit().begin = s.unit().end = static_cast<std::uint32_t>(at);
    program::Modes modes = modes_at_start(s.control);
    // A subprogram's numbers in the unit that the text said before it need no question to the run where that holds.
    if (!first) modes[static_cast<std::size_t>(Mode::inch)] = s.modes.all()[static_cast<std::size_t>(Mode::inch)];
    s.unit().modes.begin = modes_at_start(s.control);
    s.unit().modes.reader = s.parts.front().unit.modes.reader;
    if (first) s.unit().modes.reader = reader_of_pieces(s);
    s.modes.begin_program(modes);
    s.plain.begin_program();
}

void due_program(FanucState& s, const base::Source& source, std::size_t at) {
    if (s.part != nullptr) return;
    begin_program(s, base::to_upper(base::stem(source.name)), at);
}

/// `[BILLET X100 Y50 Z20` in front of a program's first block. Behind it stands nothing but what the control reads: a
/// line in brackets may be a condition there.
bool is_for_simulator(const FanucState& s, std::string_view line) {
    if (line[0] != '[' || (s.part != nullptr && !s.unit().statements.empty())) return false;
    const std::string upper = base::to_upper(line.substr(1, 10));
    for (const std::string_view word : {"BILLET", "EDGEMOVE", "TOOLDEF"})
        if (upper.starts_with(word) && !base::is_letter(upper[std::min(word.size(), upper.size() - 1)])) return true;
    return false;
}

/// A block without line end and `;`: a program's number, or what the control is to do.
void read_piece(FanucState& s, const base::Source& source, std::size_t begin, std::size_t end) {
    while (begin < end && base::is_blank(s.text[begin])) ++begin;
    const std::string_view piece = s.text.substr(begin, end - begin);
    if (const std::size_t n = header_length(piece); n > 0) {
        begin_program(s, program_name(piece.substr(0, n)), begin);
        begin += n;
    }
    if (base::trim(s.text.substr(begin, end - begin)).empty()) return;
    if (is_for_simulator(s, s.text.substr(begin, end - begin)))
        return note(s, begin, end, base::codes::no_effect, "a line for a simulator, not for the control, is not read");
    due_program(s, source, begin);
    read_fanuc_block(s, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
}

/// `;` ends a block as the line's end does.
void read_line(FanucState& s, const base::Source& source, std::size_t begin, std::size_t end) {
    bool comment = false;
    std::size_t from = begin;
    for (std::size_t i = begin; i < end; ++i) {
        const char c = s.text[i];
        if (c == '(') comment = true;
        if (c == ')') comment = false;
        if (c != ';' || comment) continue;
        read_piece(s, source, from, i);
        from = i + 1;
    }
    read_piece(s, source, from, end);
}

/// A line that begins at `at`; the place behind its words, before its end. `block` is room for it.
std::size_t read_next_line(FanucState& s, const base::Source& source, std::size_t at, std::size_t most,
                           PlainBlock& block) {
    const bool plain = s.part != nullptr && scan_plain_block(s.text, at, most, s.control.is_lathe(), block);
    if (plain && s.plain.add(s, block)) return block.end;
    const std::size_t end = std::min(line_end(s.text, at), most);
    if (at == end) return end;
    const PlainBlocks::Before before = plain ? PlainBlocks::before(s) : PlainBlocks::Before{};
    read_line(s, source, at, end);
    if (plain) s.plain.learn(s, block, before);
    return end;
}

/// All programs of the text, between as many pairs of `%` as there are; the last part.
Extent read_extents(FanucState& s, const base::Source& source) {
    const std::string_view text = base::without_end_signs(s.text);
    Extent e = extent_of(text, 0);
    PlainBlock block;
    for (bool first = true;; first = false) {
        const bool goes_on = e.has_rest && find_header(text, e.end) != std::string_view::npos;
        Extent said = e;
        said.has_rest = e.has_rest && !goes_on;
        said.has_sign = said.has_sign || !first;
        note_extent(s, said);
        for (std::size_t at = e.begin; at < e.end;)
            at = line_end(text, read_next_line(s, source, at, e.end, block)) + 1;
        if (!goes_on) return e;
        e = extent_of(text, e.end);
    }
}

FanucControl control_of(const FanucOptions& options, const MachineByText& guessed, bool haas) {
    FanucControl c;
    c.haas = haas;
    c.machine = options.machine.value_or(guessed.machine);
    c.system = options.system;
    c.whole_numbers = options.whole_numbers;
    return c;
}

std::vector<program::Unit> read_text(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                     base::Diagnostics& diagnostics, const FanucOptions& options, bool haas) {
    const base::Source& source = sources[file];
    const MachineByText guessed = options.machine ? MachineByText{} : guess_machine(source.text, file);
    const FanucControl control = control_of(options, guessed, haas);
    FanucState s(file, control, names, diagnostics, sources);
    s.system = system_parameter;
    s.whole_number_said = options.whole_numbers_known;
    s.draws = control.is_lathe() && uses_line_angles(s.text);
    s.c_is_axis = options.c_axis ? *options.c_axis : control.is_lathe() && uses_c_axis(s.text);
    s.corner_said = options.c_axis.has_value();
    const Extent e = read_extents(s, source);
    due_program(s, source, e.begin);
    close_program(s);
    s.unit().end = static_cast<std::uint32_t>(std::max(e.end, std::size_t{s.unit().begin}));
    std::vector<program::Unit> units;
    for (Part& part : s.parts) {
        part.unit.machine_signs = guessed.signs;
        units.push_back(std::move(part.unit));
    }
    return units;
}

}  // namespace

std::vector<program::Unit> read_fanuc(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                      base::Diagnostics& diagnostics, const FanucOptions& options) {
    return read_text(file, sources, names, diagnostics, options, false);
}

std::vector<program::Unit> read_haas(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                     base::Diagnostics& diagnostics, const FanucOptions& options) {
    return read_text(file, sources, names, diagnostics, options, true);
}

std::vector<program::Unit> read_fanuc(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                      base::Diagnostics& diagnostics) {
    return read_fanuc(file, sources, names, diagnostics, FanucOptions{});
}

std::vector<program::Unit> read_haas(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                     base::Diagnostics& diagnostics) {
    return read_haas(file, sources, names, diagnostics, FanucOptions{});
}

}  // namespace obrys::read::rs274
