/// H and D of controls that keep them until other ones are programmed (Traits::offset_numbers_stay).
/// Source: FANUC series 16i/18i-M operator's manual, tool length offset and cutter compensation: the offset numbers are
/// modal [-].

#include <cmath>
#include <cstdint>
#include <string>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// What an expression gives for H or D may be no number of an offset.
double offset_number(Moving& run, Code letter) {
    const double n = run.block.get(letter);
    if (std::isfinite(n) && !base::whole<std::int32_t>(n))
        alarm(run, codes::value_range, run.here(),
              "there is no offset " + std::string(letter == Code::offset_h ? "H" : "D") + printed(Value::real(n)) +
                  ": a whole number of at most 9 digits is due");
    return n;
}

}  // namespace

std::optional<double> length_number(Moving& run) {
    const BlockWords& b = run.block;
    double& kept = run.offsets.number;
    if (b.has(Code::offset_h)) return kept = offset_number(run, Code::offset_h);
    if (!run.traits->offset_numbers_stay) return std::nullopt;
    if (!std::isnan(kept)) return kept;
    unchecked(run, codes::unknown_value, run.here(),
              "which length G43 means is not known: no H stands in the program before it, and the control keeps the "
              "last one it had; that of the tool in the spindle is taken",
              "write H beside G43");
    return std::nullopt;
}

void take_radius_number(Moving& run) {
    const BlockWords& b = run.block;
    double& kept = run.modal.offset_d;
    if (b.has(Code::offset_d)) {
        kept = offset_number(run, Code::offset_d);
        return take_offset_radius(run, kept);
    }
    if (!run.traits->offset_numbers_stay) return;
    if (!std::isnan(kept)) return take_offset_radius(run, kept);
    unchecked(run, codes::unknown_value, run.here(),
              "which radius is meant is not known: no D stands in the program before it, and the control keeps the "
              "last one it had; that of the tool in the spindle is taken",
              "write D beside G41 or G42");
}

void keep_offset_numbers(Moving& run) {
    BlockWords& b = run.block;
    const auto waits = [&](Code c) { return b.has(c) && (b.used >> static_cast<unsigned>(c) & 1u) == 0; };
    if (waits(Code::offset_d) && run.modal.compensation == Modal::compensation_off)
        run.modal.offset_d = offset_number(run, Code::offset_d);
    if (!waits(Code::offset_h)) return;
    if (run.offsets.length == Offsets::Length::none)
        run.offsets.number = offset_number(run, Code::offset_h);
    else
        tool_length_words(run, run.offsets.subtracts ? Modal::tool_length_negative : Modal::tool_length);
}

}  // namespace obrys::interp
