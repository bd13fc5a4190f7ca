// FANUC and Haas programs: any bytes are read without crash, as mill and as lathe; every span lies inside the text and
// every number inside its table.
#include "check_unit.hpp"
#include "read/rs274/fanuc/read.hpp"

using namespace obrys;

namespace {

void check(const base::Sources& sources, std::uint32_t file, const read::rs274::FanucOptions& options, bool haas) {
    program::Names names;
    base::Diagnostics diagnostics;
    const std::vector<program::Unit> units = haas ? read::rs274::read_haas(file, sources, names, diagnostics, options)
                                                  : read::rs274::read_fanuc(file, sources, names, diagnostics, options);
    const std::size_t length = sources[file].text.size();
    fuzz::require(!units.empty());
    for (const program::Unit& unit : units) fuzz::check_unit(unit, length);
    for (const base::Diagnostic& d : diagnostics.all())
        fuzz::check_span(d.where, length), (void)base::render(d, sources);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using dialect::rs274::FanucMachine;
    base::Sources sources;
    const auto file = sources.add("FUZZ.NC", std::string(data, data + size), base::BlockNumbers::n_word);
    check(sources, file, {.machine = FanucMachine::mill}, false);
    check(sources, file, {.machine = FanucMachine::mill}, true);
    for (const auto system : {dialect::rs274::GSystem::a, dialect::rs274::GSystem::c})
        check(sources, file, {.machine = FanucMachine::lathe, .system = system}, false);
    const std::string_view text = sources[file].text;
    for (const int score :
         {read::rs274::fanuc_likelihood(text, "FUZZ.NC"), read::rs274::haas_likelihood(text, "FUZZ.NC")})
        fuzz::require(score >= 0 && score <= 100);
    return 0;
}
