// Any bytes are checked as a SINUMERIK turning program with a small bar and part: what has errors is not clean,
// findings stand in their order, the stock does not grow, no figure is NaN.
#include "run_case.hpp"

using namespace obrys;

namespace {

constexpr std::string_view shop = R"([[tool]]
number = 1
kind = "turning"
nose_radius = 0.8
[[tool]]
number = 2
kind = "groove"
width = 3.0
corner_radius = 0.2
[[tool]]
number = 3
kind = "turning"
orientation = 2
nose_radius = 0.4
[stock]
bar = { diameter = 40.0, length = 50.0 }
[part]
profile = [ {z = -50.0, x = 18.0}, {z = -20.0, x = 18.0}, {z = -20.0, x = 12.0, r = 3.0}, {z = -17.0, x = 9.0}, {z = 0.0, x = 9.0} ]
)";

const std::string job = "program = \"FUZZ.MPF\"\ncontrol = \"sinumerik-840d\"\nmachine = \"lathe-generic\"\n" +
                        std::string(fuzz::limits) + std::string(shop);

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    fuzz::check_case("FUZZ.MPF", text, job);
    return 0;
}
