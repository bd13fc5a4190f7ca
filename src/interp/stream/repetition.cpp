/// Brackets about what is repeated.

#include "interp/stream/stream.hpp"

namespace obrys::interp {

void begin_repetition(Telling& run, ActiveSection section) {
    section.pass = 2;
    section.passes = section.left + 1;
    begin_part(run, cl::PartKind::repetition, section.name, section.pass, section.passes);
    run.top().pc = section.first;
    run.top().sections.push_back(std::move(section));
}

}  // namespace obrys::interp
