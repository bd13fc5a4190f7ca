#include "read/rs274/fanuc/plain_block.hpp"

#include "base/short_number.hpp"
#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Form;
using program::Word;

namespace {

constexpr std::string_view plain_letters = "XYZABCUVWIJKRF";
constexpr std::uint64_t first_motion = 27;     ///< behind the letters' own numbers
constexpr std::ptrdiff_t longest_block = 240;  ///< bytes; longer ones are left to the full reader

/// What a letter is in PlainBlock::letters; 0: the full reader is needed.
constexpr std::array<std::uint8_t, 256> letter_numbers = [] {
    std::array<std::uint8_t, 256> t{};
    for (const char c : plain_letters)
        t[static_cast<unsigned char>(c)] = t[static_cast<unsigned char>(c - 'A' + 'a')] =
            static_cast<std::uint8_t>(c - 'A' + 1);
    return t;
}();

/// A sign in front of it changes what the block is: F has none, of lathes' corners it says which way they go.
bool sign_counts(char letter, bool lathe) {
    const char c = base::upper(letter);
    return c == 'F' || (lathe && (c == 'R' || c == 'C'));
}

/// A letter and its number at `p`, which is moved behind them.
bool scan_word(const char*& p, const char* first, bool lathe, PlainBlock& block) {
    const bool g = *p == 'G' || *p == 'g';
    std::uint64_t letter = letter_numbers[static_cast<unsigned char>(*p)];
    if ((letter == 0 && !g) || block.count == PlainBlock::most_words) return false;
    const base::ShortNumber n = base::scan_short_number(p + 1, false);
    if (n.end == nullptr || n.end - first > longest_block || *n.end == '.') return false;
    const bool point = n.decimals != 0 || n.end[-1] == '.';
    if (g) {  // G1: a whole number without sign
        if (point || !base::is_digit(p[1]) || n.mantissa > 3) return false;
        letter = first_motion + static_cast<std::uint64_t>(n.mantissa);
    } else if (!point || (p[1] == '-' && sign_counts(*p, lathe))) {
        return false;
    }
    block.letters = block.letters << 5 | letter;
    block.numbers[block.count++] = {n.mantissa, n.decimals, static_cast<std::uint32_t>(p - first),
                                    static_cast<std::uint32_t>(n.end - p)};
    p = n.end;
    return true;
}

std::size_t count_of(const base::Diagnostics& d) { return d.all().size() + d.dropped(); }

/// N and its number.
bool scan_number(const char*& p, PlainBlock& block) {
    const char* digits = ++p;
    constexpr std::ptrdiff_t most_digits = 8;
    for (block.number = 0; base::is_digit(*p) && p - digits < most_digits; ++p)
        block.number = block.number * 10 + static_cast<std::uint32_t>(*p - '0');
    block.numbered = true;
    return p > digits && !base::is_digit(*p) && *p != '.';
}

}  // namespace

bool scan_plain_block(std::string_view text, std::size_t begin, std::size_t end, bool lathe, PlainBlock& block) {
    const char* p = text.data() + begin;
    const char* const stop = text.data() + end;
    while (p < stop && base::is_blank(*p)) ++p;
    const char* const first = p;
    block.letters = 0;
    block.count = 0;
    block.numbered = false;
    if ((*p == 'N' || *p == 'n') && !scan_number(p, block)) return false;
    const char* last = p;
    while (p < stop && *p != '\n' && *p != '\r') {
        if (base::is_blank(*p)) {
            ++p;
            continue;
        }
        if (!scan_word(p, first, lathe, block)) return false;
        last = p;
    }
    block.begin = static_cast<std::uint32_t>(first - text.data());
    block.end = static_cast<std::uint32_t>(last - text.data());
    return block.count > 0 && p <= stop;
}

std::size_t PlainBlocks::place_of(std::uint64_t letters) {
    constexpr std::uint64_t factor = 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(letters * factor >> 58);
}

PlainBlocks::Before PlainBlocks::before(const FanucState& s) {
    const program::Unit& unit = s.unit();
    return {s.modes.all(),     unit.statements.size(),  unit.words.size(),
            unit.exprs.size(), count_of(s.diagnostics), unit.lengths_with_point};
}

bool PlainBlocks::add(FanucState& s, const PlainBlock& block) const {
    const Kind& kind = kinds_[place_of(block.letters)];
    if (kind.letters != block.letters || kind.before != s.modes.all()) return false;
    s.number.reset();
    if (block.numbered) s.number = block.number;
    note_number(s);
    program::Unit& unit = s.unit();
    const auto at = static_cast<std::uint32_t>(unit.statements.size());
    program::Statement statement;
    statement.begin = block.begin;
    statement.first = static_cast<std::uint32_t>(unit.words.size());
    statement.length = static_cast<std::uint16_t>(block.end - block.begin);
    statement.flags = program::line_start;
    unit.statements.push_back(statement);
    for (std::size_t i = 0; i < block.count; ++i) {
        const Word& like = kind.words[i];
        const PlainBlock::Number& n = block.numbers[kind.from[i]];
        const bool index = program::form_of(like) == Form::index;
        unit.words.push_back(program::make_word(program::code_of(like), index ? like.form : n.decimals,
                                                index ? like.payload : n.mantissa, n.begin, n.length));
    }
    unit.lengths_with_point += kind.lengths_with_point;
    if (kind.has_use) FanucModes::add_span(unit.modes, {at, at + 1}, kind.use);
    if (kind.changes) s.modes.put_all(kind.after);
    return true;
}

void PlainBlocks::learn(const FanucState& s, const PlainBlock& block, const Before& before) {
    const program::Unit& unit = s.unit();
    const bool alone = unit.statements.size() == before.statements + 1 && unit.exprs.size() == before.exprs &&
                       unit.words.size() == before.words + block.count && s.modes.pieces().size() == 1;
    if (s.failed || !alone || count_of(s.diagnostics) != before.diagnostics) return;
    const program::Statement& statement = unit.statements.back();
    if (statement.begin != block.begin || statement.length != block.end - block.begin ||
        statement.flags != program::line_start || statement.kind != program::StatementKind::block)
        return;
    Kind kind;
    for (std::size_t i = 0; i < block.count; ++i) {
        const Word& w = kind.words[i] = unit.words[before.words + i];
        std::size_t k = 0;
        while (k < block.count && block.numbers[k].begin != w.offset) ++k;
        if (k == block.count || block.numbers[k].length != w.length) return;
        const PlainBlock::Number& n = block.numbers[k];
        const bool literal = w.form == n.decimals && w.payload == n.mantissa;
        const bool motion = program::code_of(w) == Code::modal && program::form_of(w) == Form::index;
        if (!literal && !motion) return;
        kind.from[i] = static_cast<std::uint8_t>(k);
    }
    kind.letters = block.letters;
    kind.before = before.modes;
    kind.after = s.modes.all();
    kind.changes = kind.before != kind.after;
    kind.lengths_with_point = unit.lengths_with_point - before.lengths_with_point;
    const auto& spans = unit.modes.spans;
    kind.has_use = !spans.empty() && spans.back().last == unit.statements.size();
    if (kind.has_use) kind.use = spans.back().use;
    kinds_[place_of(kind.letters)] = kind;
}

}  // namespace obrys::read::rs274
