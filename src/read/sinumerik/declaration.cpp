#include <array>
#include <optional>

#include "read/sinumerik/archive.hpp"
#include "read/sinumerik/expression.hpp"
#include "read/sinumerik/statement.hpp"

namespace obrys::read::sinumerik {

using program::ExprId;
using program::no_expr;
using program::Type;

namespace {

bool take_word(State& s, std::string_view word) {
    s.cursor.skip_blanks();
    if (!base::equals_ignoring_case(s.cursor.name(), word)) return false;
    s.cursor.p += word.size();
    return true;
}

std::optional<Type> take_type(State& s) {
    s.cursor.skip_blanks();
    const std::string_view name = s.cursor.name();
    const auto type = dialect::sinumerik::find_type(base::to_upper(name));
    if (type) s.cursor.p += name.size();
    return type;
}

/// `[n]`, `[n,m]` or `[n][m]`; sizes may be left out (`[]`, `[,]`) where `open` allows it.
bool read_dimensions(State& s, std::array<ExprId, 3>& out, bool open, bool& is_array) {
    Cursor& c = s.cursor;
    std::size_t n = 0;
    while (c.take('[')) {
        is_array = true;
        do {
            c.skip_blanks();
            const bool left_out = open && (c.peek() == ']' || c.peek() == ',');
            const ExprId size = left_out ? no_expr : read_expression(s);
            if (size == no_expr && !left_out) return false;
            if (n == out.size()) {
                fail_here(s, "an array has at most three dimensions");
                return false;
            }
            out[n++] = size;
        } while (c.take(','));
        if (!c.take(']')) {
            fail_here(s, "expected ']', found " + here(s), "close the dimension");
            return false;
        }
    }
    return true;
}

/// `= value`, `= SET(…)`, `= (…)`, `= REP(…)` behind a variable.
bool read_initialiser(State& s, program::Variable& variable) {
    Cursor& c = s.cursor;
    if (!c.take('=')) return true;
    const bool is_array = variable.dimensions[0] != no_expr;
    const char* back = c.p;
    program::Initialiser list = program::Initialiser::none;
    if (take_word(s, "SET"))
        list = program::Initialiser::set;
    else if (take_word(s, "REP"))
        list = program::Initialiser::repeat;
    else if (is_array)
        list = program::Initialiser::set;
    c.skip_blanks();
    if (list != program::Initialiser::none && c.peek() == '(') {
        variable.initialiser = list;
        return read_arguments(s, variable.values);
    }
    c.p = back;
    const ExprId value = read_expression(s);
    if (value == no_expr) return false;
    variable.initialiser = program::Initialiser::single;
    variable.values.push_back(value);
    return true;
}

/// One letter is an address wherever it is written (NC programming 12/2019: names begin with two letters or
/// underscores).
bool is_address(State& s, std::string_view name) {
    if (name.size() != 1) return false;
    fail(s, s.cursor.p, s.cursor.p + 1,
         "a name begins with two letters or underscores: " + std::string(name) + " alone is an address",
         "give the variable a longer name");
    return true;
}

bool read_variable(State& s, program::Define& define) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    const std::string_view name = c.name();
    if (name.empty()) {
        fail_here(s, "DEF needs the name of a variable, found " + here(s));
        return false;
    }
    if (is_address(s, name)) return false;
    program::Variable variable;
    const std::string upper = base::to_upper(name);
    variable.name = s.names.id(upper);
    variable.where = s.span(c.p, c.p + name.size());
    c.p += name.size();
    note_variable(s, upper, define.type == Type::string);
    bool is_array = false;
    if (!read_dimensions(s, variable.dimensions, false, is_array) || !read_initialiser(s, variable)) return false;
    define.variables.push_back(std::move(variable));
    return true;
}

/// Access rights, limits, units and the like of a definition: taken, without effect on a run here.
bool skip_attributes(State& s, bool with_value_only) {
    constexpr std::array<std::string_view, 13> with_number{"APR", "APW", "APX", "APRP",  "APWP",  "APRB", "APWB",
                                                           "PHU", "LLI", "ULI", "INIPO", "INIRE", "INICF"};
    constexpr std::array<std::string_view, 4> bare{"SYNR", "SYNW", "SYNRW", "PRLOC"};
    for (bool again = true; again;) {
        again = false;
        if (!with_value_only)
            for (const std::string_view w : bare) again = again || take_word(s, w);
        for (const std::string_view w : with_number) {
            if (!take_word(s, w)) continue;
            again = true;
            s.cursor.skip_blanks();
            const char c = s.cursor.peek();
            const bool has_value = base::is_digit(c) || c == '-' || c == '+' || c == '.';
            if (has_value && read_expression(s, Level::unary) == no_expr) return false;
        }
    }
    return true;
}

bool read_parameter(State& s, program::Parameter& parameter) {
    Cursor& c = s.cursor;
    parameter.by_reference = take_word(s, "VAR");
    const auto type = take_type(s);
    if (!type) {
        fail_here(s, "expected the type of a parameter, found " + here(s),
                  "write REAL, INT, BOOL, CHAR, STRING[n], AXIS or FRAME");
        return false;
    }
    parameter.type = *type;
    bool sized = false;
    std::array<ExprId, 3> length{no_expr, no_expr, no_expr};
    if (parameter.type == Type::string && !read_dimensions(s, length, true, sized)) return false;
    c.skip_blanks();
    const std::string_view name = c.name();
    if (name.empty()) {
        fail_here(s, "expected the name of a parameter, found " + here(s));
        return false;
    }
    if (is_address(s, name)) return false;
    const std::string upper = base::to_upper(name);
    parameter.name = s.names.id(upper);
    c.p += name.size();
    note_variable(s, upper, parameter.type == Type::string);
    if (!read_dimensions(s, parameter.dimensions, true, parameter.is_array)) return false;
    if (!c.take('=')) return true;
    parameter.preset = read_expression(s);
    return parameter.preset != no_expr;
}

bool read_parameters(State& s) {
    Cursor& c = s.cursor;
    const char* open = c.p - 1;
    if (c.take(')')) return true;
    do {
        if (c.at_end()) break;
        program::Parameter parameter;
        if (!read_parameter(s, parameter)) return false;
        s.unit.parameters.push_back(std::move(parameter));
    } while (c.take(','));
    if (c.take(')')) return true;
    if (c.at_end())
        fail(s, open, open + 1, "this parenthesis is not closed", "add ')'");
    else
        fail_here(s, "expected ',' or ')', found " + here(s));
    return false;
}

}  // namespace

void read_def(State& s, const char* from) {
    Cursor& c = s.cursor;
    program::Define define;
    for (bool again = true; again;) {
        again = take_word(s, "NCK") || take_word(s, "CHAN");
        define.global = define.global || again;
        const char* back = c.p;
        if (!skip_attributes(s, false)) return;
        again = again || c.p != back;
    }
    const auto type = take_type(s);
    if (!type)
        return fail_here(s, "DEF needs a type, found " + here(s),
                         "write DEF REAL, INT, BOOL, CHAR, STRING[n], AXIS or FRAME");
    define.type = *type;
    if (define.type == Type::string && c.take('[')) {
        define.string_length = read_expression(s);
        if (define.string_length == no_expr) return;
        if (!c.take(']')) return fail_here(s, "expected ']', found " + here(s), "close the length of the string");
    }
    if (!skip_attributes(s, true)) return;
    do {
        if (!read_variable(s, define)) return;
    } while (c.take(','));
    s.unit.defines.push_back(std::move(define));
    add_control(s, program::StatementKind::define, s.unit.defines.size() - 1, from);
}

void read_proc(State& s, const char* from) {
    Cursor& c = s.cursor;
    s.declares = true;
    c.skip_blanks();
    const std::string_view name = c.name();
    if (name.empty()) return fail_here(s, "PROC needs the name of the program, found " + here(s));
    if (s.unit.has_proc || !s.unit.statements.empty())
        return fail(s, from, from + 4, "PROC stands only in the first block of a program",
                    "split the text into one file a program");
    s.unit.has_proc = true;
    s.unit.name = plain_name(name);
    c.p += name.size();
    if (c.take('(') && !read_parameters(s)) return;
    constexpr std::array<std::string_view, 6> attributes{"SBLOF", "SBLON", "DISPLOF", "DISPLON", "ACTBLOCNO", "PREPRO"};
    while (!c.at_end()) {
        if (take_word(s, "SAVE")) {
            s.unit.save = true;
            continue;
        }
        bool known = false;
        for (const std::string_view a : attributes) {
            const char* word = c.p;
            if (!take_word(s, a)) continue;
            known = true;
            add_ignored(s, word, c.p);
        }
        if (!known)
            return fail_here(s, "expected an attribute of PROC, found " + here(s),
                             "SAVE, SBLOF, DISPLOF, DISPLON, ACTBLOCNO and PREPRO stand there");
    }
}

void read_extern(State& s, const char* from) {
    Cursor& c = s.cursor;
    s.declares = true;
    c.skip_blanks();
    const std::string_view name = c.name();
    if (name.empty()) return fail(s, from, from + 6, "EXTERN needs the name of a program");
    c.p += name.size();
    if (!c.take('(')) return;
    while (!c.take(')')) {
        (void)take_word(s, "VAR");
        bool ignored_array = false;
        std::array<ExprId, 3> ignored{no_expr, no_expr, no_expr};
        const auto type = take_type(s);
        if (!type)
            return fail_here(s, "expected the type of a parameter, found " + here(s),
                             "write REAL, INT, BOOL, CHAR, STRING[n], AXIS or FRAME");
        if (!read_dimensions(s, ignored, true, ignored_array)) return;
        c.skip_blanks();
        c.p += c.name().size();  // a name may stand there too
        if (!read_dimensions(s, ignored, true, ignored_array)) return;
        if (c.take(',')) continue;
        if (c.take(')')) return;
        return fail_here(s, "expected ',' or ')', found " + here(s));
    }
}

}  // namespace obrys::read::sinumerik
