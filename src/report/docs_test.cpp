/// Every code stands in docs/diagnostics.md, every key of an amount in docs/report-json.md.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/codes.hpp"
#include "report/subject.hpp"

namespace obrys::report {
namespace {

std::string document(const std::string& name) {
    std::ifstream file(OBRYS_SOURCE_DIR "/docs/" + name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Docs, EveryCodeIsDocumented) {
    const std::string text = document("diagnostics.md");
    for (const base::Code& c : base::all_codes)
        EXPECT_NE(text.find("`" + std::string(c.name) + "`"), std::string::npos) << c.name;
}

TEST(Docs, EveryAmountHasWordsAndIsDocumented) {
    const std::string text = document("report-json.md");
    for (const char* key : {"depth_mm", "depth_x_mm", "area_mm2", "volume_mm3", "contact_length_mm", "z_mm", "x_mm",
                            "z_from_mm", "z_to_mm", "width_mm", "way_mm", "pitch_mm", "excess_mm", "excess_deg", "speed_rpm",
                            "limit_rpm", "feed_mm_per_min", "limit_mm_per_min"}) {
        EXPECT_NE(text.find("`" + std::string(key) + "`"), std::string::npos) << key;
        EXPECT_NE(amount_words(key).unit, "") << key;
    }
}

}  // namespace
}  // namespace obrys::report
