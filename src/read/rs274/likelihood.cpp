#include <algorithm>
#include <array>
#include <initializer_list>

#include "base/number.hpp"
#include "base/text.hpp"
#include "dialect/rs274/linuxcnc.hpp"
#include "read/rs274/code_numbers.hpp"
#include "read/rs274/read.hpp"

namespace obrys::read::rs274 {

namespace {

/// The text in upper case without blanks and comments, its begin.
std::string code_of(std::string_view text) {
    text = text.substr(0, base::telling_bytes);
    std::string out(text.size(), ' ');
    std::size_t n = 0;
    bool to_end = false, comment = false;
    for (const char c : text) {
        if (c == '\n') to_end = comment = false;
        to_end = to_end || (c == ';' && !comment);
        comment = (comment || c == '(') && c != ')';
        if (!to_end && !comment && c != ')' && !base::is_blank(c) && c != '\r') out[n++] = base::upper(c);
    }
    out.resize(n);
    return out;
}

/// Lines that begin with one of `letters` and a digit, sign, point, `[` or `#`; and all that are not empty.
struct Lines {
    int words = 0, all = 0, o_words = 0, o_numbers = 0;  ///< o_numbers: O1000 alone begins a program
    bool turret = false;                                 ///< T0101: station and offset
};

bool begins_value(char c) { return base::is_digit(c) || c == '-' || c == '+' || c == '.' || c == '[' || c == '#'; }

bool is_o_word(std::string_view line) {
    constexpr std::array<std::string_view, 12> words{"SUB",  "ENDSUB", "CALL",   "WHILE", "ENDWHILE",  "IF",
                                                     "ELSE", "ENDIF",  "REPEAT", "DO",    "ENDREPEAT", "RETURN"};
    if (line.size() < 3 || line[0] != 'O') return false;
    std::size_t i = 1;
    if (line[1] == '<')
        i = line.find('>') == std::string_view::npos ? line.size() : line.find('>') + 1;
    else
        while (i < line.size() && base::is_digit(line[i])) ++i;
    if (i < 2) return false;
    return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return line.substr(i).starts_with(w); });
}

/// T0101 of lathes, behind a block number too.
bool is_turret_word(std::string_view line) {
    if (line.starts_with('N')) line.remove_prefix(std::min(line.find_first_not_of("0123456789", 1), line.size()));
    return line.size() >= 5 && line[0] == 'T' && line[1] == '0' && line[3] == '0' && base::is_digit(line[2]) &&
           base::is_digit(line[4]) && (line.size() == 5 || !base::is_digit(line[5]));
}

Lines count_lines(std::string_view code) {
    constexpr std::string_view letters = "GMXYZFNSTABCIJK#";
    Lines n;
    while (!code.empty()) {
        const std::size_t end = std::min(code.find('\n'), code.size());
        const std::string_view line = code.substr(0, end);
        code.remove_prefix(std::min(end + 1, code.size()));
        if (line.empty() || line == "%") continue;
        ++n.all;
        n.turret = n.turret || is_turret_word(line);
        n.o_words += is_o_word(line);
        n.o_numbers += line.size() > 1 && line[0] == 'O' && base::is_digit(line[1]) && !is_o_word(line);
        const bool named = line.starts_with("#<");
        n.words += named || is_o_word(line) ||
                   (line.size() > 1 && letters.find(line[0]) != std::string_view::npos && begins_value(line[1])) ||
                   (line[0] == '#' && line.size() > 1);
    }
    return n;
}

bool has_any(std::string_view line, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return line.find(w) != line.npos; });
}

bool is_number(std::string_view s) { return s.find_first_not_of("0123456789") == std::string_view::npos; }

/// Of the digits behind a G.
bool selects_motion(std::string_view digits) {
    int g = 0;
    for (std::size_t i = 0; i < digits.size() && i < 3 && base::is_digit(digits[i]); ++i)
        g = 10 * g + (digits[i] - '0');
    return g <= 3 || g == 5 || g == 33 || g == 38 || g == 73 || g == 76 || (g > 80 && g < 90);
}

/// Coordinates before any motion was selected: LinuxCNC begins with G80 and refuses them, others begin with G0.
bool moves_before_motion(std::string_view code) {
    while (!code.empty()) {
        const std::size_t end = std::min(code.find('\n'), code.size());
        const std::string_view line = code.substr(0, end);
        code.remove_prefix(std::min(end + 1, code.size()));
        if (line.starts_with('O') && !is_number(line.substr(1))) return false;
        if (has_any(line, {"#", "[", "=", "M98", "G65", "G10", "G28", "G30", "G52", "G92"})) return false;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            if (line[i] == 'G' && base::is_digit(line[i + 1])) {
                if (selects_motion(line.substr(i + 1))) return false;
            }
            if (std::string_view("XYZ").find(line[i]) != std::string_view::npos && begins_value(line[i + 1]))
                return true;
        }
    }
    return false;
}

/// What other controls write and LinuxCNC does not.
int foreign(std::string_view code) {
    constexpr std::array<std::string_view, 28> words{
        "BEGINPGM", "ENDPGM", "TOOLCALL", "CYCLDEF", "FMAX",   "LBL",    "GOTO", "G65P", "G54.1", "$P_",
        "$AA_",     "$TC_",   "DEFREAL",  "MSG(\"",  "ENDFOR", "DIAMON", "CR=",  "X=",   "Z=",    "POPEN[",
        "CYCLE8",   "%_N_",   "G71P",     "G72P",    "G73P",   "G71U",   "G72W", "G73U"};
    return static_cast<int>(
        std::count_if(words.begin(), words.end(), [&](std::string_view w) { return code.find(w) != code.npos; }));
}

}  // namespace

int linuxcnc_likelihood(std::string_view text, std::string_view file_name, std::vector<std::string>* signs) {
    const std::string name = base::to_upper(file_name);
    const std::string code = code_of(text);
    const Lines lines = count_lines(code);
    const auto sign = [&](std::string_view s) {
        if (signs != nullptr) signs->emplace_back(s);
    };
    int score = 5;
    if (name.ends_with(".NGC"))
        score += 60;
    else if (lines.o_numbers > 0)
        score -= 15;
    if (lines.turret) score -= 30;
    for (const std::string_view suffix : {".NC", ".TAP", ".GCODE", ".CNC"})
        if (name.ends_with(suffix)) score += 25;
    if (lines.all > 0 && lines.words * 10 >= lines.all * 8) score += 15;
    if (lines.o_words > 0) {
        score += 45;
        sign("o-words");
    }
    if (code.find("#<") != std::string::npos) {
        score += 20;
        sign("#<name>");
    }
    const std::string upper = base::to_upper(text.substr(0, base::telling_bytes));
    for (const std::string_view active : {"(DEBUG,", "(PRINT,", "(LOGOPEN,", "(ABORT,"})
        if (upper.find(active) != std::string::npos) {
            score += 10;
            sign(active);
        }
    for (const std::string_view own : {"G64P", "G38.", "G33.1", "G5.2", "G5.3", "G92.1", "G92.2", "G61.1", "G41.1",
                                       "G42.1", "G43.1Z", "M66P", "M62P", "M64P"})
        if (code.find(own) != std::string::npos) sign(own);
    const int early = moves_before_motion(code) ? 1 : 0;
    const int unknown = std::min(3, count_unknown_codes(code, dialect::rs274::linuxcnc, true));
    return std::clamp(score - 20 * (foreign(code) + early) - 15 * unknown, 0, 100);
}

}  // namespace obrys::read::rs274
