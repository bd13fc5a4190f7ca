#pragma once
/// Test side only: a unit as text, one statement a line, so that tests can compare trees.

#include <array>
#include <string>

#include "base/number.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::program::testing {

using program::Code;
using program::ExprId;
using program::ExprKind;
using program::StatementKind;

/// By Code.
inline constexpr std::array word_names{"X",
                                       "Y",
                                       "Z",
                                       "A",
                                       "B",
                                       "C",
                                       "U",
                                       "V",
                                       "W",
                                       "axis",
                                       "I",
                                       "J",
                                       "K",
                                       "I1",
                                       "J1",
                                       "K1",
                                       "CR",
                                       "AR",
                                       "TURN",
                                       "AP",
                                       "RP",
                                       "F",
                                       "S",
                                       "LIMS",
                                       "T",
                                       "D",
                                       "SPOS",
                                       "M",
                                       "H",
                                       "value",
                                       "CHF",
                                       "CHR",
                                       "RND",
                                       "RNDM",
                                       "FRC",
                                       "FRCM",
                                       "ANG",
                                       "RPL",
                                       "modal",
                                       "assign",
                                       "unsupported",
                                       "unknown",
                                       "control",
                                       "about-pole",
                                       "tool-change",
                                       "tool-definition",
                                       "F-auto",
                                       "cycle-call",
                                       "cycle-call-modal",
                                       "length",
                                       "radius",
                                       "DL",
                                       "DR",
                                       "DR2",
                                       "FU",
                                       "FZ",
                                       "pole-angle",
                                       "P",
                                       "Q",
                                       "L",
                                       "E",
                                       "H-offset",
                                       "D-offset"};

class TreeText {
public:
    TreeText(const program::Unit& unit, const program::Names& names) : u_(unit), names_(names) {}

    std::string statement(std::uint32_t i) const {
        const auto& s = u_.statements[i];
        std::string out((s.flags & program::line_start) != 0 ? "" : "+");
        if ((s.flags & program::skip_mask) != 0) out += "/" + std::to_string((s.flags & program::skip_mask) - 1) + " ";
        out += head(s);
        for (std::uint32_t w = s.first + (s.kind == StatementKind::block ? 0 : 1); w < u_.words_end(i); ++w)
            out += (out.empty() || out.back() == '+' || out.back() == ' ' ? "" : " ") + word(u_.words[w]);
        return out;
    }
    std::string all() const {
        std::string out;
        for (std::uint32_t i = 0; i < u_.statements.size(); ++i) out += std::to_string(i) + " " + statement(i) + "\n";
        return out;
    }
    std::string expr(ExprId id) const {
        if (id == program::no_expr) return "_";
        const auto& e = u_.exprs[id];
        switch (e.kind) {
            case ExprKind::number: return base::shortest(u_.numbers[e.a]) + (e.op == 1 ? "" : "r");
            case ExprKind::boolean: return e.a != 0 ? "TRUE" : "FALSE";
            case ExprKind::text: return "\"" + u_.texts[e.a] + "\"";
            case ExprKind::parameter: return parameter_name(u_.traits != nullptr ? *u_.traits : Traits{}, e.a);
            case ExprKind::parameter_at: return "R[" + expr(e.a) + "]";
            case ExprKind::variable: return names_.text(e.a) + list(e, '[', ']');
            case ExprKind::system: return names_.text(e.a) + "#" + std::to_string(e.op) + list(e, '[', ']');
            case ExprKind::unary: return "(" + op(e.op) + " " + expr(e.a) + ")";
            case ExprKind::binary: return "(" + expr(e.a) + " " + op(e.op) + " " + expr(e.b) + ")";
            case ExprKind::function: return "f" + std::to_string(e.op) + list(e, '(', ')', true);
            case ExprKind::unknown_function: return names_.text(e.a) + list(e, '(', ')', true);
            case ExprKind::qualified: return "q" + std::to_string(e.op) + "(" + expr(e.a) + ")";
        }
        return "?";
    }

private:
    static std::string op(std::uint8_t o) {
        static constexpr std::array<const char*, 25> text{"neg", "pos", "not",  "bnot", "+",    "-",  "*", "/",  "div",
                                                          "mod", "<<",  "==",   "<>",   "<",    "<=", ">", ">=", "and",
                                                          "or",  "xor", "band", "bor",  "bxor", ":",  "^"};
        return text[o];
    }
    std::string list(const program::Expr& e, char open, char close, bool always = false) const {
        if (e.count == 0 && !always) return "";
        std::string out(1, open);
        for (std::uint32_t i = 0; i < e.count; ++i) out += (i > 0 ? "," : "") + expr(u_.children[e.b + i]);
        return out + close;
    }
    std::string list(const std::vector<ExprId>& ids) const {
        std::string out;
        for (const ExprId id : ids) out += (out.empty() ? "" : ",") + expr(id);
        return out;
    }
    std::string jump(const program::Jump& j) const {
        static constexpr std::array<const char*, 5> text{"forward", "backward", "either", "quiet", "start"};
        return std::string(text[static_cast<std::size_t>(j.direction)]) +
               (j.direction == program::JumpDirection::start ? "" : " " + expr(j.destination)) +
               (j.condition == program::no_expr ? "" : " if " + expr(j.condition));
    }
    static std::string target(std::uint32_t t) { return t == program::no_target ? "" : " ->" + std::to_string(t); }
    std::string branch(const char* name, std::size_t at) const {
        const auto& b = u_.branches[at];
        return std::string(name) + (b.condition == program::no_expr ? "" : " " + expr(b.condition)) + target(b.target);
    }
    std::string label_call(const program::LabelCall& c) const {
        return "call " + expr(c.label) + target(c.target) +
               (c.repeats == program::no_expr ? "" : " rep " + expr(c.repeats));
    }
    std::string cycle(const program::CycleDefinition& c) const {
        static constexpr std::array<const char*, 3> use{"run", "accepted", "refused"};
        std::string out = c.name + " " + use[static_cast<std::size_t>(c.use)];
        for (const program::CycleSetting& s : c.settings) {
            out += " " + std::to_string(static_cast<int>(s.role));
            if (s.parameter != program::no_target && u_.traits != nullptr)
                out += ":" + parameter_name(*u_.traits, s.parameter);
            out += (s.incremental ? "+=" : "=") + expr(s.value);
        }
        return out + (c.texts.empty() ? "" : " " + list(c.texts));
    }
    std::string pattern(const program::Pattern& p) const {
        std::string out = p.table == program::no_expr ? "pattern" : "pattern-table " + expr(p.table);
        for (const program::PatternFigure& f : p.figures) {
            out += " " + std::to_string(static_cast<int>(f.kind)) + "(";
            for (const program::FigureSetting& s : f.settings)
                out += (out.back() == '(' ? "" : " ") + std::to_string(static_cast<int>(s.role)) +
                       (s.incremental ? "+=" : "=") + expr(s.value);
            out += ")";
        }
        return out;
    }
    static std::string node(const program::ContourStatement& c, std::uint32_t at) {
        const program::ContourNode& n = c.nodes[at];
        if (n.op == program::ContourOperator::contour) return "QC" + std::to_string(n.number);
        return "(" + node(c, n.left) + " " + "?|&\\^"[static_cast<std::size_t>(n.op)] + " " + node(c, n.right) + ")";
    }
    std::string contour(const program::ContourStatement& c) const {
        using Kind = program::ContourStatement::Kind;
        if (c.kind == Kind::selection) return "contour-program " + expr(c.program);
        if (c.kind == Kind::formula)
            return "contour QC" + std::to_string(c.number) + "=" +
                   node(c, static_cast<std::uint32_t>(c.nodes.size() - 1)) + (c.mixed ? " mixed" : "");
        std::string out = c.kind == Kind::declaration ? "declare QC" + std::to_string(c.number) : "contour";
        for (const program::ContourPart& p : c.parts) {
            out += std::string(" ") + (p.island ? "I" : "P") + std::to_string(p.number);
            out += p.label != program::no_expr ? "=label " + expr(p.label) : "=program " + expr(p.program);
            if (p.depth != program::no_expr) out += " depth " + expr(p.depth);
        }
        return out;
    }
    std::string head(const program::Statement& s) const {
        if (s.kind == StatementKind::block) return "";
        if (s.kind == StatementKind::label_end) return "label-end";
        const auto at = static_cast<std::size_t>(u_.words[s.first].payload);
        switch (s.kind) {
            case StatementKind::if_: return branch("if", at);
            case StatementKind::else_: return branch("else", at);
            case StatementKind::endif: return branch("endif", at);
            case StatementKind::while_: return branch("while", at);
            case StatementKind::endwhile: return branch("endwhile", at);
            case StatementKind::repeat_: return branch("repeat", at);
            case StatementKind::until: return branch("until", at);
            case StatementKind::loop_: return branch("loop", at);
            case StatementKind::endloop: return branch("endloop", at);
            case StatementKind::repeat_count: return branch("repeat-count", at);
            case StatementKind::end_repeat_count: return branch("end-repeat-count", at);
            case StatementKind::for_:
                return "for " + expr(u_.fors[at].variable) + "=" + expr(u_.fors[at].from) + ".." +
                       expr(u_.fors[at].to) + target(u_.fors[at].target);
            case StatementKind::endfor: return "endfor" + target(u_.fors[at].target);
            case StatementKind::case_: return choice(u_.cases[at]);
            case StatementKind::jump: return "jump " + jump(u_.jumps[at]);
            case StatementKind::repeat_section: return section(u_.sections[at]);
            case StatementKind::call: return call(u_.calls[at]);
            case StatementKind::procedure:
                return "procedure " + std::to_string(static_cast<int>(u_.procedures[at].procedure)) + "(" +
                       list(u_.procedures[at].arguments) + ")";
            case StatementKind::frame:
                return std::string(u_.frames[at].additive ? "a" : "") + "frame " +
                       std::to_string(static_cast<int>(u_.frames[at].op));
            case StatementKind::define: return define(u_.defines[at]);
            case StatementKind::return_: return "return";
            case StatementKind::label_call: return label_call(u_.label_calls[at]);
            case StatementKind::cycle_definition: return cycle(u_.cycles[at]);
            case StatementKind::pattern: return pattern(u_.patterns[at]);
            case StatementKind::contour: return contour(u_.contours[at]);
            default: return "?";
        }
    }
    std::string choice(const program::Case& c) const {
        std::string out = "case " + expr(c.selector);
        for (const auto& arm : c.arms) out += " | " + expr(arm.value) + " " + jump(arm.jump);
        return out;
    }
    std::string section(const program::Section& s) const {
        return std::string("section ") + names_.text(s.first) +
               (s.to_here     ? " here"
                : s.one_block ? " block"
                              : " " + names_.text(s.last)) +
               (s.passes == program::no_expr ? "" : " x" + expr(s.passes));
    }
    std::string call(const program::Call& c) const {
        static constexpr std::array<const char*, 4> text{"call ", "indirect ", "modal ", "modal-end"};
        std::string out = text[static_cast<std::size_t>(c.kind)];
        if (c.control_cycle != program::ControlCycle::none) out = "cycle " + out;
        if (c.kind == program::CallKind::indirect) out += expr(c.target);
        if (c.kind == program::CallKind::by_name || c.kind == program::CallKind::modal) out += names_.text(c.name);
        if (c.has_arguments) out += "(" + list(c.arguments) + ")";
        return out + (c.passes == program::no_expr ? "" : " x" + expr(c.passes));
    }
    std::string define(const program::Define& d) const {
        std::string out =
            std::string("define ") + (d.global ? "global " : "") + std::to_string(static_cast<int>(d.type));
        if (d.string_length != program::no_expr) out += "[" + expr(d.string_length) + "]";
        for (const auto& v : d.variables) {
            out += " " + names_.text(v.name);
            for (const ExprId n : v.dimensions)
                if (n != program::no_expr) out += "[" + expr(n) + "]";
            if (v.initialiser != program::Initialiser::none)
                out += "=" + std::to_string(static_cast<int>(v.initialiser)) + "(" + list(v.values) + ")";
        }
        return out;
    }
    std::string named(const program::Word& w) const {
        const auto& n = u_.named[static_cast<std::size_t>(w.payload)];
        return names_.text(n.name) + (n.index == program::no_expr ? "" : "[" + expr(n.index) + "]") + "=" +
               expr(n.value);
    }
    std::string word(const program::Word& w) const {
        const auto at = static_cast<std::size_t>(w.payload);
        switch (program::code_of(w)) {
            case Code::modal:
                return "m" + std::to_string(static_cast<int>(program::modal_of(w))) +
                       (program::modal_number(w) != 0 ? "." + std::to_string(program::modal_number(w)) : "");
            case Code::assign: return expr(u_.assigns[at].target) + "=" + expr(u_.assigns[at].value);
            case Code::unsupported:
            case Code::unknown:
                return std::string(word_names[w.code]) + "{" + u_.problems[at].text + "|" + u_.problems[at].reason +
                       "}";
            case Code::act: return "act";
            case Code::comment: return "comment{" + u_.texts[at] + "}";
            case Code::named_axis:
            case Code::named_value: return std::string(word_names[w.code]) + " " + named(w);
            default: break;
        }
        if (program::form_of(w) == program::Form::bare) return word_names[w.code];
        if (program::is_literal(w)) return word_names[w.code] + base::shortest(u_.literal(w));
        return std::string(word_names[w.code]) + "=" + expr(static_cast<ExprId>(w.payload));
    }

    const program::Unit& u_;
    const program::Names& names_;
};

}  // namespace obrys::program::testing
