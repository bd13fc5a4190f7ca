#pragma once
/// What obrys does with a word of the control.

#include <cstdint>
#include <string_view>

namespace obrys::dialect::heidenhain {

enum class Use : std::uint8_t {
    run,       ///< its effect is in the stream
    accepted,  ///< known, no effect on the path: listed once with its count
    refused,   ///< known, not run: the verdict becomes "not fully checked"
};

[[nodiscard]] constexpr std::string_view name(Use use) {
    return use == Use::run ? "run" : use == Use::accepted ? "accepted" : "refused";
}

}  // namespace obrys::dialect::heidenhain
