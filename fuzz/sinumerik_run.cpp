// Any bytes are read as a SINUMERIK program and run within their budget; the stream keeps its rules.
#include "run_case.hpp"

using namespace obrys;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const std::string_view machine : {"mill-generic", "lathe-generic"})
        (void)fuzz::run_text("FUZZ.MPF", text, fuzz::job_of("FUZZ.MPF", "sinumerik-840d", machine));
    return 0;
}
