// Any bytes are read without crash; every span lies inside the text and every number inside its table.
#include "check_unit.hpp"
#include "read/sinumerik/read.hpp"

using namespace obrys;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    base::Sources sources;
    const auto file = sources.add("FUZZ.MPF", std::string(data, data + size), base::BlockNumbers::n_word);
    program::Names names;
    base::Diagnostics diagnostics;
    const auto units = read::sinumerik::read(file, sources, names, diagnostics);
    const std::size_t length = sources[file].text.size();
    for (const program::Unit& u : units) fuzz::check_unit(u, length);
    for (const base::Diagnostic& d : diagnostics.all())
        fuzz::check_span(d.where, length), (void)base::render(d, sources);
    const int score = read::sinumerik::likelihood(sources[file].text, "FUZZ.MPF");
    fuzz::require(score >= 0 && score <= 100);
    return 0;
}
