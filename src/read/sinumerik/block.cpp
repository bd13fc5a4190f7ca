#include "read/sinumerik/block.hpp"

#include "read/sinumerik/call.hpp"
#include "read/sinumerik/expression.hpp"
#include "read/sinumerik/statement.hpp"
#include "read/sinumerik/word.hpp"

namespace obrys::read::sinumerik {

namespace words = dialect::sinumerik;
using words::Use;

namespace {

/// `/` and `/0` … `/9`.
void read_skip_sign(State& s) {
    Cursor& c = s.cursor;
    if (!c.take('/')) return;
    s.skip = 1;
    if (base::is_digit(c.peek()) && !base::is_digit(c.peek(1))) s.skip = static_cast<std::uint8_t>(*c.p++ - '0' + 1);
}

/// `N10`, `:10`.
bool read_block_number(State& s) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    const char first = base::upper(c.peek());
    if ((first != 'N' && first != ':') || !base::is_digit(c.peek(1))) return false;
    const char* q = c.p + 1;
    while (q < c.end && base::is_digit(*q)) ++q;
    const std::string_view name = c.name();
    if (first == 'N' && s.odd_names && s.is_variable(base::to_upper(name))) return false;
    c.p = q;
    return true;
}

/// `NAME:`; several may follow each other.
bool read_label(State& s) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    const std::string_view name = c.name();
    if (name.empty()) return false;
    const char* q = c.p + name.size();
    while (q < c.end && base::is_blank(*q)) ++q;
    if (q == c.end || *q != ':' || (q + 1 < c.end && q[1] == '=')) return false;
    s.unit.labels[intern(s, name)].push_back(static_cast<std::uint32_t>(s.unit.statements.size()));
    c.p = q + 1;
    return true;
}

/// AX1, MX1: names that controls as delivered and many builders give to machine axes.
bool is_machine_axis(std::string_view upper) {
    const bool axis = upper.starts_with("AX") && upper.size() > 2;
    const bool built = upper.size() > 2 && upper[0] == 'M' && std::string_view("XYZABCUVW").find(upper[1]) < 9;
    return (axis || built) && upper.size() <= 4 && upper.find_first_not_of("0123456789", 2) == std::string_view::npos;
}

void read_name(State& s, std::string_view name) {
    const std::string upper = base::to_upper(name);
    const char* behind = s.cursor.p + name.size();
    while (behind < s.cursor.end && base::is_blank(*behind)) ++behind;
    const char next = behind < s.cursor.end ? *behind : '\0';
    const bool assigns = next == '[' || (next == '=' && (behind + 1 == s.cursor.end || behind[1] != '='));
    const words::Entry* entry = words::find_word(upper);
    if (next == '=' && is_machine_axis(upper) && !s.is_variable(upper)) return read_machine_axis(s, name.size());
    if (assigns && (entry == nullptr || s.is_variable(upper))) return read_assignment(s);
    if (entry == nullptr) {
        if (next == '(' || s.items == 0) return read_call(s, s.cursor.p, s.cursor.p + name.size());
        return read_unknown(s);
    }
    switch (entry->use) {
        case Use::statement: return read_statement(s, static_cast<words::Keyword>(entry->value), name.size());
        case Use::procedure: return read_procedure(s, static_cast<program::Procedure>(entry->value), name.size());
        case Use::control_cycle: return read_control_cycle(s, *entry, name.size());
        case Use::frame: return read_frame(s, *entry, name.size());
        default: return read_table_word(s, *entry, name.size());
    }
}

/// `RND2` where `RND=2` is meant: a bare name of the tables with digits behind it.
bool complain_about_missing_sign(State& s, std::string_view name) {
    const std::size_t digits = name.find_first_of("0123456789");
    if (digits == std::string_view::npos || digits < 2) return false;
    if (name.find_first_not_of("0123456789", digits) != std::string_view::npos) return false;
    const auto* entry = words::find_word(base::to_upper(name.substr(0, digits)));
    if (entry == nullptr || entry->use != Use::address || words::find_word(base::to_upper(name)) != nullptr)
        return false;
    const char* behind = s.cursor.p + name.size();
    while (behind < s.cursor.end && base::is_blank(*behind)) ++behind;
    if (behind < s.cursor.end && (*behind == '=' || *behind == '(' || *behind == '[')) return false;
    const char* end = s.cursor.p + name.size();
    if (end < s.cursor.end && *end == '.')  // the name ends at the point, the value does not
        while (++end < s.cursor.end && base::is_digit(*end)) {
        }
    const std::string word(entry->name), value(name.data() + digits, end);
    fail(s, s.cursor.p, end, word + " needs '=' in front of its value", "write " + word + "=" + value);
    return true;
}

/// A variable called like a word (F1, D1W) that is written to here: `F1=` and `F1[`. F1 alone stays the feed.
bool is_odd_variable(State& s, std::string_view name) {
    if (!s.odd_names || name.size() == 1 || !s.is_variable(base::to_upper(name))) return false;
    Cursor behind = s.cursor;
    behind.p += name.size();
    return behind.at_assignment() || behind.take('[');
}

/// Several conditional jumps may follow each other in a block.
bool is_next_condition(const State& s) {
    const program::Statement& last = s.unit.statements.back();
    return last.kind == program::StatementKind::jump && s.unit.jumps.back().condition != program::no_expr &&
           base::equals_ignoring_case(s.cursor.name(), "IF");
}

/// Words behind a jump, call or structure word would never be run, or run behind the return (NC programming 12/2019,
/// "Program jumps", "Subprogram call": they stand in a block of their own).
void refuse_rest(State& s) {
    const char* from = s.cursor.p;
    skip_line(s);
    fail(s, from, s.cursor.p, "this stands behind a jump, a call or a structure word, which needs a block of its own",
         "write it in a block before or behind it");
}

void read_item(State& s) {
    Cursor& c = s.cursor;
    if (s.block_of_its_own && !is_next_condition(s)) return refuse_rest(s);
    const char first = *c.p;
    if (first == '$') return read_assignment(s);
    const std::string_view name = c.name();
    if (name.empty()) {
        const unsigned char byte = static_cast<unsigned char>(first);
        if (byte < 0x20) return fail_here(s, "a control character stands in the block", "remove it");
        return fail_here(s, "unexpected " + here(s), byte >= 0x80 ? "put comments behind ';'" : "");
    }
    const bool word_like = name.size() == 1 ? first != '_' : base::is_digit(name[1]) && first != '_';
    if (word_like && !is_odd_variable(s, name)) return read_address(s);
    if (complain_about_missing_sign(s, name)) return;
    read_name(s, name);
}

/// `%`, `%MPF100`: how programs on tape begin. Nothing to run.
bool read_tape_header(State& s) {
    Cursor c = s.cursor;
    if (!c.take('%')) return false;
    while (is_name_part(c.peek())) ++c.p;
    const char* end = c.p;
    if (!c.at_end()) return false;
    add_ignored(s, s.cursor.p, end);
    return true;
}

void begin_line(State& s) {
    s.failed = s.failure_kept = s.line_has_statement = s.block_open = s.declares = s.block_of_its_own = false;
    s.skip = 0;
    s.items = 0;
}

}  // namespace

void read_line(State& s) {
    begin_line(s);
    Cursor& c = s.cursor;
    c.skip_blanks();
    const bool has_text = !c.at_end();
    if (!has_text) return;
    Expanded expanded;
    s.line_begin = c.from(c.p);
    if (!s.macros.empty() && expand(s, expanded)) {
        c = Cursor(expanded);
        c.skip_blanks();
    }
    if (read_tape_header(s)) return;
    read_skip_sign(s);
    if (read_block_number(s) && s.skip == 0) read_skip_sign(s);
    bool labelled = false;
    while (read_label(s)) labelled = true;
    while (!s.failed && !c.at_end()) read_item(s);
    if (s.failed) keep_failure(s);
    if (!s.line_has_statement && (labelled || !s.declares)) open_block(s, c.p);
    close_block(s);
    c = Cursor(s.text.data(), s.line_begin, s.line_begin);
}

void label_block_numbers(State& s) {
    for (std::uint32_t i = 0; i < s.unit.statements.size(); ++i) {
        const program::Statement& statement = s.unit.statements[i];
        if ((statement.flags & program::line_start) == 0) continue;
        Cursor c(s.text.data(), statement.begin, s.unit.end);
        if (c.take('/') && base::is_digit(c.peek())) ++c.p;
        c.skip_blanks();
        if (base::upper(c.peek()) != 'N' && c.peek() != ':') continue;
        const char* q = c.p + 1;
        while (q < c.end && base::is_digit(*q)) ++q;
        if (q == c.p + 1) continue;
        std::string name(c.p, q);
        name[0] = 'N';
        s.unit.labels[s.names.id(name)].push_back(i);
    }
}

}  // namespace obrys::read::sinumerik
