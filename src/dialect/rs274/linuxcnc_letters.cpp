#include "dialect/rs274/linuxcnc.hpp"

namespace obrys::dialect::rs274 {

namespace {

using program::Code;

// G numbers times ten; `rs274` refuses a letter that none of the block's codes uses.
constexpr std::uint16_t for_d[]{410, 411, 420, 421, 700, 710, 711, 712, 720, 721, 722, 960};
constexpr std::uint16_t for_e[]{330, 331, 700, 760};
constexpr std::uint16_t for_h[]{430, 432, 760};
constexpr std::uint16_t for_i[]{20, 30, 50, 51, 100, 331, 710, 711, 712, 720, 721, 722, 760, 870};
constexpr std::uint16_t for_j[]{20, 30, 50, 51, 100, 760, 870};
constexpr std::uint16_t for_k[]{20, 30, 62, 330, 331, 760, 870};
constexpr std::uint16_t for_l[]{52, 100, 410, 411, 420, 421, 730, 760, 810, 820, 830, 840, 850, 860, 870, 880, 890};
constexpr std::uint16_t for_p[]{20, 30, 40, 50, 52, 62, 100, 640, 700, 740, 760, 820, 840, 860, 880, 890};
constexpr std::uint16_t for_q[]{50, 62, 100, 640, 700, 710, 711, 712, 720, 721, 722, 730, 760, 830};
constexpr std::uint16_t for_r[]{20,  30,  62,  100, 411, 421, 710, 711, 712, 720, 721, 722,
                                730, 740, 760, 810, 820, 830, 840, 850, 860, 870, 880, 890};

constexpr std::array letters{
    LetterUse{'D', Code::offset_d, for_d, {}},
    LetterUse{'E', Code::e, for_e, {NumberRange{66, 68}}},
    LetterUse{'H', Code::offset_h, for_h, {}},
    LetterUse{'I', Code::i, for_i, {}},
    LetterUse{'J', Code::j, for_j, {}},
    LetterUse{'K', Code::k, for_k, {}},
    LetterUse{'L', Code::l, for_l, {NumberRange{66, 66}}},
    LetterUse{'P', Code::p, for_p, {NumberRange{50, 53}, NumberRange{62, 66}, NumberRange{19, 19}}},
    LetterUse{'Q', Code::q, for_q, {NumberRange{61, 61}, NumberRange{66, 68}, NumberRange{19, 19}}},
    LetterUse{'R', Code::radius, for_r, {NumberRange{19, 19}}},
};

}  // namespace

const std::span<const LetterUse> linuxcnc_letters = letters;

}  // namespace obrys::dialect::rs274
