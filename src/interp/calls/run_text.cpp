/// EXECSTRING: a text becomes a block of the program that runs it, with its variables.

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// A jump would look for its label in the text, and an end of program would end the text alone.
bool leaves_the_text(const Unit& unit) {
    if (!unit.jumps.empty()) return true;
    for (const program::Word& w : unit.words)
        if (program::code_of(w) == Code::m && program::is_literal(w))
            if (const double m = unit.literal(w); m == 2 || m == 17 || m == 30) return true;
    return false;
}

}  // namespace

void run_text(Calling& run, const program::ProcedureCall& p) {
    const Value v = p.arguments.empty() ? Value{} : evaluate(run, p.arguments[0]);
    if (run.stopped) return;
    if (v.is_unknown() || (v.is_text() && v.as_text().find('?') != std::string::npos))
        return unchecked(run, codes::unknown_value, p.where,
                         "which block this text is depends on a value that is not known: it is left out");
    if (!v.is_text()) return alarm(run, codes::type_mismatch, p.where, "EXECSTRING needs a text");
    const Unit* unit = run.env.read_text == nullptr ? nullptr : (*run.env.read_text)(v.as_text());
    if (unit == nullptr)
        return unchecked(run, codes::unsupported, p.where, "the text \"" + v.as_text() + "\" is not run as a block");
    if (leaves_the_text(*unit))
        return unchecked(run, codes::unsupported, p.where,
                         "the text \"" + v.as_text() + "\" is not run: it jumps or ends the program",
                         "write the jump outside EXECSTRING");
    const std::size_t depth = run.calls.size();
    enter(run, *unit, nullptr, p.where);
    if (run.stopped || run.calls.size() == depth) return;
    run.top().locals = run.calls[depth - 1].locals;  // the variables themselves are shared
    run.top().own_bindings = run.top().locals.size();
    run.top().is_text = true;
}

}  // namespace obrys::interp
