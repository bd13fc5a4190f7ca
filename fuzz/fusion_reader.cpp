// Any bytes are listed, and any text is read as a listing, without crash; every span lies inside the text and every
// number inside its table. The listing of bytes is no longer than it may be, and its lines are its records.
#include <algorithm>

#include "check_unit.hpp"
#include "read/fusion/listing.hpp"
#include "read/fusion/read.hpp"

using namespace obrys;

namespace {

void read_text(std::string text) {
    base::Sources sources;
    const auto file = sources.add("FUZZ.CNC", std::move(text));
    program::Names names;
    base::Diagnostics diagnostics;
    const program::Unit unit = read::fusion::read(file, sources, names, diagnostics);
    const std::size_t length = sources[file].text.size();
    fuzz::check_unit(unit, length);
    for (const base::Diagnostic& d : diagnostics.all())
        fuzz::check_span(d.where, length), (void)base::render(d, sources);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(data, data + size);
    read_text(bytes);
    if (!read::fusion::is_intermediate(bytes)) return 0;
    constexpr std::size_t most = 1 << 20;
    auto listing = read::fusion::listing_of(bytes, most);
    if (!listing) return 0;
    fuzz::require(listing->size() <= most && listing->ends_with('\n'));
    fuzz::require(listing->find('\0') == std::string::npos);
    fuzz::require(read::fusion::likelihood(*listing, "FUZZ.CNC") == 100);
    read_text(std::move(*listing));
    return 0;
}
