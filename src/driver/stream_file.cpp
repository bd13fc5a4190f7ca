#include "driver/stream_file.hpp"

#include <fstream>
#include <utility>

#include "driver/files.hpp"
#include "driver/session_files.hpp"
#include "shop/files/obrys/machine_file.hpp"

namespace obrys::driver {

bool is_stream(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string begin(7, ' ');
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return in.gcount() == 7 && cl::text_header.starts_with(begin);
}

bool open_stream(const Request& request, Session& session) {
    session.storage = request.folders->storage();
    session.program = session.input = request.input;
    if (!load(*session.storage, request.input, session.sources, session.diagnostics)) return false;
    bool named = false;
    if (!load_named_machine(session, request, request.input, named)) return false;
    if (named) return true;
    shop::use_machine(session.job, *shop::shipped_machine("mill-generic"));
    session.job.machine.more_axes = true;
    return true;
}

StreamReader::StreamReader(Session& session) : session_(session), reader_(session.sources, 0, session.diagnostics) {}

bool StreamReader::step(cl::Sink sink) {
    const bool more = reader_.step([&](const cl::Record& record) {
        placed_ = record;  // mostly a move behind a move: nothing is allocated
        placed_.from = reader_.line();
        placed_.stack = 0;
        verifier_(placed_);
        hand_on();
        sink(record);
    });
    if (!more && !std::exchange(ended_, true)) verifier_.finish(), hand_on();
    return more;
}

void StreamReader::hand_on() {
    for (; handed_on_ < found_.all().size(); ++handed_on_) {
        base::Diagnostic d = found_.all()[handed_on_];
        d.text = "no stream of a program holds this: " + d.text;
        d.remedy = "write the stream anew (obrys run --format text), or mend this line";
        session_.diagnostics.add(std::move(d));
    }
}

interp::Outcome stream_of(Session& session, cl::Sink sink) {
    if (session.main != nullptr) return interpret(session, sink);
    StreamReader reader(session);
    cl::Record placed;
    base::Span of_program, here;  // the places of a program that is not at hand: records of one block stay together
    const auto place = [&](const cl::Record& record) {
        if (!(record.from == of_program)) here = reader.line();
        of_program = record.from;
        placed = record;  // mostly a move behind a move: nothing is allocated
        placed.from = here;
        placed.stack = 0;
        sink(placed);
    };
    while (reader.step(place)) {
    }
    return {};
}

}  // namespace obrys::driver
