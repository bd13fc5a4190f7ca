// Any bytes are read as an intermediate file and run within their budget; the stream keeps its rules.
#include "run_case.hpp"

using namespace obrys;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    (void)fuzz::run_text("FUZZ.CNC", text, fuzz::mill_job("FUZZ.CNC", "fusion"));
    return 0;
}
