#pragma once
/// Puts a program tree together: what every reader does once it knows what a piece of its text means.
/// All places are bytes of the unit's source text; the smallest one that a programmer would point at.

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/number.hpp"
#include "program/unit.hpp"

namespace obrys::program {

class Builder {
public:
    /// References must outlive the builder. `text` is the whole source text of `unit.file`.
    Builder(Unit& unit, Names& names, base::Diagnostics& diagnostics, std::string_view text)
        : unit_(unit), names_(names), diagnostics_(diagnostics), text_(text) {}

    [[nodiscard]] Unit& unit() { return unit_; }
    [[nodiscard]] NameId name(std::string_view any_case);
    [[nodiscard]] base::Span span(std::uint32_t begin, std::uint32_t end) const { return {unit_.file, begin, end}; }

    /// From here on statements belong to a new block; `skip` is its block skip level + 1, or 0.
    void begin_block(std::uint8_t skip = 0) { first_of_block_ = true, skip_ = skip; }
    [[nodiscard]] std::uint8_t skip() const { return skip_; }
    /// A new statement; words that follow are its own.
    void statement(StatementKind kind, std::uint32_t begin);
    /// A statement whose first word is its entry in the kind's table.
    void control(StatementKind kind, std::size_t index, std::uint32_t begin, std::uint32_t end);
    /// Sets the length of the statement at hand.
    void end_statement(std::uint32_t end);

    void word(Code code, Form form, std::int32_t payload, std::uint32_t begin, std::uint32_t end);
    void bare(Code code, std::uint32_t begin, std::uint32_t end) { word(code, Form::bare, 0, begin, end); }
    void modal(Modal m, std::uint32_t begin, std::uint32_t end, int number = 0);
    void literal(Code code, double value, std::uint32_t begin, std::uint32_t end);
    /// As `literal`; exact in eight bytes where the decimal fits.
    void literal(Code code, const base::NumberScan& n, bool negative, std::uint32_t begin, std::uint32_t end);
    void expression(Code code, ExprId value, std::uint32_t begin, std::uint32_t end);
    void assign(ExprId target, ExprId value, std::uint32_t begin, std::uint32_t end);

    /// Complains (code `syntax`) and keeps the place in the tree as an unknown word, so that a run reports it too.
    void fail(std::uint32_t begin, std::uint32_t end, std::string text, std::string remedy = {});
    /// A word known to the control and not run (`Code::unsupported`), or not known at all (`Code::unknown`).
    void problem(Code code, std::uint32_t begin, std::uint32_t end, std::string_view reason = {});
    /// A known word without effect on the path: listed once a program.
    void ignored(std::string_view shown, std::uint32_t begin, std::uint32_t end);

    [[nodiscard]] ExprId add(Expr e, std::uint32_t begin, std::uint32_t end);
    [[nodiscard]] ExprId number(double value, bool integer, std::uint32_t begin, std::uint32_t end);
    [[nodiscard]] ExprId text(std::string value, std::uint32_t begin, std::uint32_t end);
    [[nodiscard]] ExprId unary(Operator op, ExprId a, std::uint32_t begin, std::uint32_t end);
    [[nodiscard]] ExprId binary(Operator op, ExprId a, ExprId b, std::uint32_t begin, std::uint32_t end);
    [[nodiscard]] ExprId function(Function f, const std::vector<ExprId>& arguments, std::uint32_t begin,
                                  std::uint32_t end);
    [[nodiscard]] ExprId with_reference(Reference r, ExprId a, std::uint32_t begin, std::uint32_t end);
    /// Gives `e` its children, stored side by side.
    void adopt(Expr& e, const std::vector<ExprId>& children);

private:
    Unit& unit_;
    Names& names_;
    base::Diagnostics& diagnostics_;
    std::string_view text_;
    bool first_of_block_ = true;
    std::uint8_t skip_ = 0;
    std::unordered_map<std::string, std::uint32_t> ignored_;  ///< entry in Unit::ignored
};

}  // namespace obrys::program
