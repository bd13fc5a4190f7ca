#include <array>
#include <optional>

#include "base/short_number.hpp"
#include "dialect/sinumerik/tables.hpp"
#include "read/sinumerik/block.hpp"

namespace obrys::read::sinumerik {

using program::Code;
using program::Form;

namespace {

/// What a letter with a literal becomes here: its code; `modal` for G; `control` where the full reader is needed.
constexpr std::array<Code, 256> letters = [] {
    std::array<Code, 256> t{};
    t.fill(Code::control);
    const auto set = [&](char c, Code code) {
        t[static_cast<unsigned char>(c)] = code;
        t[static_cast<unsigned char>(c - 'A' + 'a')] = code;
    };
    set('X', Code::x), set('Y', Code::y), set('Z', Code::z), set('A', Code::a), set('B', Code::b), set('C', Code::c);
    set('U', Code::u), set('V', Code::v), set('W', Code::w), set('I', Code::i), set('J', Code::j), set('K', Code::k);
    set('F', Code::feed), set('S', Code::spindle), set('T', Code::tool), set('D', Code::edge), set('M', Code::m),
        set('H', Code::h);
    set('G', Code::modal);
    return t;
}();

using Literal = base::ShortNumber;

std::optional<std::int32_t> payload_of(std::int32_t number) {
    const auto g = dialect::sinumerik::find_g(number);
    const bool said = g && g->modal == program::Modal::exact_stop_block;  // which the full reader does
    if (!g || said || g->use != dialect::sinumerik::Use::modal) return std::nullopt;
    return program::modal_word(g->modal, g->code);
}

/// True where a G code goes into a word; ignored and refused ones are left to the full reader.
bool modal_payload(const Literal& n, std::int32_t& payload) {
    constexpr std::int32_t none = -1;
    static const std::array<std::int32_t, 100> frequent = [] {
        std::array<std::int32_t, 100> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = payload_of(static_cast<std::int32_t>(i)).value_or(-1);
        return t;
    }();
    if (n.decimals != 0 || n.mantissa < 0 || n.mantissa > 9999) return false;
    payload = n.mantissa < static_cast<std::int32_t>(frequent.size()) ? frequent[static_cast<std::size_t>(n.mantissa)]
                                                                      : payload_of(n.mantissa).value_or(none);
    return payload != none;
}

bool read_word(State& s, const char*& p, const char* line) {
    const Code code = letters[static_cast<unsigned char>(*p)];
    if (code == Code::control) return false;
    const Literal n = base::scan_short_number(p + 1, false);
    if (n.end == nullptr || n.end - line > 4000) return false;
    const char next = *n.end;
    if (next == '=' || next == '[' || next == '(' || next == ':' || base::upper(next) == 'E' || next == '_')
        return false;
    std::uint32_t form = n.decimals;
    std::int32_t payload = n.mantissa;
    if (code == Code::modal) {
        if (!base::is_digit(p[1])) return false;  // G-0 is none
        form = static_cast<std::uint32_t>(Form::index);
        if (!modal_payload(n, payload)) return false;
    }
    s.unit.words.push_back(program::make_word(code, form, payload, static_cast<std::uint32_t>(p - line),
                                              static_cast<std::uint32_t>(n.end - p)));
    p = n.end;
    return true;
}

}  // namespace

const char* read_literal_block(State& s, const char* p, const char* end) {
    const char* line = p;
    const std::size_t first = s.unit.words.size();
    if (base::upper(*p) == 'N') {
        ++p;
        while (base::is_digit(*p)) ++p;
        if (p == line + 1) return nullptr;
    }
    const char* last = p;
    while (p < end) {
        if (base::is_blank(*p)) {
            ++p;
            continue;
        }
        if (*p == ';')
            while (p < end && *p != '\n' && *p != '\r') ++p;
        if (p == end || *p == '\n' || *p == '\r') break;
        if (!read_word(s, p, line)) {
            s.unit.words.resize(first);
            return nullptr;
        }
        last = p;
    }
    if (last == line) return p;  // a comment alone
    program::Statement statement;
    statement.begin = static_cast<std::uint32_t>(line - s.text.data());
    statement.first = static_cast<std::uint32_t>(first);
    statement.length = static_cast<std::uint16_t>(last - line);
    statement.flags = program::line_start;
    s.unit.statements.push_back(statement);
    return p;
}

}  // namespace obrys::read::sinumerik
