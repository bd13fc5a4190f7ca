/// For which control a text was written, what says so, and what would be different if it were another one.

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "driver/control.hpp"
#include "read/rs274/fanuc/read.hpp"

namespace obrys::driver {

namespace {

constexpr std::size_t looked_at = 65536;  ///< bytes of the text
constexpr int clear_lead = 25;            ///< of 100: a second best control this far behind is no doubt

/// The words of a text, upper case, without blanks and comments in round brackets or behind a semicolon.
std::string code_of(std::string_view text) {
    std::string out;
    bool round = false, to_end = false;
    for (const char raw : text.substr(0, looked_at)) {
        const char c = base::upper(raw);
        if (c == '\n' || c == '\r') {
            round = to_end = false;
            if (!out.empty() && out.back() != '\n') out += '\n';
            continue;
        }
        to_end = to_end || (c == ';' && !round);
        round = !to_end && (round || c == '(') && c != ')';
        if (!to_end && !round && c != ')' && !base::is_blank(c)) out += c;
    }
    return out;
}

/// Q is a depth of pecks or a shift.
bool pecks(std::string_view code) {
    for (const std::string_view cycle : {"G83", "G73", "G76", "G87"})
        if (code.find(cycle) != std::string_view::npos) return true;
    return false;
}

/// A length or angle other than 0 that is written without a point, with its letter; empty: there is none.
std::string length_without_point(std::string_view code) {
    const std::string_view letters = pecks(code) ? "XYZIJKRUVWABCQ" : "XYZIJKRUVWABC";
    for (std::size_t i = 0; i + 1 < code.size(); ++i) {
        if (letters.find(code[i]) == std::string_view::npos || (i > 0 && base::is_letter(code[i - 1]))) continue;
        std::size_t k = i + 1;
        if (code[k] == '-' || code[k] == '+') ++k;
        const std::size_t from = k;
        while (k < code.size() && base::is_digit(code[k])) ++k;
        const bool zero = code.substr(from, k - from).find_first_not_of('0') == std::string_view::npos;
        const bool ends = k == code.size() || (code[k] != '.' && code[k] != '=' && code[k] != '[' && code[k] != '*' &&
                                               code[k] != '/' && code[k] != '+' && code[k] != '-');
        if (!zero && ends) return std::string(code.substr(i, k - i));
    }
    return {};
}

std::string first_x(std::string_view code) {
    for (std::size_t i = 0; i + 1 < code.size(); ++i) {
        if (code[i] != 'X' || (i > 0 && base::is_letter(code[i - 1]))) continue;
        std::size_t k = i + 1;
        while (k < code.size() && (base::is_digit(code[k]) || code[k] == '.' || code[k] == '-')) ++k;
        if (code.substr(i, k - i).find_first_of("123456789") != std::string_view::npos)
            return std::string(code.substr(i, k - i));
    }
    return {};
}

bool says_diameter(std::string_view code) {
    for (const std::string_view word : {"DIAMON", "DIAMOF", "DIAM90", "G7\n", "G8\n", "G07\n", "G08\n"})
        if (code.find(word) != std::string_view::npos) return true;
    return false;
}

/// Also where nothing but the plane speaks for a lathe, and no word of a third axis against it.
bool may_turn(std::string_view code, std::string_view text) {
    if (read::rs274::guess_machine(text).machine == dialect::rs274::FanucMachine::lathe) return true;
    const auto has = [&](std::string_view s) { return code.find(s) != std::string_view::npos; };
    return has("G18") && !has("Y") && !has("J") && !has("G17") && !has("G43");
}

/// What the two would read as different lengths.
std::string difference(const Control& a, const Control& b, std::string_view text, std::optional<bool> lathe) {
    if (a.counts_increments == b.counts_increments) return {};
    const Control& units = a.counts_increments ? b : a;
    const Control& increments = a.counts_increments ? a : b;
    const std::string code = code_of(text);
    if (const std::string word = length_without_point(code); !word.empty())
        return word + " without a point is " + word.substr(1) + (word.find_first_of("ABC") == 0 ? " degrees" : " mm") +
               " on " + std::string(units.name) + " and may be a thousandth of it on " + std::string(increments.name);
    const bool turns = lathe ? *lathe : may_turn(code, text);
    if (const std::string word = first_x(code); turns && !word.empty() && !says_diameter(code))
        return word + " is a diameter on a lathe with " + std::string(increments.name) + " and a radius on " +
               std::string(units.name);
    return {};
}

struct Foreign {
    std::string_view control;
    std::array<std::string_view, 6> words;  ///< without blanks; `*`: with what is behind it in one line, anywhere
};
/// Controls that no reader is for, by words at the begin of their lines that the ones that are read do not have.
constexpr std::array foreign_controls{
    Foreign{"Eding CNC", {"GOSUB", "DLGMSG", "LOGMSG", "ENDSUB", "MSG\"", "ERRMSG"}},
    Foreign{"WinCNC", {"[VECTRIC", "[BILLET", "[WINCNC", "[MACHINES", "[FILENAME", "[TOOLLIST"}},
    Foreign{"Mazatrol EIA", {"G122.1", "G123.1", "G110P", "G111P", "G130R", "G131.1"}},
    Foreign{"Okuma OSP", {"CALLO", "MODOUT", "NOEX", "VC1=", "G15H", "G56*H"}},
};

bool stands_in(std::string_view line, std::string_view word) {
    const std::size_t star = word.find('*');
    if (star == std::string_view::npos) return line.starts_with(word);
    const std::size_t first = line.find(word.substr(0, star));
    return first != std::string_view::npos && line.find(word.substr(star + 1), first + star) != std::string_view::npos;
}

std::string foreign_control(std::string_view text) {
    const std::string code = code_of(text);
    const bool own_lengths = code.find("G43") != std::string::npos;  // H is not Okuma's then
    for (std::size_t at = 0; at < code.size();) {
        const std::size_t end = std::min(code.find('\n', at), code.size());
        std::string_view line = std::string_view(code).substr(at, end - at);
        at = end + 1;
        if (line.starts_with("N")) line.remove_prefix(std::min(line.find_first_not_of("0123456789", 1), line.size()));
        for (const Foreign& f : foreign_controls)
            for (const std::string_view word : f.words)
                if (stands_in(line, word) && !(own_lengths && word.find('*') != std::string_view::npos))
                    return std::string(f.control) + " (" + std::string(line.substr(0, 24)) + ")";
    }
    return {};
}

int likelihood_of(const Control& c, std::string_view text, std::string_view file_name,
                  std::vector<std::string>* signs) {
    return language_of(c, text, file_name).likelihood(text, file_name, signs);
}

/// What the text itself says where the file's name alone speaks for `named`; empty: nothing that is clearer.
std::string contradiction(const Control& named, std::string_view text, std::string_view file_name) {
    const int own = likelihood_of(named, text, "", nullptr);
    for (const Control& c : all_controls()) {
        std::vector<std::string> signs;
        if (&c == &named || likelihood_of(c, text, "", &signs) - own < clear_lead || signs.empty()) continue;
        return "the name " + std::string(file_name) + " says so, but " + signs.front() + " is of " +
               std::string(c.name);
    }
    return {};
}

bool has_suffix_of_its_own(const Control& c, std::string_view file_name) {
    const std::string name = base::to_upper(file_name);
    constexpr std::array<std::string_view, 3> sinumerik{".MPF", ".SPF", ".ARC"};
    constexpr std::array<std::string_view, 2> heidenhain{".H", ".I"};
    const auto ends = [&](std::string_view s) { return name.ends_with(s); };
    if (c.name.starts_with("sinumerik")) return std::any_of(sinumerik.begin(), sinumerik.end(), ends);
    if (c.name.starts_with("heidenhain")) return std::any_of(heidenhain.begin(), heidenhain.end(), ends);
    if (c.name == "apt-cl") return std::any_of(c.program_suffixes.begin(), c.program_suffixes.end(), ends);
    return c.name == "linuxcnc" && ends(".NGC");
}

}  // namespace

Guess guess_control(std::string_view text, std::string_view file_name, std::optional<bool> turns) {
    Guess g;
    for (const Control& c : all_controls()) {
        std::vector<std::string> signs;
        const int n = likelihood_of(c, text, file_name, &signs);
        if (g.control == nullptr || n > g.likelihood) {
            g.next = g.control;
            g.next_likelihood = g.likelihood;
            g.control = &c;
            g.likelihood = n;
            g.signs = std::move(signs);
        } else if (g.next == nullptr || n > g.next_likelihood) {
            g.next = &c;
            g.next_likelihood = n;
        }
    }
    g.by_suffix = has_suffix_of_its_own(*g.control, file_name);
    g.foreign = g.by_suffix && !g.signs.empty() ? std::string{} : foreign_control(text);
    if (g.by_suffix && g.signs.empty()) g.difference = contradiction(*g.control, text, file_name);
    const bool clear = g.by_suffix || (!g.signs.empty() && g.likelihood - g.next_likelihood >= clear_lead);
    for (const Control& c : all_controls()) {  // one that reads numbers otherwise and is about as likely
        if (clear || &c == g.control || c.counts_increments == g.control->counts_increments) continue;
        const bool plain = g.signs.empty() && c.counts_increments;
        if ((plain || g.likelihood - likelihood_of(c, text, file_name, nullptr) < clear_lead) && g.difference.empty())
            g.difference = difference(*g.control, c, text, turns);
    }
    return g;
}

}  // namespace obrys::driver
