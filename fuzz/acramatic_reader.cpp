// Any bytes are read as an Acramatic 2100 program without crash; every span
// lies inside the text and every number inside its table.
#include "check_unit.hpp"
#include "read/rs274/acramatic_read.hpp"

using namespace obrys;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      std::size_t size) {
  base::Sources sources;
  const auto file = sources.add("FUZZ.NC", std::string(data, data + size),
                                base::BlockNumbers::n_word);
  program::Names names;
  base::Diagnostics diagnostics;
  const auto units =
      read::rs274::read_acramatic(file, sources, names, diagnostics);
  fuzz::check_one_part(
      units, sources, file, diagnostics,
      read::rs274::acramatic_likelihood(sources[file].text, "FUZZ.NC"));
  return 0;
}
