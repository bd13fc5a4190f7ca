#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "read/sinumerik/archive.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::read::sinumerik {

namespace {

/// Words that no other control has, words that hardly any other has, and signs of others.
constexpr std::array<std::string_view, 25> own{"PROC ",  "DEF REAL", "DEF INT", "$AA_",  "$P_",    "$TC_", "$MC_",
                                               "DIAMON", "DIAMOF",   "ATRANS",  "AROT ", "STOPRE", "SUPA", "LIMS=",
                                               "CR=",    "RND=",     "CHF=",    "CHR=",  "RNDM=",  "T=\"", "=IC(",
                                               "=AC(",   "MCALL",    "DISPLOF", "SETAL("};
constexpr std::array<std::string_view, 7> likely{"GOTOF", "GOTOB", "ENDIF", "ENDWHILE", "ENDLOOP", "ENDFOR", "MSG("};
constexpr std::array<std::string_view, 9> foreign{"BEGIN PGM", "TOOL CALL", "END PGM", "G65 P", "G54.1",
                                                  "M98 P",     "LBL ",      "FMAX",    "#1"};

int count(std::string_view text, std::string_view what) {
    int n = 0;
    for (std::size_t at = text.find(what); at != std::string_view::npos && n < 3;
         at = text.find(what, at + what.size()))
        ++n;
    return n;
}

/// `R12=` at the begin of a word.
bool assigns_parameter(std::string_view text) {
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if (text[i] != 'R' || (i > 0 && (base::is_letter(text[i - 1]) || base::is_digit(text[i - 1])))) continue;
        std::size_t k = i + 1;
        while (k < text.size() && base::is_digit(text[k])) ++k;
        while (k < text.size() && base::is_blank(text[k])) ++k;
        if (k > i + 1 && k < text.size() && text[k] == '=') return true;
    }
    return false;
}

/// The text in upper case without comments, its first 64 KiB.
std::string code_of(std::string_view text) {
    text = text.substr(0, base::telling_bytes);
    std::string out(text.size(), ' ');
    std::size_t n = 0;
    bool comment = false;
    for (const char c : text) {
        if (c == ';') comment = true;
        if (c == '\n' || c == '\r') comment = false;
        if (!comment) out[n++] = base::upper(c);
    }
    out.resize(n);
    return out;
}

}  // namespace

int likelihood(std::string_view text, std::string_view file_name, std::vector<std::string>* signs) {
    const std::string name = base::to_upper(file_name);
    int score = 5;
    if (name.ends_with(".MPF") || name.ends_with(".SPF")) score += 60;
    if (name.ends_with(".ARC") || name.ends_with(".CPF")) score += 20;
    if (text.find("%_N_") != std::string_view::npos) score += 50;
    if (text.find(";$PATH=") != std::string_view::npos) score += 30;
    const std::string code = code_of(text);
    const auto sign = [&](std::string_view w) {
        if (signs != nullptr) signs->emplace_back(base::trim(w));
    };
    if (text.find("%_N_") != std::string_view::npos) sign("%_N_");
    constexpr int first_own = 12, each = 8;
    for (const std::string_view w : own) {
        const int n = count(code, w);
        score += (n > 0 ? first_own : 0) + each * n;
        if (n > 0) sign(w);
    }
    for (const std::string_view w : likely) {
        const int n = count(code, w);
        score += each * n;
        if (n > 0) sign(w);
    }
    for (const std::string_view w : foreign) score -= 12 * count(code, w);
    if (assigns_parameter(code)) {
        score += 15;
        sign("R…=");
    }
    if (code.find("X=") != std::string::npos || code.find("Z=") != std::string::npos) {
        score += 8;
        sign("X=");
    }
    return std::clamp(score, 0, 100);
}

}  // namespace obrys::read::sinumerik
