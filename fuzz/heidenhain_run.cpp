// Any bytes are read as Klartext and as DIN/ISO and run within their budget; the stream keeps its rules.
#include "run_case.hpp"

using namespace obrys;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const std::string_view name : {"FUZZ.H", "FUZZ.I"})
        (void)fuzz::run_text(name, text, fuzz::mill_job(name, "heidenhain-itnc530"));
    return 0;
}
