#include "program/builder.hpp"

#include <algorithm>
#include <array>

#include "base/codes.hpp"
#include "base/text.hpp"

namespace obrys::program {

/// Most names are short: nothing is allocated for one that is known.
NameId Builder::name(std::string_view any_case) {
    std::array<char, 64> upper{};
    if (any_case.size() > upper.size()) return names_.id(base::to_upper(any_case));
    std::transform(any_case.begin(), any_case.end(), upper.begin(), base::upper);
    return names_.id({upper.data(), any_case.size()});
}

void Builder::statement(StatementKind kind, std::uint32_t begin) {
    Statement s;
    s.begin = begin;
    s.first = static_cast<std::uint32_t>(unit_.words.size());
    s.kind = kind;
    s.flags = static_cast<std::uint8_t>(skip_ | (first_of_block_ ? line_start : 0));
    first_of_block_ = false;
    unit_.statements.push_back(s);
}

void Builder::end_statement(std::uint32_t end) {
    Statement& s = unit_.statements.back();
    const std::uint32_t from = s.begin;
    while (end > from && base::is_blank(text_[end - 1])) --end;
    s.length = static_cast<std::uint16_t>(std::min<std::uint32_t>(std::max(end, from) - from, 0xFFFF));
}

void Builder::control(StatementKind kind, std::size_t index, std::uint32_t begin, std::uint32_t end) {
    statement(kind, begin);
    word(Code::control, Form::index, static_cast<std::int32_t>(index), begin, end);
    end_statement(end);
}

void Builder::word(Code code, Form form, std::int32_t payload, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t from = unit_.statements.back().begin;
    begin = std::max(begin, from);  // what stands before the statement has no place in it
    unit_.words.push_back(make_word(code, static_cast<std::uint32_t>(form), payload, std::min(begin - from, 4095U),
                                    std::min(std::max(end, begin) - begin, 255U)));
}

void Builder::modal(Modal m, std::uint32_t begin, std::uint32_t end, int number) {
    word(Code::modal, Form::index, modal_word(m, number), begin, end);
}

void Builder::literal(Code code, double value, std::uint32_t begin, std::uint32_t end) {
    unit_.numbers.push_back(value);
    word(code, Form::pooled, static_cast<std::int32_t>(unit_.numbers.size() - 1), begin, end);
}

void Builder::literal(Code code, const base::NumberScan& n, bool negative, std::uint32_t begin, std::uint32_t end) {
    constexpr std::int64_t most = 999'999'999;
    const bool fits =
        n.decimal && n.decimal->decimals <= 9 && n.decimal->mantissa <= most && n.decimal->mantissa >= -most;
    if (!fits) return literal(code, negative ? -n.value : n.value, begin, end);
    const auto mantissa = static_cast<std::int32_t>(n.decimal->mantissa);
    word(code, static_cast<Form>(n.decimal->decimals), negative ? -mantissa : mantissa, begin, end);
}

void Builder::expression(Code code, ExprId value, std::uint32_t begin, std::uint32_t end) {
    word(code, Form::expression, static_cast<std::int32_t>(value), begin, end);
}

void Builder::assign(ExprId target, ExprId value, std::uint32_t begin, std::uint32_t end) {
    unit_.assigns.push_back({target, value});
    word(Code::assign, Form::index, static_cast<std::int32_t>(unit_.assigns.size() - 1), begin, end);
}

void Builder::fail(std::uint32_t begin, std::uint32_t end, std::string text, std::string remedy) {
    base::Diagnostic d;
    d.code = base::codes::syntax;
    d.where = span(begin, std::max(begin, end));
    d.text = text;
    d.remedy = std::move(remedy);
    diagnostics_.add(std::move(d));
    problem(Code::unknown, begin, std::max(begin, end), text);
}

void Builder::problem(Code code, std::uint32_t begin, std::uint32_t end, std::string_view reason) {
    if (unit_.statements.empty()) statement(StatementKind::block, begin);
    Problem p;
    p.where = span(begin, end);
    p.text = base::as_utf8(text_.substr(begin, end - begin));
    p.reason = reason;
    unit_.problems.push_back(std::move(p));
    word(code, Form::index, static_cast<std::int32_t>(unit_.problems.size() - 1), begin, end);
}

void Builder::ignored(std::string_view shown, std::uint32_t begin, std::uint32_t end) {
    std::string key(shown);
    const auto next = static_cast<std::uint32_t>(unit_.ignored.size());
    const auto [found, is_new] = ignored_.try_emplace(key, next);
    if (is_new)
        unit_.ignored.push_back({std::move(key), span(begin, end), 1});
    else
        ++unit_.ignored[found->second].count;
}

ExprId Builder::add(Expr e, std::uint32_t begin, std::uint32_t end) {
    e.begin = begin;
    e.end = end;
    unit_.exprs.push_back(e);
    return static_cast<ExprId>(unit_.exprs.size() - 1);
}

ExprId Builder::number(double value, bool integer, std::uint32_t begin, std::uint32_t end) {
    unit_.numbers.push_back(value);
    Expr e;
    e.op = integer ? 1 : 0;
    e.a = static_cast<std::uint32_t>(unit_.numbers.size() - 1);
    return add(e, begin, end);
}

ExprId Builder::text(std::string value, std::uint32_t begin, std::uint32_t end) {
    unit_.texts.push_back(std::move(value));
    Expr e;
    e.kind = ExprKind::text;
    e.a = static_cast<std::uint32_t>(unit_.texts.size() - 1);
    return add(e, begin, end);
}

ExprId Builder::unary(Operator op, ExprId a, std::uint32_t begin, std::uint32_t end) {
    Expr e;
    e.kind = ExprKind::unary;
    e.op = static_cast<std::uint8_t>(op);
    e.a = a;
    return add(e, begin, end);
}

ExprId Builder::binary(Operator op, ExprId a, ExprId b, std::uint32_t begin, std::uint32_t end) {
    Expr e;
    e.kind = ExprKind::binary;
    e.op = static_cast<std::uint8_t>(op);
    e.a = a;
    e.b = b;
    return add(e, begin, end);
}

ExprId Builder::function(Function f, const std::vector<ExprId>& arguments, std::uint32_t begin, std::uint32_t end) {
    Expr e;
    e.kind = ExprKind::function;
    e.op = static_cast<std::uint8_t>(f);
    adopt(e, arguments);
    return add(e, begin, end);
}

ExprId Builder::with_reference(Reference r, ExprId a, std::uint32_t begin, std::uint32_t end) {
    Expr e;
    e.kind = ExprKind::qualified;
    e.op = static_cast<std::uint8_t>(r);
    e.a = a;
    return add(e, begin, end);
}

void Builder::adopt(Expr& e, const std::vector<ExprId>& children) {
    e.b = static_cast<std::uint32_t>(unit_.children.size());
    e.count = static_cast<std::uint16_t>(children.size());
    unit_.children.insert(unit_.children.end(), children.begin(), children.end());
}

}  // namespace obrys::program
