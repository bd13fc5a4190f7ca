// Any bytes are formatted without crash; formatting twice changes nothing more; no comment and no letter is lost.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "format/heidenhain/format.hpp"

namespace {

using namespace obrys::format::heidenhain;

void require(bool holds) {
    if (!holds) std::abort();
}

/// What formatting must keep whatever the text: all but digits (block numbers), blanks, plus and decimal signs, letter
/// case.
std::string content(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        const bool looks = c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '+' || c == '.' || c == ',' ||
                           (c >= '0' && c <= '9') || c == 'N' || c == 'n';
        if (!looks) out += upper;
    }
    return out;
}

std::string comments(const std::string& text) {
    std::string out;
    bool inside = false;
    for (const char c : text) {
        inside = (inside || c == ';') && c != '\n' && c != '\r';
        if (inside && c != ' ' && c != '\t') out += c;
    }
    return out;
}

void check(const std::string& text, Language language, const Options& options) {
    const Formatted once = formatted(text, language, options);
    require(formatted(once.text, language, options).text == once.text);
    require(content(once.text) == content(text));
    require(comments(once.text) == comments(text));
    const std::size_t lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) +
                              static_cast<std::size_t>(std::count(text.begin(), text.end(), '\r')) + 1;
    for (const Left& l : once.left) require(l.line >= 1 && l.line <= lines);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    const auto guess = language_of(text, "FUZZ.H");
    for (const Language language : {Language::klartext, Language::iso})
        for (const Decimal decimal : {Decimal::keep, Decimal::point, Decimal::comma})
            check(text, language, {decimal, LineEnds::keep});
    require(!guess || *guess == Language::klartext || *guess == Language::iso);
    return 0;
}
