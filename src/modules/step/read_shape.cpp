#include "modules/step/read_shape.hpp"

#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <charconv>
#include <istream>
#include <sstream>
#include <streambuf>
#include <string_view>

namespace obrys::modules::step {

namespace {

/// Bytes in memory as a stream, without a copy.
class Bytes : public std::streambuf {
public:
    Bytes(const char* begin, std::size_t size) {
        char* from = const_cast<char*>(begin);  // a streambuf that is only read does not write there
        setg(from, from, from + size);
    }
};

/// What Open CASCADE would print is kept instead, as far as it is a complaint.
class Listener : public Message_Printer {
public:
    Listener() { SetTraceLevel(Message_Fail); }

    /// The first complaint as one line, without Open CASCADE's ornaments; empty where there was none.
    std::string first() const {
        std::string line;
        std::istringstream in(said_);
        while (line.empty() && std::getline(in, line)) {
            line.erase(0, std::min(line.find_first_not_of(" *\t"), line.size()));
            while (!line.empty() && (line.back() == ' ' || line.back() == '\r' || line.back() == '*')) line.pop_back();
        }
        return line.substr(0, longest_line);
    }

protected:
    void send(const TCollection_AsciiString& text, const Message_Gravity gravity) const override {
        if (gravity >= Message_Fail && said_.size() < most) said_.append(text.ToCString()).push_back('\n');
    }

private:
    static constexpr std::size_t longest_line = 200, most = 10'000;
    mutable std::string said_;
};

/// "Undefined Parsing: Line 446: Incorrect syntax: unexpected QUID, expecting ')'": the line, and what stands behind
/// it.
[[noreturn]] void refuse_syntax(std::string_view said) {
    constexpr std::string_view before = "Line ";
    Refusal out{mesh::obrys_step_syntax, "the STEP file is damaged", 0};
    if (const std::size_t at = said.find(before); at != std::string_view::npos) {
        const std::string_view rest = said.substr(at + before.size());
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), out.line);
        if (error == std::errc{}) said = rest.substr(static_cast<std::size_t>(end - rest.data()));
        said.remove_prefix(std::min(said.find_first_not_of(": "), said.size()));
    }
    out.text.append(": ").append(said);
    throw out;
}

/// Entries that were read with complaints. What does not follow the grammar is refused: it was left out or taken for
/// something else, and Open CASCADE is prone to crash on it.
std::uint64_t complaints_of(const STEPControl_Reader& reader) {
    std::uint64_t count = 0;
    Interface_CheckIterator checks = reader.WS()->ModelCheckList();
    for (checks.Start(); checks.More(); checks.Next()) {
        const Handle(Interface_Check)& check = checks.Value();
        if (check->NbFails() > 0) ++count;
        for (int i = 1; i <= check->NbFails(); ++i) {
            const std::string_view said = check->CFail(i);
            if (said.find("ncorrect syntax") != said.npos || said.find("SEVERAL TIMES") != said.npos)
                refuse_syntax(said);
        }
    }
    return count;
}

/// Without it Open CASCADE would take millimetres.
bool says_its_unit(STEPControl_Reader& reader) {
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    bool said = !lengths.IsEmpty();
    for (const TCollection_AsciiString& name : lengths) said = said && !name.IsEmpty();
    return said;
}

}  // namespace

ReadShape read_shape(const char* bytes, std::size_t size) {
    const Handle(Listener) listener = new Listener;
    Message::DefaultMessenger()->ChangePrinters().Clear();
    Message::DefaultMessenger()->AddPrinter(listener);
    STEPControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    Bytes buffer(bytes, size);
    std::istream in(&buffer);
    if (reader.ReadStream("STEP", in) != IFSelect_RetDone)
        throw Refusal{mesh::obrys_step_syntax, with("the STEP file cannot be read", listener->first())};
    ReadShape out;
    out.complaints = complaints_of(reader);
    reader.TransferRoots();
    out.shape = reader.OneShape();
    if (out.shape.IsNull())
        throw Refusal{mesh::obrys_step_no_solid,
                      with("the STEP file holds no shape that can be read", listener->first())};
    if (!says_its_unit(reader)) throw Refusal{mesh::obrys_step_syntax, "the STEP file does not say its unit of length"};
    return out;
}

}  // namespace obrys::modules::step
