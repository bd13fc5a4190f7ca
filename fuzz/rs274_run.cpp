// Any bytes are read as a LinuxCNC program and run within their budget; the stream keeps its rules.
#include "run_case.hpp"

using namespace obrys;

namespace {

constexpr std::string_view tools = R"([[tool]]
number = 1
kind = "end-mill"
diameter = 6.0
length = 40.0
cutting_length = 20.0
holder = [{ diameter = 30.0, length = 30.0 }]
[[tool]]
number = 2
kind = "drill"
diameter = 5.0
length = 50.0
[[tool]]
number = 3
kind = "tap"
diameter = 6.0
pitch = 1.0
length = 50.0
)";

const std::string job = "program = \"FUZZ.NGC\"\ncontrol = \"linuxcnc\"\nmachine = \"mill-generic\"\n" +
                        std::string(fuzz::limits) + std::string(tools);

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    (void)fuzz::run_text("FUZZ.NGC", text, job);
    return 0;
}
