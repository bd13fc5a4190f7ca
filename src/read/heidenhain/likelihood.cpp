#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "read/heidenhain/read.hpp"

namespace obrys::read::heidenhain {

namespace {

constexpr std::array<std::string_view, 12> own{"BEGIN PGM", "END PGM",  "TOOL CALL", "BLK FORM", "CYCL DEF", "CALL LBL",
                                               "CYCL CALL", "CALL PGM", "FMAX",      "FN ",      "LBL ",     " DR+"};

int count(std::string_view text, std::string_view what) {
    int n = 0;
    for (std::size_t at = text.find(what); at != std::string_view::npos && n < 3;
         at = text.find(what, at + what.size()))
        ++n;
    return n;
}

}  // namespace

int likelihood(std::string_view text, std::string_view file_name, std::vector<std::string>* signs) {
    const std::string name = base::to_upper(file_name);
    int score = name.ends_with(".H") ? 30 : 0;
    const std::string upper = base::to_upper(text.substr(0, base::telling_bytes));
    if (upper.find("BEGIN PGM") != std::string::npos) score += 50;
    for (const std::string_view w : own) {
        const int n = count(upper, w);
        score += 6 * n;
        if (n > 0 && signs != nullptr) signs->emplace_back(base::trim(w));
    }
    if (upper.find("G01") != std::string::npos || upper.find("G1 ") != std::string::npos) score -= 20;
    return std::clamp(score, 0, 100);
}

}  // namespace obrys::read::heidenhain
