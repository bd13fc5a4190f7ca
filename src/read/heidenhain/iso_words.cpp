/// Words of DIN/ISO blocks that move, change the tool, or set what holds from here on. What R and H mean depends on the
/// path function: polar coordinates with G10 … G16, the circle's radius with G02, G03, G05.

#include <algorithm>
#include <utility>

#include "read/heidenhain/iso.hpp"

namespace obrys::read::heidenhain {

using program::Reference;

MotionFamily family_of(int motion) {
    switch (motion) {
        case 0:
        case 1: return MotionFamily::straight;
        case 2:
        case 3:
        case 5: return MotionFamily::arc;
        case 6: return MotionFamily::tangential;
        case 10:
        case 11: return MotionFamily::polar_straight;
        case 12:
        case 13:
        case 15: return MotionFamily::polar_arc;
        case 16: return MotionFamily::polar_tangential;
        default: return MotionFamily::unknown;
    }
}

namespace {

Modal modal_of(int motion) {
    switch (motion) {
        case 0:
        case 10: return Modal::rapid;
        case 2:
        case 12: return Modal::arc_cw;
        case 3:
        case 13: return Modal::arc_ccw;
        case 5:
        case 15: return Modal::arc_same_sense;
        case 6:
        case 16: return Modal::arc_tangent;
        default: return Modal::linear;
    }
}

constexpr std::string_view axis_letters = "XYZABCUVW";

/// G codes that hold for the block's words wherever they stand in it. True where one says how the tool moves.
bool take_modal_codes(State& s, const IsoBlock& b) {
    bool moves = false;
    for (const int g : b.g) {
        if (family_of(g) != MotionFamily::unknown) {
            s.iso.motion = g;
            moves = true;
        }
    }
    return moves;
}

/// G07: this block alone, along its axis; with G43 or G44 of this block or one before it longer or shorter.
void write_paraxial(State& s, const IsoBlock& b) {
    const std::uint32_t end = s.in.at();
    const bool alone = b.has_g(40) || b.has_g(41) || b.has_g(42);
    s.build.modal(Modal::paraxial, s.block, end,
                  (b.rapid ? program::paraxial_rapid : program::paraxial_feed) | (alone ? program::paraxial_alone : 0));
    if (b.has_g(43)) s.build.modal(Modal::paraxial_longer, s.block, end);
    if (b.has_g(44)) s.build.modal(Modal::paraxial_shorter, s.block, end);
}

/// The path function of the block; true where it moves.
bool write_motion(State& s, const IsoBlock& b, bool given) {
    const MotionFamily family = family_of(s.iso.motion);
    const bool moves = b.has_any(axis_letters) || b.has('H') || (b.has('R') && family > MotionFamily::straight);
    const std::uint32_t end = s.in.at();
    if (b.has_g(7)) {
        write_paraxial(s, b);
        return false;
    }
    if (!moves && !given) return false;
    if (family == MotionFamily::unknown) {
        if (b.rapid) s.build.modal(Modal::rapid_block, s.block, end, program::whole_block);
        return moves;
    }
    s.build.modal(modal_of(s.iso.motion), s.block, end,
                  family < MotionFamily::polar_straight ? program::cartesian_path : 0);
    if (b.rapid) s.build.modal(Modal::rapid_block, s.block, end, program::whole_block);
    const bool about_pole = family == MotionFamily::polar_arc || (family == MotionFamily::arc && !b.has('R'));
    if (moves && about_pole) s.build.bare(Code::centre_at_pole, s.block, end);
    return moves;
}

class Words {
public:
    Words(State& s, const IsoBlock& b) : s_(s), b_(b), family_(family_of(s.iso.motion)) {}

    void read() {
        while (!s_.failed && !s_.in.at_end()) {
            const std::uint32_t begin = s_.in.at();
            read_word();
            no_exponent(s_, begin);
        }
    }

private:
    void read_word() {
        const std::uint32_t begin = s_.in.at();
        const char c = base::upper(s_.in.peek());
        if (c == 'G') return read_g(begin);
        if (const auto axis = axis_of(c)) {
            s_.in.step();
            coordinates_ = true;
            coordinate_word(s_, *axis, begin, behind_);
            if (!s_.failed && lacks_polar_word(c))
                fail(s_, begin, "a polar path function stands here without R and H",
                     "write R and H, or G00 to G06 for X and Y");
            return;
        }
        if (pole_letters.find(c) != std::string_view::npos) {  // read_pole has them
            s_.in.step();
            coordinates_ = true;
            return static_cast<void>(read_value(s_));
        }
        switch (c) {
            case 'F': return read_feed(s_);
            case 'M': s_.in.step(); return read_m(s_, begin);
            case 'S': s_.in.step(); return value_word(s_, Code::spindle, begin);
            case 'H': return read_angle(begin);
            case 'R': return read_radius(begin);
            case 'T': return read_tool_call(begin);
            case 'D':
                if (b_.has('T')) return read_oversize(s_, begin);
                break;
            default: break;
        }
        fail_here(s_, "this is no word of a block that moves: " + here(s_),
                  "G, X Y Z A B C U V W, I J K, R, H, F, S, T, M; Q, D, L and % stand in blocks of their own");
    }

    /// G10 … G16 are written here, for X or Y alone.
    [[nodiscard]] bool lacks_polar_word(char axis) const {
        if (family_ < MotionFamily::polar_straight || b_.has('R') || b_.has('H') || (axis != 'X' && axis != 'Y'))
            return false;
        for (int n = 10; n <= 16; ++n)
            if (b_.has_g(n)) return true;
        return false;
    }

    void read_angle(std::uint32_t begin) {
        s_.in.step();
        coordinates_ = true;
        const bool polar = family_ >= MotionFamily::polar_straight || family_ == MotionFamily::unknown;
        if (!polar) {
            static_cast<void>(read_value(s_));
            return fail(s_, begin, "the polar angle H needs a polar path function",
                        "G10 to G16 move in polar coordinates, G00 to G06 do not");
        }
        coordinate_word(s_, Code::polar_angle, begin, behind_);
    }

    void read_radius(std::uint32_t begin) {
        s_.in.step();
        const bool polar = family_ >= MotionFamily::polar_straight || (family_ == MotionFamily::unknown && b_.has('H'));
        if (polar) {
            coordinates_ = true;
            return coordinate_word(s_, Code::polar_radius, begin, behind_);
        }
        if (family_ == MotionFamily::arc || family_ == MotionFamily::unknown)
            return value_word(s_, Code::radius, begin);
        static_cast<void>(read_value(s_));
        fail(s_, begin, "R has no meaning in this block",
             "it is the radius of G02, G03, G05, of corners (G25) and of polar coordinates (G10 to G16)");
    }

    void read_tool_call(std::uint32_t begin) {
        s_.in.step();
        const std::size_t words = s_.build.unit().words.size();
        read_tool(s_);
        if (!s_.failed && s_.build.unit().words.size() == words)
            return fail(s_, begin, "the number or the name of a tool is due behind T", "T5 G17 S1000");
        if (!s_.failed) s_.build.bare(Code::tool_change, begin, s_.in.at());
    }

    void read_cycle_call(std::uint32_t begin) {
        s_.in.take(':');
        if (s_.in.take_word("PAT"))
            s_.build.modal(Modal::cycle_pattern, begin, s_.in.at());
        else if (b_.has_any(axis_letters))
            s_.build.modal(Modal::cycle_position, begin, s_.in.at());
        s_.build.bare(Code::cycle_call, begin, s_.in.at());
    }

    void read_g(std::uint32_t begin) {
        const int n = read_code(s_);
        if (n < 0 || family_of(n) != MotionFamily::unknown) return;
        const std::uint32_t end = s_.in.at();
        switch (n) {
            case 7:
            case 29:
            case 38: return;
            case 43:
            case 44:
                if (!b_.has_g(7))
                    s_.build.modal(n == 43 ? Modal::paraxial_longer : Modal::paraxial_shorter, begin, end);
                return;
            case 17: return s_.build.modal(Modal::plane_xy, begin, end);
            case 18: return s_.build.modal(Modal::plane_zx, begin, end);
            case 19: return s_.build.modal(Modal::plane_yz, begin, end);
            case 40:
                if (s_.iso.departure == program::no_expr)  // which ends it itself
                    s_.build.modal(Modal::compensation_off, begin, end);
                return;
            case 41: return s_.build.modal(Modal::compensation_left, begin, end);
            case 42: return s_.build.modal(Modal::compensation_right, begin, end);
            case 70: return s_.build.modal(Modal::inch_all, begin, end, program::unit_inside);
            case 71: return s_.build.modal(Modal::metric_all, begin, end, program::unit_inside);
            case 79: return read_cycle_call(begin);
            case 90:
            case 91:
                dimension(s_, n == 91, begin, coordinates_);
                if (coordinates_) behind_ = n == 91 ? Reference::incremental : Reference::absolute;
                return;
            default: return other_g(n, begin);
        }
    }

    void other_g(int n, std::uint32_t begin) {
        const dialect::heidenhain::GCode* g = dialect::heidenhain::find_g(n);
        if (g == nullptr)
            s_.build.problem(Code::unknown, begin, s_.in.at(), "");
        else if (g->use == dialect::heidenhain::Use::refused)
            s_.build.problem(Code::unsupported, begin, s_.in.at(), g->text);
        else
            fail(s_, begin, "G" + std::to_string(n) + " (" + std::string(g->text) + ") stands first in its block",
                 "write it in a block of its own");
    }

    State& s_;
    const IsoBlock& b_;
    MotionFamily family_;
    bool coordinates_ = false;         ///< one was read
    std::optional<Reference> behind_;  ///< G90 or G91 came behind a coordinate: what holds for the ones that follow
};

/// Nothing but a pole stands in the block.
bool is_pole_alone(const IsoBlock& b) {
    constexpr std::uint32_t own =
        1U << ('G' - 'A') | 1U << ('I' - 'A') | 1U << ('J' - 'A') | 1U << ('K' - 'A') | 1U << ('N' - 'A');
    for (const int g : b.g)
        if (g != 29) return false;
    return (b.letters & ~own) == 0;
}

}  // namespace

void read_iso_words(State& s, const IsoBlock& b) {
    const bool given = take_modal_codes(s, b);
    if (b.has_any(pole_letters) || b.has_g(29)) {
        read_pole(s);
        if (s.failed || is_pole_alone(b)) return s.in.skip_block();
    }
    s.build.statement(StatementKind::block, s.block);
    if (std::count_if(b.g.begin(), b.g.end(), [](int g) { return family_of(g) != MotionFamily::unknown; }) > 1) {
        const std::uint32_t from = s.in.at();
        s.in.skip_block();
        return fail(s, from, "two path functions stand in one block", "write one of them");
    }
    const bool moves = write_motion(s, b, given);
    const std::size_t words = s.build.unit().words.size();
    const std::uint32_t begin = s.in.at();
    if (moves) s.last_path = static_cast<std::uint32_t>(s.build.unit().statements.size() - 1);
    Words(s, b).read();
    if (moves) depart(s);
    if (!s.failed && b.has_g(38)) stop_here(s, words, begin, s.in.at());
}

}  // namespace obrys::read::heidenhain
