// Any bytes are read as APT cutter locations without crash; every span lies inside the text and every number inside its
// table.
#include "check_unit.hpp"
#include "read/apt/read.hpp"

using namespace obrys;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    base::Sources sources;
    const auto file = sources.add("FUZZ.APT", std::string(data, data + size));
    program::Names names;
    base::Diagnostics diagnostics;
    const program::Unit unit = read::apt::read(file, sources, names, diagnostics);
    const std::size_t length = sources[file].text.size();
    fuzz::check_unit(unit, length);
    for (const base::Diagnostic& d : diagnostics.all())
        fuzz::check_span(d.where, length), (void)base::render(d, sources);
    const int score = read::apt::likelihood(sources[file].text, "FUZZ.APT");
    fuzz::require(score >= 0 && score <= 100);
    return 0;
}
