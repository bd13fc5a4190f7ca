/// Procedures of the control itself: messages, alarms, what it prints and logs, tables.

#include "base/codes.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

using program::Procedure;
namespace codes = base::codes;

namespace {

std::string text_of(Reckoning& run, const program::ProcedureCall& p, std::size_t i) {
    const bool given = p.arguments.size() > i && p.arguments[i] != program::no_expr;
    return given ? printed(evaluate(run, p.arguments[i])) : std::string{};
}

void show(Telling& run, const program::ProcedureCall& p) {
    std::string text = text_of(run, p, 0);
    run.last_message = text;
    if (!run.stopped) emit(run, cl::Comment{std::move(text), true, p.procedure == Procedure::print});
}

void stop_itself(Reckoning& run, const program::ProcedureCall& p) {
    const Value v = p.arguments.empty() ? Value{} : evaluate(run, p.arguments[0]);
    std::string text = p.arguments.size() > 1 ? ": " + text_of(run, p, 1) : std::string{};
    if (text.empty() && !run.last_message.empty()) text = ": " + run.last_message;
    const auto known = run.traits->alarm_text;
    const auto plain = base::cut<int>(v.number, 0, 999'999'999);
    const std::string shown = known != nullptr && plain ? known(*plain) : "alarm " + printed(v);
    if (!run.stopped) alarm(run, codes::program_alarm, p.where, "the program stops itself with " + shown + text);
}

void abort(Reckoning& run, const program::ProcedureCall& p) {
    const bool given = !p.arguments.empty() && p.arguments[0] != program::no_expr;
    const Value v = given ? evaluate(run, p.arguments[0]) : Value{};
    if (!run.stopped && given && v.is_unknown()) {
        unchecked(run, codes::unknown_value, p.where,
                  "with which alarm the program stops itself here depends on a value that is not known");
        run.stopped = true;
        run.ending = Ending::alarm;
        return;
    }
    const std::string text = given ? printed(v) : std::string{};
    if (!run.stopped) alarm(run, codes::program_alarm, p.where, "the program stops itself: " + text);
}

/// Logs are files that the program prints to: into the folder named for them, or it is said that they are lost.
void log(Reckoning& run, const program::ProcedureCall& p) {
    switch (p.procedure) {
        case Procedure::log_open:
        case Procedure::log_append:
            run.log_file = text_of(run, p, 0);
            if (p.procedure == Procedure::log_open) print_to(run, p, run.log_file, {}, true);
            return;
        case Procedure::log_close: run.log_file.clear(); return;
        default:
            if (const std::string text = text_of(run, p, 0); !run.log_file.empty() && !run.stopped)
                print_to(run, p, run.log_file, text + "\n", false);
    }
}

}  // namespace

void procedure(Calling& run, const program::ProcedureCall& p) {
    switch (p.procedure) {
        case Procedure::message:
        case Procedure::print: return show(run, p);
        case Procedure::alarm: return stop_itself(run, p);
        case Procedure::abort: return abort(run, p);
        case Procedure::master_spindle:
            return select_master(run, p.arguments.empty() || p.arguments[0] == program::no_expr
                                          ? std::nullopt
                                          : std::optional(number(run, p.arguments[0])));
        case Procedure::wait_axes: return wait_for_axes(run, p);
        case Procedure::run_text: return run_text(run, p);
        case Procedure::select_datums: run.datum_table = base::to_upper(text_of(run, p, 0)); return;
        case Procedure::set_datum: return set_own_datum(run, p);
        case Procedure::print_form: return print_form(run, p);
        case Procedure::print_values: return print_values(run, p);
        case Procedure::open_table: return open_table(run, p);
        case Procedure::write_table: return write_table(run, p);
        case Procedure::read_table: return read_table(run, p);
        case Procedure::log_open:
        case Procedure::log_append:
        case Procedure::log_close:
        case Procedure::log: return log(run, p);
        case Procedure::probe_log_open:
        case Procedure::probe_log_close:
            return assume(run, p.where, "what probing finds is not simulated: nothing is written to its log");
    }
}

}  // namespace obrys::interp
