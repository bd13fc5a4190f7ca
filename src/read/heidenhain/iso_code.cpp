/// A code of DIN/ISO and its coordinates; pole and departure.

#include <algorithm>
#include <utility>

#include "read/heidenhain/iso.hpp"

namespace obrys::read::heidenhain {

using program::Reference;

void read_pole(State& s) {
    const std::uint32_t from = s.in.at();
    s.build.statement(StatementKind::block, s.block);
    s.build.modal(Modal::pole_given, s.block, from);
    std::optional<Reference> reference;  // that of a G90 or G91 in this very block
    while (!s.failed && !s.in.at_end()) {
        const std::uint32_t begin = s.in.at();
        const char c = base::upper(s.in.peek());
        const auto k = pole_letters.find(c);
        s.in.step();
        if (k != std::string_view::npos) {
            coordinate_word(s, static_cast<Code>(static_cast<std::size_t>(Code::x) + k), begin, reference);
        } else if (c == 'G') {
            const int n = s.in.integer();
            if (n == 90 || n == 91) reference = n == 91 ? Reference::incremental : Reference::absolute;
        } else if (base::is_letter(c)) {
            while (base::is_letter(s.in.peek())) s.in.step();
            if (s.in.peek() == '"')
                static_cast<void>(read_text(s));
            else
                static_cast<void>(read_value(s));
        } else if (c == '.' || base::is_digit(c)) {  // what is left of a number that is none
            s.in.go_to(begin);
            fail_here(s, "unexpected " + here(s));
        }
    }
    s.build.end_statement(s.in.at());
    if (!s.failed) s.in.go_to(from);
}

void depart(State& s) {
    const ExprId radius = std::exchange(s.iso.departure, program::no_expr);
    if (radius == program::no_expr || s.failed) return;
    if (s.iso.departure_skip != s.build.skip())
        return fail(s, s.block, "G27 and the block behind it are not skipped together", "write / before both");
    const MotionFamily family = family_of(s.iso.motion);
    if (family != MotionFamily::straight && family != MotionFamily::polar_straight)
        return fail(s, s.block, "a straight block is due behind G27", "G00 or G01 to the point off the contour");
    const ExprId feed = std::exchange(s.iso.departure_feed, program::no_expr);
    if (feed != program::no_expr) s.build.expression(Code::corner_feed, feed, s.block, s.in.at());
    const bool rapid = s.iso.motion == 0 || s.iso.motion == 10;  // G00, G10: all of it, as DEP with FMAX
    if (rapid && feed == program::no_expr) s.build.modal(Modal::rapid_block, s.block, s.in.at());
    add_smooth(s, true, radius, s.block);
    s.last_path = program::no_target;  // no corner may follow
}

void coordinate_word(State& s, Code code, std::uint32_t begin, std::optional<Reference> reference) {
    if (!reference || *reference == Reference::incremental) return value_word(s, code, begin, reference.has_value());
    const std::uint32_t from = s.in.at();
    const Value v = read_value(s);
    if (!v.found) {
        s.in.go_to(from);
        return value_word(s, code, begin);  // which complains
    }
    s.build.expression(code, s.build.with_reference(*reference, as_expr(s, v), v.begin, v.end), begin, v.end);
}

int read_code(State& s) {
    const std::uint32_t begin = s.in.at();
    const std::string letter(1, base::upper(s.in.peek()));
    s.in.step();
    const int n = s.in.integer();
    if (n < 0) fail(s, begin, letter + " needs the whole number of a function");
    return n;
}

}  // namespace obrys::read::heidenhain
