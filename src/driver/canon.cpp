#include "driver/canon.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "write/canon/canon.hpp"

namespace obrys::driver {

interp::Outcome print_canon(Session& s, const std::function<void(std::string_view)>& write_line, bool configured,
                            cl::Sink also) {
    const auto number = [&](const base::Span& at) {
        const auto n = s.sources.block_number(at.file, at.begin);
        return n ? std::to_string(*n) : std::string{};
    };
    write::CanonWriter writer(write_line, number);
    const auto take = [&](const cl::Record& record) {
        writer(record);
        also(record);
    };
    const auto listen = [&](const interp::Heard& what, const base::Span& from) { writer.hear(what, from); };
    const interp::Outcome outcome = interpret(s, take, interp::Listener(listen));
    // A subprogram that is not there was looked for up to the end of the text.
    const auto& said = s.diagnostics.all();
    const bool searched = std::any_of(
        said.begin(), said.end(), [](const base::Diagnostic& d) { return d.code == base::codes::missing_subprogram; });
    writer.finish(percent_lines(s), configured ? 1 : 2, outcome.ending != interp::Ending::regular && !searched);
    return outcome;
}

}  // namespace obrys::driver
