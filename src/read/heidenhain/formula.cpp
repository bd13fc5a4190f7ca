/// Formulas of Q parameters: `Q1 = SQRT ( Q2 ^ 2 + 5 ) * SIN Q3`, and texts of QS parameters.
/// Order of the control (iTNC 530 pilot, entering formulas directly): parentheses, functions and signs, power, times
/// and through, plus and minus; equal ones from left to right, but chained powers from right to left (TNC7 manual,
/// rules for formulas; those of the iTNC 530 do not speak of them).

#include <array>
#include <optional>

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::Function;
using program::no_expr;
using program::Operator;

namespace {

constexpr int deepest = 200;   ///< nesting of parentheses, functions and signs
constexpr int longest = 1000;  ///< operators of one formula: the tree is walked recursively

struct Name {
    std::string_view text;
    Function function;
};
// Longer names before their beginnings.
constexpr std::array functions{
    Name{"SQRT", Function::sqrt}, Name{"SQ", Function::square},     Name{"ASIN", Function::asin},
    Name{"ACOS", Function::acos}, Name{"ATAN", Function::atan},     Name{"SIN", Function::sin},
    Name{"COS", Function::cos},   Name{"TAN", Function::tan},       Name{"LN", Function::ln},
    Name{"LOG", Function::log10}, Name{"EXP", Function::exp},       Name{"INT", Function::trunc},
    Name{"ABS", Function::abs},   Name{"FRAC", Function::fraction}, Name{"SGN", Function::sign},
};

class Formula {
public:
    explicit Formula(State& s) : s_(s) {}

    ExprId read(int level, int depth) {
        s_.in.skip_blanks();
        const std::uint32_t begin = s_.in.at();
        ExprId left = operand(depth);
        while (left != no_expr) {
            const std::uint32_t behind = s_.in.at();
            const auto op = operator_here();
            if (!op || op->second < level) {
                s_.in.go_to(behind);
                break;
            }
            if (++operators_ > longest) {
                fail_here(s_, "the formula has more than 1000 operators", "split it over several blocks");
                return no_expr;
            }
            s_.in.step(op->first == Operator::concat ? 2 : 1);
            const bool power = op->first == Operator::power;
            const ExprId right = read(power ? op->second : op->second + 1, power ? depth + 1 : depth);
            if (right == no_expr) return no_expr;
            left = s_.build.binary(op->first, left, right, begin, s_.in.at());
        }
        return left;
    }

private:
    std::optional<std::pair<Operator, int>> operator_here() {
        if (s_.in.at_end()) return std::nullopt;
        switch (s_.in.peek()) {
            case '+': return std::pair{Operator::add, 0};
            case '-': return std::pair{Operator::subtract, 0};
            case '|':
                if (s_.in.peek(1) == '|') return std::pair{Operator::concat, 0};
                return std::nullopt;
            case '*': return std::pair{Operator::multiply, 1};
            case '/': return std::pair{Operator::divide, 1};
            case '%': return std::pair{Operator::modulo, 1};
            case '^': return std::pair{Operator::power, 2};
            default: return std::nullopt;
        }
    }

    ExprId operand(int depth) {
        if (depth > deepest) {
            fail_here(s_, "the formula is nested more than 200 levels deep");
            return no_expr;
        }
        if (s_.in.at_end()) {
            fail_here(s_, "the formula ends where a number, a Q parameter or a function is due");
            return no_expr;
        }
        const std::uint32_t begin = s_.in.at();
        const char c = s_.in.peek();
        if (c == '+' || c == '-') {
            s_.in.step();
            const ExprId value = operand(depth + 1);
            if (value == no_expr || c == '+') return value;
            return s_.build.unary(Operator::negate, value, begin, s_.in.at());
        }
        if (c == '(') return parenthesis(begin, depth);
        if (c == '"') return read_text(s_);
        if (const ExprId parameter = read_parameter(s_); parameter != no_expr) return parameter;
        if (base::is_letter(c)) return named(begin, depth);
        base::NumberScan n = s_.in.number();
        if (n.length > 0) limit(s_, n, begin);
        if (s_.failed) return no_expr;
        if (n.length > 0) return s_.build.number(n.value, n.integer, begin, s_.in.at());
        fail_here(s_, "a number, a Q parameter or a function is due here, found " + here(s_));
        return no_expr;
    }

    ExprId parenthesis(std::uint32_t begin, int depth) {
        s_.in.step();
        const ExprId inner = read(0, depth + 1);
        if (inner == no_expr) return no_expr;
        if (!s_.in.take(')')) {
            fail(s_, begin, "this parenthesis is not closed", "write the missing ')'");
            return no_expr;
        }
        return inner;
    }

    /// A function may stand directly before its parameter, not before another letter.
    bool take_function(std::string_view name) {
        const std::uint32_t before = s_.in.at();
        if (s_.in.take_prefix(name) && (!base::is_letter(s_.in.peek()) || stands_parameter(s_))) return true;
        s_.in.go_to(before);
        return false;
    }

    ExprId named(std::uint32_t begin, int depth) {
        if (s_.in.take_word("PI")) return s_.build.number(3.14159265358979323846, false, begin, s_.in.at());
        if (take_function("NEG")) {
            const ExprId argument = operand(depth + 1);
            return argument == no_expr ? no_expr : s_.build.unary(Operator::negate, argument, begin, s_.in.at());
        }
        for (const Name& f : functions) {
            if (!take_function(f.text)) continue;
            const ExprId argument = operand(depth + 1);
            if (argument == no_expr) return no_expr;
            return s_.build.function(f.function, {argument}, begin, s_.in.at());
        }
        return text_function(begin);
    }

    /// TOCHAR( DAT+Q1 DECIMALS3 ), TONUMB( SRC_QS1 ), SUBSTR( SRC_QS1 BEG2 LEN4 ), INSTR( SRC_QS1 SEA_QS2 BEG0 ),
    /// STRLEN( SRC_QS1 ), STRCOMP( SRC_QS1 SEA_QS2 ).
    ExprId text_function(std::uint32_t begin) {
        struct Form {
            std::string_view name;
            Function function;
            std::array<std::string_view, 3> words;
        };
        constexpr std::array forms{
            Form{"TOCHAR", Function::to_text, {"DAT", "DECIMALS", ""}},
            Form{"TONUMB", Function::number, {"SRC_", "", ""}},
            Form{"SUBSTR", Function::substring, {"SRC_", "BEG", "LEN"}},
            Form{"INSTR", Function::find_text, {"SRC_", "SEA_", "BEG"}},
            Form{"STRLEN", Function::string_length, {"SRC_", "", ""}},
            Form{"STRCOMP", Function::compare_texts, {"SRC_", "SEA_", ""}},
        };
        for (const Form& f : forms) {
            if (!s_.in.take_word(f.name)) continue;
            std::vector<ExprId> arguments;
            if (!s_.in.take('(')) {
                fail_here(s_, "'(' is due behind " + std::string(f.name));
                return no_expr;
            }
            for (const std::string_view word : f.words) {
                if (word.empty() || !s_.in.take_prefix(word)) continue;
                const bool text = word.ends_with('_');
                const ExprId value = text ? read_text(s_) : value_expr(s_);
                if (value == no_expr) return no_expr;
                arguments.push_back(value);
            }
            if (!s_.in.take(')')) {
                fail_here(s_, "')' is due here, found " + here(s_));
                return no_expr;
            }
            return s_.build.function(f.function, arguments, begin, s_.in.at());
        }
        fail_here(s_, "the control has no function " + here(s_),
                  "SIN COS TAN ASIN ACOS ATAN SQ SQRT LN LOG EXP NEG INT ABS FRAC SGN PI");
        return no_expr;
    }

    State& s_;
    int operators_ = 0;
};

}  // namespace

ExprId read_formula(State& s) { return Formula(s).read(0, 0); }

ExprId read_text(State& s) {
    s.in.skip_blanks();
    if (const ExprId parameter = read_parameter(s); parameter != no_expr) return parameter;
    const std::uint32_t begin = s.in.at();
    const char quote = s.in.peek();
    if (quote != '"' && quote != '\'') {
        fail_here(s, "a text in quotes or a QS parameter is due here, found " + here(s));
        return no_expr;
    }
    s.in.step();
    const std::uint32_t from = s.in.at();
    while (s.in.peek() != quote && s.in.peek() != '\0' && s.in.peek() != '\n' && s.in.peek() != '\r') s.in.step();
    const std::uint32_t to = s.in.at();
    if (s.in.peek() != quote) {
        fail(s, begin, "this text has no closing quote");
        return no_expr;
    }
    s.in.step();
    return s.build.text(base::as_utf8(s.in.between(from, to)), begin, s.in.at());
}

}  // namespace obrys::read::heidenhain
