// Any bytes are checked as Klartext, where they begin like that, or as a LinuxCNC program, with a small block and a
// clamp: what has errors is not clean, findings stand in their order, the stock does not grow, no figure is NaN.
#include "run_case.hpp"

using namespace obrys;

namespace {

constexpr std::string_view shop = R"([stock]
box = { min = [0.0, 0.0, -8.0], max = [30.0, 20.0, 0.0] }
[[clamp]]
name = "jaw"
box = { min = [-10.0, 0.0, -8.0], max = [0.0, 20.0, -4.0] }
)";

std::string job(std::string_view name, std::string_view control) {
    return fuzz::mill_job(name, control) + "[check]\ntolerance = 0.2\n" + std::string(shop);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const bool klartext = text.starts_with("BEGIN") || text.starts_with("0 BEGIN");
    const std::string_view name = klartext ? "FUZZ.H" : "FUZZ.NGC";
    fuzz::check_case(name, text, job(name, klartext ? "heidenhain-itnc530" : "linuxcnc"));
    return 0;
}
