#include "driver/compare_programs.hpp"

#include <fstream>

#include "cl/text.hpp"
#include "driver/files.hpp"

namespace obrys::driver {

compare::Path path_of(Session& session, double same_place) {
    compare::Path path(same_place);
    static_cast<void>(interpret(session, [&](const cl::Record& record) { path.take(record); }));
    return path;
}

bool is_stream(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string begin(7, ' ');
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return in.gcount() == 7 && cl::text_header.starts_with(begin);
}

bool read_stream(const std::string& file, Session& session, compare::Path& path) {
    session.program = session.input = file;
    const std::optional<std::uint32_t> text = load(*session.storage, file, session.sources, session.diagnostics);
    if (!text) return false;
    cl::read_text(
        session.sources, *text, [&](const cl::Record& record) { path.take(record); }, session.diagnostics);
    return true;
}

}  // namespace obrys::driver
