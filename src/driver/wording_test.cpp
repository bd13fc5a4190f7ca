#include "driver/wording.hpp"

#include <gtest/gtest.h>

#include "driver/control.hpp"

namespace obrys::driver {
namespace {

/// No control's programmer reads a word of another control.
TEST(Wording, HasNoForeignWords) {
    const std::string all =
        "a circle needs its centre (I, J, K), its radius (CR=) or its opening angle (AR=); "
        "lathe-generic is taken, X words are diameters until DIAMOF";
    for (const Control& c : all_controls()) {
        const std::string said = in_words_of(c.name, all);
        const bool sinumerik = c.name == "sinumerik-840d";
        for (const char* word : {"CR=", "AR=", "DIAMOF"})
            EXPECT_EQ(said.find(word) != std::string::npos, sinumerik) << c.name << ": " << said;
    }
}

TEST(Wording, NamesTheControlsOwnWay) {
    check::Result r;
    r.findings.resize(1);
    r.findings[0].remedy = "select a tool with T and D before it";
    reword(r, "heidenhain-itnc530");
    EXPECT_EQ(r.findings[0].remedy, "call a tool with TOOL CALL before it (DIN/ISO: T … G17)");
}

}  // namespace
}  // namespace obrys::driver
