#pragma once
/// What the parts of the reader share: the line at hand, the unit that grows, and how a complaint is made.

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/codes.hpp"
#include "base/diagnostic.hpp"
#include "base/text.hpp"
#include "program/builder.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::read::sinumerik {

[[nodiscard]] constexpr bool is_name_start(char c) { return base::is_letter(c) || c == '_'; }
[[nodiscard]] constexpr bool is_name_part(char c) { return base::is_letter(c) || base::is_digit(c) || c == '_'; }

/// A line with its macros replaced, and for each of its bytes where that came from.
struct Expanded {
    std::string text;
    std::vector<std::uint32_t> from, to;  ///< source bytes [from, to) that a byte of `text` stands for
};

/// One line while it is read; `end` lies behind its last byte (line end and ^Z left out).
class Cursor {
public:
    Cursor() = default;
    Cursor(const char* source, std::uint32_t first, std::uint32_t last)
        : base_(source), p(source + first), end(source + last) {}
    explicit Cursor(const Expanded& line)
        : base_(line.text.data()), map_(&line), p(line.text.data()), end(p + line.text.size()) {}

    /// Byte in the source text of a place at or before `end`, as the begin of a span; and as its end.
    [[nodiscard]] std::uint32_t from(const char* at) const;
    [[nodiscard]] std::uint32_t to(const char* at) const;

    [[nodiscard]] char peek(std::ptrdiff_t k = 0) const { return end - p > k ? p[k] : '\0'; }
    void skip_blanks() {
        while (p < end && base::is_blank(*p)) ++p;
    }
    /// Skips blanks; true at the line's end or at its comment.
    bool at_end() {
        skip_blanks();
        return p == end || *p == ';';
    }
    /// The identifier here, without taking it; empty where none begins.
    [[nodiscard]] std::string_view name() const;
    /// Takes `c` if it stands here, behind blanks or not; else nothing moves.
    bool take(char c) {
        const char* q = p;
        while (q < end && base::is_blank(*q)) ++q;
        if (q == end || *q != c) return false;
        p = q + 1;
        return true;
    }
    /// Takes `=` (blanks in front of it too) where it is no `==`.
    bool take_assignment() {
        const char* back = p;
        if (take('=') && peek() != '=') return true;
        p = back;
        return false;
    }
    /// True where `=` stands here (behind blanks) and is no `==`.
    [[nodiscard]] bool at_assignment() const { return Cursor(*this).take_assignment(); }

private:
    const char* base_ = nullptr;
    const Expanded* map_ = nullptr;

public:
    const char* p = nullptr;
    const char* end = nullptr;
};

/// An opened IF, WHILE, … whose end has not come yet.
struct Opened {
    program::StatementKind kind;
    std::uint32_t statement = 0;  ///< the opener
    std::uint32_t else_statement = program::no_target;
    base::Span word;      ///< for the message where its end is missing
    bool broken = false;  ///< its head could not be read: an IF that is never true stands for it
};

struct State {
    program::Unit& unit;
    program::Names& names;
    base::Diagnostics& diagnostics;
    std::string_view text;  ///< the whole source text
    program::Builder build;
    Cursor cursor;

    std::uint32_t line_begin = 0;  ///< source byte of the line's first text
    bool failed = false;           ///< this line has been complained about
    bool failure_kept = false;     ///< … and has its unknown word in the tree
    bool line_has_statement = false;
    bool block_open = false;        ///< words go to the last statement
    std::uint8_t skip = 0;          ///< block skip level + 1
    bool declares = false;          ///< this line is PROC, EXTERN or DEFINE: no block of its own
    int operators = 0;              ///< of the expression at hand
    int items = 0;                  ///< words and statements read from this line so far
    bool block_of_its_own = false;  ///< a jump, call, RET or structure word stands in this line: nothing follows it
    base::Span failure{};
    std::string failure_text{};

    std::vector<Opened> opened{};
    std::unordered_map<std::string, std::string> macros{};  ///< text by name
    std::unordered_set<std::string> variables{};            ///< defined here by DEF or PROC
    std::unordered_set<std::string> strings{};              ///< those of type STRING
    bool odd_names = false;         ///< a variable or macro is called like a word, e.g. D1W or M6
    bool jumps_to_numbers = false;  ///< a jump names a block number or computes its destination

    [[nodiscard]] base::Span span(const char* from, const char* to) const {
        return {unit.file, cursor.from(from), cursor.to(to)};
    }
    [[nodiscard]] std::string line_text(const base::Span& where) const {
        return base::as_utf8(text.substr(where.begin, where.end - where.begin));
    }
    [[nodiscard]] bool is_variable(const std::string& upper) const {
        return !variables.empty() && variables.contains(upper);
    }
};

/// Complains once a line; the rest of the line is then left out.
void fail(State& s, const char* from, const char* to, std::string text, std::string remedy = {});
/// As above, for the thing that stands at the cursor (a name, a number, one sign, or the line's end).
void fail_here(State& s, std::string text, std::string remedy = {});
/// What stands at the cursor, as the programmer wrote it; "end of block" at the end.
[[nodiscard]] std::string here(State& s);

/// Puts the complaint into the tree as an unknown word, so that a run reports it too; once a line.
void keep_failure(State& s);

program::NameId intern(State& s, std::string_view name);
void note_variable(State& s, const std::string& upper, bool is_string);

// Statements and their words -----------------------------------------------------------------------------------------

/// A new statement that begins at `from`; the line's first one begins at the line's begin.
program::Statement& add_statement(State& s, program::StatementKind kind, const char* from);
/// A statement with one `control` word into its kind's table, ending at the cursor.
void add_control(State& s, program::StatementKind kind, std::size_t index, const char* from);
void open_block(State& s, const char* from);
void close_block(State& s);
void add_word(State& s, program::Code code, program::Form form, std::int32_t payload, const char* from);
void add_problem(State& s, program::Code code, const char* from, std::string_view reason);
void add_ignored(State& s, const char* from, const char* to);

}  // namespace obrys::read::sinumerik
