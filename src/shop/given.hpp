#pragma once
/// Values that the job gives for variables which no program at hand sets ([variables]).

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "base/source.hpp"

namespace obrys::shop {

enum class GivenKind : std::uint8_t {
    number,
    truth,  ///< `number` is 0 or 1
    text,   ///< of a numbered parameter that can be empty: "empty" says that it is
};

struct GivenValue {
    GivenKind kind = GivenKind::number;
    double number = 0;
    std::string text;
    base::Span where;
};

/// By the control's own spelling (`given_key`): "#517", "R5", "Q12", "MY_I[2]", "$A_IN[1]". Elements of an array stand
/// each under its own index.
using GivenValues = std::map<std::string, GivenValue>;

/// Capitals, without blanks: "my_i[ 2 ]" is "MY_I[2]".
[[nodiscard]] std::string given_key(std::string_view written);

}  // namespace obrys::shop
