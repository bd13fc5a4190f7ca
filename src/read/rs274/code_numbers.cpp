#include "read/rs274/code_numbers.hpp"

#include <algorithm>
#include <vector>

#include "base/text.hpp"

namespace obrys::read::rs274 {

namespace {

constexpr std::size_t most_unknown = 12;
constexpr int longest_code = 4;  ///< digits of a code

/// Digits behind the letter at `at`, times ten with one digit behind the point; -1: it is no such number.
int code_at(std::string_view code, std::size_t at) {
    int n = 0, digits = 0;
    std::size_t k = at + 1;
    for (; k < code.size() && base::is_digit(code[k]) && digits < longest_code; ++k, ++digits) n = 10 * n + (code[k] - '0');
    if (digits == 0 || digits == longest_code) return -1;
    n *= 10;
    if (k + 1 < code.size() && code[k] == '.' && base::is_digit(code[k + 1])) n += code[k + 1] - '0';
    return n;
}

}  // namespace

int count_unknown_codes(std::string_view code, const dialect::rs274::Dialect& dialect, bool m_codes) {
    std::vector<int> unknown;
    for (std::size_t i = 0; i < code.size() && unknown.size() < most_unknown; ++i) {
        if (code[i] != 'G' && !(m_codes && code[i] == 'M')) continue;
        if (i > 0 && base::is_letter(code[i - 1])) continue;  // a part of a word
        const int n = code_at(code, i);
        if (n < 0) continue;
        const bool g = code[i] == 'G';
        const bool known = g ? dialect::rs274::find_g(dialect, n) != nullptr
                             : n >= 1000 || dialect::rs274::find_m(dialect, n / 10) != nullptr;
        const int key = g ? n : -n;
        if (!known && std::find(unknown.begin(), unknown.end(), key) == unknown.end()) unknown.push_back(key);
    }
    return static_cast<int>(unknown.size());
}

}  // namespace obrys::read::rs274
