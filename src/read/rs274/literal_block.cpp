#include <array>

#include "base/short_number.hpp"
#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

using program::Form;
using program::Word;

/// Letters of plain motion blocks; `modal` for G; `control` where the full reader is needed.
constexpr std::array<Code, 256> letters = [] {
    std::array<Code, 256> t{};
    t.fill(Code::control);
    for (const char c : {'X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W', 'I', 'J', 'K', 'R', 'F'}) {
        const Code code = dialect::rs274::letter_code(c);
        t[static_cast<unsigned char>(c)] = t[static_cast<unsigned char>(c - 'A' + 'a')] = code;
    }
    t['G'] = t['g'] = Code::modal;
    return t;
}();

constexpr std::array<Modal, 4> motions{Modal::rapid, Modal::linear, Modal::arc_cw, Modal::arc_ccw};
constexpr unsigned arc_letters = static_cast<unsigned>(Code::i);
constexpr std::ptrdiff_t longest_line = 4000;  ///< bytes that a word's offset can count

constexpr std::uint64_t of_arcs = bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::radius);
static_assert(arc_letters > static_cast<unsigned>(Code::w));

struct Plain {
    std::uint64_t seen = 0;  ///< of all but G; none comes twice
    std::int32_t motion = -1;
    Word g{}, feed{};
};

/// The number behind a letter at `p`, with blanks or a sign before it.
base::ShortNumber scan_behind(const char* p) {
    ++p;
    while (base::is_blank(*p)) ++p;
    return base::scan_short_number(p, false);
}

/// G at `p` with its number; false where that is no plain motion, or the block's second one.
inline bool read_motion(const char*& p, const char* line, Plain& block) {
    const bool is_one_digit = base::is_digit(p[1]) && !base::is_digit(p[2]) && p[2] != '.';  // as it mostly is
    const base::ShortNumber n = is_one_digit ? base::ShortNumber{p[1] - '0', 0, p + 2} : scan_behind(p);
    if (n.end == nullptr || block.motion >= 0 || n.decimals != 0 || n.mantissa < 0 || n.mantissa > 3) return false;
    block.motion = n.mantissa;
    block.g = program::make_word(Code::modal, static_cast<std::uint32_t>(Form::index),
                                 program::modal_word(motions[static_cast<std::size_t>(n.mantissa)]),
                                 static_cast<std::uint32_t>(p - line), static_cast<std::uint32_t>(n.end - p));
    p = n.end;
    return true;
}

/// The words from `p` to the end of the line, where `p` stands then; their end. Null where the full reader is needed.
inline const char* read_plain_words(program::Unit& unit, const char*& at, const char* end, const char* line,
                                    Plain& block) {
    const char* p = at;
    const char* last = p;
    for (;;) {
        const Code code = letters[static_cast<unsigned char>(*p)];
        if (code == Code::control) {
            if (p >= end || *p == '\n') break;
            if (!base::is_blank(*p) && *p != '\r') return nullptr;
            ++p;
            continue;
        }
        if (code == Code::modal) {
            if (!read_motion(p, line, block)) return nullptr;
        } else {
            const base::ShortNumber n = base::is_digit(p[1]) ? base::scan_short_digits(p + 1, false) : scan_behind(p);
            if (n.end == nullptr || (block.seen & bit(code)) != 0) return nullptr;
            block.seen |= bit(code);
            const Word w = program::make_word(code, n.decimals, n.mantissa, static_cast<std::uint32_t>(p - line),
                                              static_cast<std::uint32_t>(n.end - p));
            if (code != Code::feed)
                unit.words.push_back(w);
            else if (block.feed = w; n.mantissa < 0)
                return nullptr;
            p = n.end;
        }
        last = p;
        if (*p == ' ') ++p;
    }
    at = p;
    return last - line > longest_line ? nullptr : last;
}

}  // namespace

const char* read_literal_block(State& s, const char* p, const char* end) {
    const char* line = p;
    program::Unit& unit = s.unit();
    const std::size_t first = unit.words.size();
    Plain block;
    if (*p == 'N' || *p == 'n') {
        ++p;
        const char* digits = p;
        while (base::is_digit(*p)) ++p;
        if (p == digits) return nullptr;
    }
    const char* last = read_plain_words(unit, p, end, line, block);
    const bool gap = p > line + 1 && block.motion < 0 && block.seen == 0;  // a block number alone
    const bool too_long = s.variant.longest_line > 0 && p - line > s.variant.longest_line;
    if (last == nullptr || gap || too_long || ((block.seen & of_arcs) != 0 && block.motion >= 0 && block.motion < 2)) {
        unit.words.resize(first);
        return nullptr;
    }
    if ((block.seen & bit(Code::feed)) != 0)
        unit.words.insert(unit.words.begin() + static_cast<std::ptrdiff_t>(first), block.feed);
    if (block.motion >= 0) unit.words.push_back(block.g);
    program::Statement statement;
    statement.begin = static_cast<std::uint32_t>(line - s.text.data());
    statement.first = static_cast<std::uint32_t>(first);
    statement.length = static_cast<std::uint16_t>(last - line);
    statement.flags = program::line_start;
    unit.statements.push_back(statement);
    return p;
}

}  // namespace obrys::read::rs274
