/// What old editors leave behind the last line of a program (Ctrl-Z, CP/M's end of text) is nothing, on every control.

#include <gtest/gtest.h>

#include "cl/text.hpp"
#include "driver/golden_cases_testing.hpp"

namespace obrys::driver {
namespace {

using testing::Case;

std::string outcome(const Case& c, std::string_view control, shop::MachineKind kind) {
    Session s;
    if (!testing::open_case(s, c, control, kind)) return "no program";
    std::string out;
    const auto end = interpret(s, [&](const cl::Record& r) {
        const std::string line = cl::to_text(r);
        out += line.substr(0, line.find(" @")) + "\n";
    });
    out += std::to_string(static_cast<int>(end.ending)) + "\n";
    for (const base::Diagnostic& d : s.diagnostics.all())
        out += d.text + " at " + std::to_string(s.sources.position(d.where).line) + "\n";
    return out;
}

/// Every golden case of a folder, with and without an end sign behind it: no difference.
void compare_with_sign(std::string_view control, const std::string& folder,
                       shop::MachineKind kind = shop::MachineKind::mill) {
    std::size_t compared = 0;
    for (const Case& c : testing::golden_cases(folder)) {
        if (!c.text.ends_with('\n')) continue;
        const std::string plain = outcome(c, control, kind);
        for (const char* sign : {"\x1A", "\x1A\x1A\r\n"}) {
            Case with = c;
            with.text += sign;
            EXPECT_EQ(outcome(with, control, kind), plain) << folder << "/" << c.name;
        }
        ++compared;
    }
    EXPECT_GT(compared, 50U) << folder;
}

TEST(EndSign, SaysNothingOnSinumerik) { compare_with_sign("sinumerik-840d", "sinumerik"); }
TEST(EndSign, SaysNothingOnHeidenhain) { compare_with_sign("heidenhain-itnc530", "heidenhain"); }
TEST(EndSign, SaysNothingOnLinuxcnc) { compare_with_sign("linuxcnc", "linuxcnc"); }
TEST(EndSign, SaysNothingOnFanuc) { compare_with_sign("fanuc", "fanuc"); }
TEST(EndSign, SaysNothingOnFanucLathes) { compare_with_sign("fanuc", "fanuc", shop::MachineKind::lathe); }
TEST(EndSign, SaysNothingOnHaas) { compare_with_sign("haas", "fanuc"); }

/// Behind it the text goes on: what is said there is not lost.
TEST(EndSign, WithinTheTextIsNoEnd) {
    const std::string sign = "\x1A";
    struct Program {
        std::string_view control, file;
        std::string text;
    };
    const Program programs[] = {
        {"sinumerik-840d", "T.MPF", "G0 X1 Y1 " + sign + " Z1\nM30\n"},
        {"heidenhain-itnc530", "T.H", "0 BEGIN PGM T MM\n1 L X+1 Y+1 " + sign + " Z+1 FMAX\n2 END PGM T MM\n"},
        {"linuxcnc", "T.NGC", "G0 X1 Y1 " + sign + " Z1\nM2\n"},
        {"fanuc", "T.NC", "%\nO1\nG0 X1. Y1. " + sign + " Z1.\nM30\n%\n"},
    };
    for (const Program& p : programs) {
        std::string without = p.text;
        const std::size_t at = p.text.find(" " + sign);
        without.erase(at, p.text.find('\n', at) - at);
        const Case with{"", std::string(p.file), p.text}, cut{"", std::string(p.file), without};
        EXPECT_NE(outcome(with, p.control, shop::MachineKind::mill), outcome(cut, p.control, shop::MachineKind::mill))
            << p.control << ": Z is lost without a word";
    }
}

}  // namespace
}  // namespace obrys::driver
