#include <algorithm>

#include "read/heidenhain/iso.hpp"
#include "read/heidenhain/read.hpp"

namespace obrys::read::heidenhain {

namespace {

/// `N10 …`: a block of DIN/ISO.
bool is_numbered(std::string_view line) {
    line = base::trim(line);
    if (line.starts_with('/')) line.remove_prefix(1);
    return line.size() > 1 && base::upper(line[0]) == 'N' && base::is_digit(line[1]);
}

/// `%NAME G71 *`; a SINUMERIK archive writes `%_N_NAME_MPF`.
bool is_frame(std::string_view line) {
    const auto percent = line.find('%');
    if (percent == std::string_view::npos || line.find("%_N_") != std::string_view::npos) return false;
    return line.find(" G71", percent) != std::string_view::npos || line.find(" G70", percent) != std::string_view::npos;
}

/// Where `%NAME` stands that begins the program; npos where a block comes first.
std::size_t beginning(std::string_view text) {
    for (std::size_t at = 0; at < std::min<std::size_t>(text.size(), 16384);) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = base::trim(text.substr(at, end - at));
        if (line.starts_with('%')) return at;
        if (is_numbered(line)) return std::string_view::npos;
        at = end + 1;
    }
    return std::string_view::npos;
}

}  // namespace

program::Unit read_iso(std::uint32_t file, const base::Sources& sources, program::Names& names,
                       base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    program::Unit unit = begin_unit(file, source);
    State s{.build = {unit, names, diagnostics, source.text}, .in = Scanner(source.text, true), .iso = {}};
    skip_preface(s, beginning(source.text), "%", diagnostics);
    std::uint32_t aside = 0;
    while (!s.ended && s.in.next_line()) {
        if (s.in.at() - aside > base::Store::piece) aside = lay_aside(s, sources);
        read_iso_block(s);
    }
    check_end(s, "%NAME G71", "N99999999 %NAME", diagnostics);
    s.block = s.in.at();
    flush_pending(s);
    resolve_labels(s);
    lay_aside(s, sources);
    return unit;
}

int iso_likelihood(std::string_view text, std::string_view file_name, std::vector<std::string>* signs) {
    int score = base::to_upper(file_name).ends_with(".I") ? 30 : 0;
    const std::string upper = base::to_upper(text.substr(0, base::telling_bytes));
    int lines = 0, stars = 0, own = 0;
    for (std::size_t at = 0; at < upper.size();) {
        const std::size_t end = std::min(upper.find('\n', at), upper.size());
        const std::string_view line = base::trim(std::string_view(upper).substr(at, end - at));
        at = end + 1;
        if (is_frame(line)) {
            score += 30;
            if (signs != nullptr) signs->emplace_back(line);
        }
        if (line.find("G98 L") != std::string_view::npos || line.find(" P01 ") != std::string_view::npos) ++own;
        if (!is_numbered(line)) continue;
        ++lines;
        if (line.ends_with('*')) ++stars;
    }
    if (lines > 0) score += 50 * stars / lines;
    if (stars > 0 && signs != nullptr) signs->emplace_back("* at the end of lines");
    score += 6 * std::min(own, 4);
    if (upper.find("BEGIN PGM") != std::string::npos) score -= 60;
    return std::clamp(score, 0, 100);
}

}  // namespace obrys::read::heidenhain
