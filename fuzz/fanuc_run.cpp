// Any bytes are read as a FANUC program of a mill and of a lathe and as a Haas program, and run within their budget;
// the stream keeps its rules.
#include "run_case.hpp"

using namespace obrys;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    (void)fuzz::run_text("FUZZ.NC", text, fuzz::mill_job("FUZZ.NC", "fanuc"));
    (void)fuzz::run_text("FUZZ.NC", text, fuzz::job_of("FUZZ.NC", "fanuc", "lathe-generic"));
    (void)fuzz::run_text("FUZZ.NC", text, fuzz::mill_job("FUZZ.NC", "haas"));
    return 0;
}
