// What fmt makes of any program runs as the program did: the same stream.
#include "format/heidenhain/format.hpp"
#include "run_case.hpp"

using namespace obrys;

namespace {

void compare(std::string_view name, const std::string& text) {
    const auto language = format::heidenhain::language_of(text, name);
    if (!language) return;  // fmt refuses it
    const std::string first = fuzz::run_text(name, text, fuzz::mill_job(name, "heidenhain-itnc530"));
    const format::heidenhain::Formatted tidy = format::heidenhain::formatted(text, *language, {});
    const std::string second = fuzz::run_text(name, tidy.text, fuzz::mill_job(name, "heidenhain-itnc530"));
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
