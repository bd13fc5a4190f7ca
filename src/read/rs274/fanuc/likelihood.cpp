/// What speaks for a FANUC or Haas program, and for the kind of machine.

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdlib>

#include "base/text.hpp"
#include "read/rs274/fanuc/read.hpp"

namespace obrys::read::rs274 {

namespace {

/// Which bytes stand beside which in a text: most patterns of the tables need not be looked for in most texts.
class Pairs {
public:
    void add(std::string_view text) {
        for (std::size_t i = 0; i + 1 < text.size(); ++i) held_.set(place(text[i], text[i + 1]));
    }
    /// False: the pattern, of which `~` is any digit, stands nowhere.
    [[nodiscard]] bool may_hold(std::string_view pattern) const {
        for (std::size_t i = 0; i + 1 < pattern.size(); ++i)
            if (pattern[i] != '~' && pattern[i + 1] != '~' && !held_.test(place(pattern[i], pattern[i + 1])))
                return false;
        return true;
    }

private:
    static std::size_t place(char a, char b) {
        return std::size_t{static_cast<unsigned char>(a)} << 8 | static_cast<unsigned char>(b);
    }
    std::bitset<std::size_t{1} << 16> held_;
};

/// The text's words: upper case, without blanks and comments, each line ending with a line feed.
struct Squeezed {
    std::string code, comments;
    std::vector<std::uint32_t> from;  ///< byte of the text for each one of `code`
    Pairs pairs;                      ///< of `code`
};
/// Block numbers are left out: a pattern for the begin of a line means the first word.
Squeezed squeeze(std::string_view text) {
    Squeezed out;
    bool comment = false, number = false, begins = true;
    const std::size_t size = std::min(text.size(), base::telling_bytes);
    out.code.resize(size);
    out.from.resize(size);
    std::size_t n = 0;
    const auto take = [&](char c, std::size_t at) { out.code[n] = c, out.from[n++] = static_cast<std::uint32_t>(at); };
    for (std::size_t i = 0; i < size; ++i) {
        const char c = base::upper(text[i]);
        number = !comment && ((number && (base::is_digit(c) || base::is_blank(c))) || (begins && c == 'N'));
        if (number) continue;
        if (c == '\n' || c == '\r') {
            comment = false;
            if (!begins) take('\n', i);
            begins = true;
        } else if (comment || c == '(') {
            comment = c != ')';
            out.comments += c;
        } else if (!base::is_blank(c)) {
            take(c, i);
            begins = false;
        }
    }
    out.code.resize(n);
    out.from.resize(n);
    out.pairs.add(out.code);
    return out;
}

/// Where a pattern stands: `~` is a digit, `@` the begin of a line, all others stand for themselves.
bool stands_at(std::string_view text, std::size_t i, std::string_view pattern) {
    std::size_t k = i;
    for (const char p : pattern) {
        if (p == '@') {
            if (k != 0 && text[k - 1] != '\n') return false;
            continue;
        }
        if (k >= text.size() || (p == '~' ? !base::is_digit(text[k]) : text[k] != p)) return false;
        ++k;
    }
    return true;
}

/// Occurrences of a pattern, at most `most`; `first`: where the first one stands.
int count(const Squeezed& t, std::string_view pattern, std::size_t* first = nullptr, int most = 3) {
    const std::string_view text = t.code;
    const bool begins_line = pattern.front() == '@';
    const std::string_view due = pattern.substr(begins_line ? 1 : 0);
    if (!t.pairs.may_hold(due)) return 0;
    int n = 0;
    // No pattern begins with a digit, so its first byte stands for itself.
    for (std::size_t i = text.find(due.front()); i != std::string_view::npos && n < most;
         i = text.find(due.front(), i + 1)) {
        if (!stands_at(text, i, pattern)) continue;
        if (n == 0 && first != nullptr) *first = i;
        ++n;
    }
    return n;
}

struct Sign {
    std::string_view pattern;
    int weight;
};

constexpr std::array own_signs{
    Sign{"@O~~~~", 12}, Sign{"@:~~~~", 12},  Sign{"@%\n", 4},   Sign{"M98P", 5},    Sign{"G65P", 10},
    Sign{"IF[#", 6},    Sign{"]GOTO", 6},    Sign{"]THEN#", 6}, Sign{"]DO~", 6},    Sign{"#3000=", 10},
    Sign{"G54.1P", 8},  Sign{"G28U0", 8},    Sign{"G28W0", 8},  Sign{"G50S", 8},    Sign{"@T0~0~", 14},
    Sign{"G43.4", 4},   Sign{"G43Z", 3},     Sign{"H0~", 2},    Sign{"DPRNT[", 10}, Sign{"G10L2P", 2},
    Sign{"M06", 2},     Sign{"G40", 2},      Sign{"G80", 2},    Sign{"G53X0Z0", 6}, Sign{"@G28", 2},
    Sign{"G66P", 8},    Sign{"#0]", 8},      Sign{"G53.5", 6},  Sign{"M13\n", 2},   Sign{"G97S", 3},
    Sign{"G96S", 3},    Sign{"@G71P", 20},   Sign{"@G70P", 20}, Sign{"@G72P", 20},  Sign{"@G73P", 20},
    Sign{"@G71U", 12},  Sign{"@G72W", 12},   Sign{"@G73U", 12}, Sign{"@G76P0", 12}, Sign{"G91G28", 20},
    Sign{"G28G91", 8},  Sign{"@T~~~~\n", 6}, Sign{"G12.1", 8},  Sign{"G112", 6},    Sign{"G5.1Q", 8},
    Sign{"G05.1Q", 8},  Sign{"G92S", 4},     Sign{"G68.2", 8},
};
constexpr std::array foreign_signs{
    Sign{"#<", 20},      Sign{"O<", 20},       Sign{"SUB\n", 12},    Sign{"ENDSUB", 20},  Sign{"ENDWHILE", 20},
    Sign{"O~IF", 10},    Sign{"O~~IF", 10},    Sign{"O~~~IF", 10},   Sign{"O~~CALL", 10}, Sign{"O~~~CALL", 10},
    Sign{"G38.", 8},     Sign{"G33.1", 10},    Sign{"G64P", 4},      Sign{"G92.1", 4},    Sign{"G5.2", 6},
    Sign{"M66P", 6},     Sign{"BEGINPGM", 30}, Sign{"TOOLCALL", 30}, Sign{"TOOLDEF", 20}, Sign{"FMAX", 20},
    Sign{"LBL~", 10},    Sign{"GOTOF", 15},    Sign{"GOTOB", 15},    Sign{"MSG(", 15},    Sign{"CR=", 10},
    Sign{"R~=", 10},     Sign{"R~~=", 10},     Sign{"%_N_", 40},     Sign{"$P_", 15},     Sign{"$AA_", 15},
    Sign{"DEFREAL", 15}, Sign{"DEFINT", 15},   Sign{"ENDIF", 6},     Sign{"*\n", 10},     Sign{"G99T~", 10},
    Sign{"D00Q", 10},    Sign{"DIAMOF", 15},   Sign{"DIAMON", 15},   Sign{"STOPRE", 15},  Sign{"MCALL", 10},
    Sign{"CYCLE8", 10},  Sign{"FN~:", 15},     Sign{"G98L~", 8},
};
constexpr std::array haas_signs{
    Sign{"G187", 10}, Sign{"G150", 8},  Sign{"G154P", 12}, Sign{"M97P", 15}, Sign{"G234", 12},
    Sign{"G254", 10}, Sign{"G103P", 8}, Sign{"G12I", 30},  Sign{"G13I", 30}, Sign{"G47P", 20},
    Sign{"G12D", 30}, Sign{"G13D", 30}, Sign{"G12K", 30},  Sign{"G13K", 30}, Sign{"G12F", 30},
    Sign{"G13F", 30}, Sign{"G12Z", 30}, Sign{"G13Z", 30},  Sign{"G268", 10}, Sign{"G269", 10},
    Sign{"G70I", 10}, Sign{"G136", 6},  Sign{"G141", 6},   Sign{"G255", 10}, Sign{"M130(", 10},
};

/// The words of the text that a pattern stands for.
std::string found(std::string_view text, std::size_t at, std::string_view pattern) {
    std::string words;
    for (std::size_t k = at; k < text.size() && text[k] != '\n' && words.size() + 1 < pattern.size() + 3; ++k) {
        const bool more = words.size() < pattern.size() - (pattern.front() == '@' ? 1U : 0U);
        if (!more && !base::is_digit(text[k])) break;
        words += text[k];
    }
    return words;
}

template <std::size_t n>
int sum(const Squeezed& t, const std::array<Sign, n>& table, std::vector<std::string>* signs = nullptr) {
    constexpr int says_something = 5;  // what other controls write as well is no sign
    int total = 0;
    for (const Sign& s : table) {
        std::size_t at = 0;
        const int times = count(t, s.pattern, &at);
        total += s.weight * times;
        if (times == 0 || signs == nullptr || s.weight < says_something) continue;
        std::string words = found(t.code, at, s.pattern);
        if (std::find(signs->begin(), signs->end(), words) == signs->end()) signs->push_back(std::move(words));
    }
    return total;
}

/// Of words with whole lengths: are points written behind them (X5.)?
int points(std::string_view code) {
    int with = 0, without = 0;
    for (std::size_t i = 0; i + 1 < code.size(); ++i) {
        if (std::string_view("XYZ").find(code[i]) == std::string_view::npos) continue;
        std::size_t k = i + 1;
        while (k < code.size() && (code[k] == '-' || base::is_digit(code[k]))) ++k;
        if (k == i + 1 || k >= code.size()) continue;
        if (code[k] == '.')
            with += k + 1 >= code.size() || !base::is_digit(code[k + 1]) ? 1 : 0;
        else
            without += code[k - 1] != '0' || base::is_digit(code[k - 2]) ? 1 : 0;
    }
    return with + without == 0 ? 0 : with > without ? 12 : -12;
}

int suffix_score(std::string_view file_name) {
    const std::string name = base::to_upper(file_name);
    for (const std::string_view s : {".MPF", ".SPF", ".H", ".I", ".NGC"})
        if (name.ends_with(s)) return -25;
    for (const std::string_view s : {".NC", ".CNC", ".TAP", ".EIA", ".NCF", ".PRG", ".PIM", ".FNC", ".MIN"})
        if (name.ends_with(s)) return 6;
    return 0;
}

int plain_score(const Squeezed& t, std::string_view file_name, std::vector<std::string>* signs) {
    return 8 + sum(t, own_signs, signs) - sum(t, foreign_signs) + points(t.code) + suffix_score(file_name);
}

}  // namespace

int fanuc_likelihood(std::string_view text, std::string_view file_name, std::vector<std::string>* signs) {
    const Squeezed t = squeeze(text);
    return std::clamp(plain_score(t, file_name, signs), 0, 95);
}

int haas_likelihood(std::string_view text, std::string_view file_name, std::vector<std::string>* signs) {
    const Squeezed t = squeeze(text);
    const int score = plain_score(t, file_name, signs);
    if (score <= 0) return 0;
    const bool named = (t.comments + base::to_upper(file_name)).find("HAAS") != std::string::npos;
    if (named && signs != nullptr) signs->emplace_back("\"Haas\"");
    const int own_words = sum(t, haas_signs, signs) + (named ? 20 : 0);
    return std::clamp(own_words > 0 ? std::min(score, 85) + own_words : std::min(score - 5, 90), 0, 100);
}

namespace {

/// Where the first of the words stands that a pattern stands for, with all its digits.
base::Span place_of(const Squeezed& t, std::uint32_t file, std::size_t at, std::string_view pattern) {
    std::size_t end = at + pattern.size() - (pattern.ends_with('\n') ? 1 : 0);
    while (end < t.code.size() && (base::is_digit(t.code[end]) || t.code[end] == '.')) ++end;
    return {file, t.from[at], t.from[end - 1] + 1};
}

template <std::size_t n>
int weigh(const Squeezed& t, std::uint32_t file, const std::array<Sign, n>& table, std::vector<base::Span>& places) {
    int total = 0;
    for (const Sign& s : table) {
        std::size_t at = 0;
        const int times = count(t, s.pattern, &at);
        total += s.weight * times;
        if (times > 0) places.push_back(place_of(t, file, at, s.pattern));
    }
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
    return total;
}

}  // namespace

MachineByText guess_machine(std::string_view text, std::uint32_t file) {
    constexpr std::array lathe{
        Sign{"G50S", 6},    Sign{"G92S", 3}, Sign{"G96", 4},   Sign{"G28U", 6}, Sign{"G28W", 4}, Sign{"T0~0~", 3},
        Sign{"T~~~~\n", 2}, Sign{"U-", 2},   Sign{"W-", 1},    Sign{"G70P", 6}, Sign{"G71P", 6}, Sign{"G71U", 6},
        Sign{"G72W", 6},    Sign{"G73U", 6}, Sign{"G74R", 6},  Sign{"G75R", 6}, Sign{"G75X", 4}, Sign{"G76P", 4},
        Sign{"G92X", 1},    Sign{"G97S", 2}, Sign{"G99G1", 2}, Sign{"G32Z", 4},
    };
    constexpr std::array mill{
        Sign{"Y~", 3},   Sign{"Y-", 3},  Sign{"Y.", 3},  Sign{"Y#", 3},      Sign{"Y[", 3},  Sign{"M06", 5},
        Sign{"M6\n", 5}, Sign{"M6T", 5}, Sign{"G43", 5}, Sign{"G81", 2},     Sign{"G83", 1}, Sign{"J~", 1},
        Sign{"J-", 1},   Sign{"D~", 1},  Sign{"H~", 2},  Sign{"G91G28Z", 4},
    };
    constexpr int clear_lead = 5;
    const Squeezed t = squeeze(text);
    MachineByText guess;
    const int turns = weigh(t, file, lathe, guess.signs.lathe), mills = weigh(t, file, mill, guess.signs.mill);
    guess.machine = turns > mills ? dialect::rs274::FanucMachine::lathe : dialect::rs274::FanucMachine::mill;
    guess.signs.doubtful = turns > 0 && mills > 0 && std::abs(turns - mills) < clear_lead;
    return guess;
}

}  // namespace obrys::read::rs274
