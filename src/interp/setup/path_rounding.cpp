/// By how much the control itself leaves the programmed path: continuous-path mode with rounding, compressors,
/// CYCLE832, CYCL DEF 32, LinuxCNC's G64, G187 of Haas. The run follows the programmed path; where the deviation may
/// exceed what the check looks at, it is said with its amount. Source: SINUMERIK Fundamentals 10.2004, p. 5-8 (ADIS,
/// ADISPOS), Basic Functions 01/2015, p. 193 (G642, G643).

#include <array>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace {

struct Rounding {
    std::string word;   ///< as programmed
    double amount = 0;  ///< mm; NaN: not known, `because` says why
    bool at_corners = true;
    std::string because = "by what the machine's data allow, which are not known here (MD33100, CTOL)";
    std::string remedy{};       ///< where the amount is not known
    bool is_tolerance = false;  ///< of the whole path, as the program says it; else a distance at corners
};

std::string shown(double mm) { return base::fixed(mm, 3) + " mm"; }

/// CTOL, else the tolerance of the machine's axes.
double tolerance_of_machine(const Reckoning& run) {
    if (!std::isnan(run.modal.contour_tolerance)) return run.modal.contour_tolerance;
    const auto found = run.env.machine.machine_data.find("$MA_COMPRESS_POS_TOL");
    return found == run.env.machine.machine_data.end() ? unknown_number : found->second;
}

/// That of a cycle or G187; none while the control stops exactly at corners (G61). Infinite: how much is not known.
double tolerance_in_force(const ModalState& m) { return m.path_mode == Modal::path_blend ? m.tolerance_cycle : 0; }

Rounding rounding_of(const Reckoning& run) {
    const ModalState& m = run.modal;
    const bool rapid = m.motion == Modal::rapid;
    if (const double most = tolerance_in_force(m); most > 0 && !std::isfinite(most))
        return {std::string(m.tolerance_by), unknown_number, true,
                "at corners by the machine's setting 85 or a value that is not known here",
                "write E, the largest rounding of a corner"};
    else if (most > 0)
        return {.word = std::string(m.tolerance_by), .amount = most, .at_corners = false, .is_tolerance = true};
    if (m.compressor && !rapid) return {"the compressor (COMPON, COMPCURV, COMPCAD)", tolerance_of_machine(run), false};
    const double distance = rapid ? m.rounding_distance_rapid : m.rounding_distance;
    const std::string by = rapid ? "ADISPOS" : "ADIS";
    const std::string word = "G" + std::to_string(m.smoothing);
    if (m.smoothing == 641) return {word + " with " + by, distance};
    if (m.smoothing == 643 && distance > 0) return {word + " with " + by, distance};
    if (m.smoothing == 64)
        return {word, unknown_number, true, "at corners as far as its axes' speeds and accelerations need"};
    if (m.smoothing == 644) return {word, unknown_number};
    if (m.smoothing > 641) return {word, tolerance_of_machine(run)};
    if (m.path_mode == Modal::path_blend && m.blend > 0)
        return {.word = "G64 with P", .amount = m.blend, .at_corners = false, .is_tolerance = true};
    if (m.path_mode == Modal::path_blend && m.blend_free)
        return {"G64 without P", unknown_number, true, "without a limit, as far as its speed needs",
                "write G64 P and the tolerance"};
    return {};
}

}  // namespace

void note_rounding(Moving& run) {
    const ModalState& m = run.modal;
    const bool rapid = m.motion == Modal::rapid;
    const std::array<double, 7> mode{static_cast<double>(m.smoothing),
                                     rapid ? m.rounding_distance_rapid : m.rounding_distance,
                                     m.compressor ? 1.0 : 0.0,
                                     std::isnan(m.contour_tolerance) ? -1 : m.contour_tolerance,
                                     tolerance_in_force(m),
                                     m.path_mode == Modal::path_blend ? m.blend : 0,
                                     m.blend_free ? 1.0 : 0.0};
    auto& said = run.rounding_said[rapid ? 1 : 0];
    if (run.capture != nullptr || said == mode) return;
    said = mode;
    const Rounding r = rounding_of(run);
    if (!(r.amount > run.env.contour_tolerance || std::isnan(r.amount))) return;
    const std::string how_far = std::isnan(r.amount) ? r.because
                                : r.at_corners
                                    ? "from up to " + shown(r.amount) + " before a corner to as far behind it"
                                    : "by up to " + shown(r.amount);
    assume(run, run.here(),
           r.word + " lets the control leave the programmed path " + how_far + ": the run follows the programmed one",
           std::isnan(r.amount) ? r.remedy : "what is checked holds to that amount");
    constexpr double most_meant = 1;  // mm: roughing has tenths
    if (r.is_tolerance && r.amount > most_meant)
        doubt(run, base::codes::value_range, run.here(),
              r.word + " allows the control " + shown(r.amount) + " beside the programmed path: hardly any part does",
              "see where the decimal point of the tolerance stands");
}

}  // namespace obrys::interp
