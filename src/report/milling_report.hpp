#pragma once
/// The page of a check, and that of a milling check from its result (milling_page.hpp draws it).

#include "report/milling_page.hpp"
#include "report/subject.hpp"

namespace obrys::report {

/// `subject.result.milled` must be there.
[[nodiscard]] MillingPage milling_page_of(const Subject& subject);

/// The page of any check: of milling with the part in space, where the program was built with it.
[[nodiscard]] std::string page(const Subject& subject);
/// How many moves a check keeps for it: of a turned contour; of milling the ways.
inline constexpr std::size_t moves_on_page = 20'000, milled_moves_on_page = 200'000;

}  // namespace obrys::report
