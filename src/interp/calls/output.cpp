/// What a program prints: forms (FN 16) and plain values (FN 15). It goes into a folder that was named for it, or it is
/// said that it is lost.

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/calls/calls.hpp"
#include "interp/calls/print_form.hpp"

namespace obrys::interp {

namespace codes = base::codes;

void print_to(Reckoning& run, const program::ProcedureCall& p, const std::string& file, std::string_view text,
              bool again) {
    if (run.capture != nullptr) return;
    if (run.env.files != nullptr && run.env.files->print(file, text, again)) return;
    assume(run, p.where, "what the program prints to " + file + " is not written",
           "name a folder for it with --prints DIR or prints in the job");
}

namespace {

/// A parameter by its name, as it is; one that was never set is 0.
Value value_named(Reckoning& run, std::string_view name) {
    const program::Traits& t = *run.traits;
    if (const std::uint32_t n = program::find_parameter(t, name); n < run.parameters.count())
        return Value::real(run.parameters.get(n));
    const Binding* b = t.text_letters.empty() || !name.starts_with(t.text_letters)
                           ? nullptr
                           : run.globals.find(run.env.names.id(name));
    return b == nullptr ? Value::unknown() : b->array->get(b->offset);
}

}  // namespace

void print_form(Telling& run, const program::ProcedureCall& p) {
    if (run.capture != nullptr) return;
    const std::string name = base::to_upper(printed(evaluate(run, p.arguments[0])));
    const std::string file = printed(evaluate(run, p.arguments[1]));
    if (run.stopped) return;
    const std::string* form = run.env.files == nullptr ? nullptr : run.env.files->form(name);
    if (form == nullptr) {
        assume(run, p.where, "the form " + name + " is not at hand: what it prints is left out",
               "put it beside the program");
        return;
    }
    const auto value = [&](std::string_view parameter) { return value_named(run, parameter); };
    const FilledForm filled = fill_form(*form, value, run.env.sources[run.calls.front().unit->file].name);
    for (const std::string& problem : filled.problems) assume(run, p.where, "the form " + name + ", " + problem);
    if (filled.clock) assume(run, p.where, "the form " + name + " asks for date or time: \"?\" stands there");
    if (base::to_upper(file) == "SCREEN") return emit(run, cl::Comment{filled.text, true, false});
    const bool begun = run.printed_files.contains(file);
    print_to(run, p, file, filled.text, !begun && !filled.append);
    if (filled.close)
        run.printed_files.erase(file);
    else
        run.printed_files.insert(file);
}

void print_values(Reckoning& run, const program::ProcedureCall& p) {
    if (run.capture != nullptr) return;
    std::string text;
    for (const ExprId id : p.arguments) {
        text += (text.empty() ? "" : " ") + printed(evaluate(run, id));
        if (run.stopped) return;
    }
    const std::string file = "FN15RUN.A";
    print_to(run, p, file, text + "\n", run.printed_files.insert(file).second);
}

}  // namespace obrys::interp
