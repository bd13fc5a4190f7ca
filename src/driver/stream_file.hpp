#pragma once
/// CL streams in their text form, in the place of programs.

#include <optional>
#include <string>

#include "cl/text.hpp"
#include "cl/verify.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// Whether the file is a CL stream in its text form.
[[nodiscard]] bool is_stream(const std::string& file);
/// Loads one in the place of a program, with the machine that the request names; false, with what is wrong in the
/// session's diagnostics, where it cannot be read. Session::main stays null.
bool open_stream(const Request& request, Session& session);
/// The records of a session's stream, a few at a time, each held to the rules of the stream: what breaks one is
/// complained about with its line in the text, and all the same handed on.
class StreamReader {
public:
    explicit StreamReader(Session& session);
    /// False behind the last.
    bool step(cl::Sink sink);
    /// Where the line of the last record stands in the text.
    [[nodiscard]] base::Span line() const { return reader_.line(); }

private:
    void hand_on();

    Session& session_;
    cl::TextReader reader_;
    base::Diagnostics found_;
    cl::Verifier verifier_{found_};
    std::size_t handed_on_ = 0;
    cl::Record placed_;
    bool ended_ = false;
};
/// The records of a session: of its program, which is run, or of its stream.
interp::Outcome stream_of(Session& session, cl::Sink sink);

}  // namespace obrys::driver
