// What fmt makes of any program runs as the program did: the same stream.
#include "format/heidenhain/format.hpp"
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

std::string job(std::string_view name) {
    return "program = \"" + std::string(name) + "\"\ncontrol = \"heidenhain-itnc530\"\nmachine = \"mill-generic\"\n" +
           std::string(fuzz::limits) + std::string(tools);
}

void compare(std::string_view name, const std::string& text) {
    const auto language = format::heidenhain::language_of(text, name);
    if (!language) return;  // fmt refuses it
    const std::string first = fuzz::run_text(name, text, job(name));
    const format::heidenhain::Formatted tidy = format::heidenhain::formatted(text, *language, {});
    const std::string second = fuzz::run_text(name, tidy.text, job(name));
    if (first == second) return;
    std::cerr << first << "-- formatted\n" << tidy.text << "-- gives\n" << second;
    fuzz::require(false, "the formatted program runs as it did");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const std::string_view name : {"FUZZ.H", "FUZZ.I"}) compare(name, text);
    return 0;
}
