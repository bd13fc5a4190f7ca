#include "check/touching/rapid_way.hpp"

#include "base/number.hpp"

namespace obrys::check {

std::string bent_as_delivered(const Setup& setup) {
    const bool lathe = setup.machine.kind == shop::MachineKind::lathe;
    std::string speeds;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{2}})
        if (!lathe || k != 1)
            speeds += (speeds.empty() ? "" : ", ") + std::string(1, "XYZ"[k]) + " " +
                      base::shortest(motion::rapid_rate(setup.machine, k));
    return "rapids of several axes bend, as this control is delivered (" + setup.rapids.setting +
           "): each axis goes at its own rapid, " + speeds + " mm/min; rapid in the machine file says otherwise";
}

std::string met_if_bent(const Setup& setup, const std::string& what) {
    const std::string& setting = setup.rapids.setting;
    return "whether this rapid is clear depends on the machine: straight it is, but with each axis at its own rapid" +
           (setting.empty() ? "" : " (" + setting + ")") + " the " + what;
}

}  // namespace obrys::check
