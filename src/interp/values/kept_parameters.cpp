/// Numbered parameters that hold something from before the program (Traits::kept): retained variables, signals, tool
/// data. Source: FANUC B-63684EN, 16.1 and 16.2; Haas 96-8000, page 93 ff.

#include <limits>

#include "base/codes.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;

bool is_absent(const Saying& run, std::uint32_t n) {
    return n >= run.traits->absent_first && n <= run.traits->absent_last && n != 0;
}

bool refuse_absent(Saying& run, std::uint32_t n, const base::Span& where) {
    if (!is_absent(run, n)) return false;
    const auto name = [&](std::uint32_t k) { return program::parameter_name(*run.traits, k); };
    alarm(run, codes::index_range, where,
          "the control has no " + name(n) + ": " + name(run.traits->absent_first) + " to " +
              name(run.traits->absent_last) + " are no parameters");
    return true;
}

bool is_kept_unknown(Reckoning& run, std::uint32_t n) {
    if (run.traits->kept.empty() || run.parameters.is_set(n) || run.parameters.is_known_empty(n)) return false;
    if (holds_all(run)) return false;  // the control's file: what it lacks is 0
    const program::KeptParameters* k = range_of(run, n);
    if (k == nullptr) return false;
    if (k->cleared_by.empty()) return true;
    assume(run, run.statement != nullptr ? run.here() : base::Span{},
           program::parameter_name(*run.traits, k->first) + " to " + program::parameter_name(*run.traits, k->last) +
               (run.traits->empty_parameters ? " are empty when the program begins, as after a reset with "
                                             : " are taken to be 0 when the program begins, with ") +
               std::string(k->cleared_by),
           "give what they hold in [variables] of the job if the control keeps them");
    return false;
}

double kept_parameter(Reckoning& run, std::uint32_t n, const base::Span& where) {
    if (!is_kept_unknown(run, n)) return run.parameters.get(n);
    const std::string name = program::parameter_name(*run.traits, n);
    unchecked(run, codes::unknown_value, where, "what " + name + " holds from before the program is not known",
              "give it in [variables] of the job: \"" + name + "\" = …" +
                  (run.traits->empty_parameters ? ", or \"empty\"" : ""));
    return std::numeric_limits<double>::quiet_NaN();
}

std::optional<ZeroParameter> zero_of(const program::OffsetParameters& p, std::uint32_t n) {
    const auto within = [&](std::uint32_t first, std::uint32_t count) {
        return first != 0 && n >= first && n < first + count * p.datum_step;
    };
    const auto row = [&](std::uint32_t first) { return (n - first) / p.datum_step; };
    const auto axis = [&](std::uint32_t first) { return (n - first) % p.datum_step; };
    if (within(p.external_first, 1)) return ZeroParameter{0, axis(p.external_first)};
    if (within(p.datum_first, p.datum_count))
        return ZeroParameter{number_of_place(row(p.datum_first) + 1), axis(p.datum_first)};
    if (within(p.extended_first, p.extended_count))
        return ZeroParameter{5401 + row(p.extended_first), axis(p.extended_first)};
    return std::nullopt;
}

}  // namespace obrys::interp
