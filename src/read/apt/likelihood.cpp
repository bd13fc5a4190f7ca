#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "read/apt/read.hpp"

namespace obrys::read::apt {

namespace {

struct Sign {
    std::string_view word;  ///< without blanks
    int weight = 6;
};
constexpr std::array telling{
    Sign{"GOTO/", 15},   Sign{"FEDRAT/", 12},         Sign{"SPINDL/", 10}, Sign{"LOADTL/", 10},  Sign{"CUTTER/", 8},
    Sign{"CYCLE/", 8},   Sign{"COOLNT/", 6},          Sign{"CUTCOM/", 6},  Sign{"LOAD/TOOL", 8}, Sign{"TLAXIS/", 6},
    Sign{"MULTAX", 4},   Sign{"\nFINI", 8},           Sign{"PARTNO", 6},   Sign{"UNITS/", 4},    Sign{"TOOLPATH/", 12},
    Sign{"GODLTA/", 12}, Sign{"CATIAAPTVERSION", 30},
};
constexpr std::array<std::string_view, 8> suffixes{".APT",    ".APTSOURCE", ".NCL", ".CLS",
                                                   ".CLDATA", ".CL",        ".CLF", ".APTCL"};

}  // namespace

int likelihood(std::string_view text, std::string_view file_name, std::vector<std::string>* signs) {
    const std::string name = base::to_upper(file_name);
    int score = 0;
    for (const std::string_view suffix : suffixes)
        if (name.ends_with(suffix)) score = 30;
    std::string packed;
    for (const char c : text.substr(0, base::telling_bytes))
        if (!base::is_blank(c) && c != '\r') packed += base::upper(c);
    for (const Sign& sign : telling) {
        if (packed.find(sign.word) == std::string::npos) continue;
        score += sign.weight;
        if (signs != nullptr) signs->emplace_back(base::trim(sign.word));
    }
    return std::clamp(score, 0, 100);
}

}  // namespace obrys::read::apt
