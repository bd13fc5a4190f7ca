#pragma once
/// Which G and M codes of a text a control has not: what speaks against it being written for that control.

#include <string_view>

#include "dialect/rs274/tables.hpp"

namespace obrys::read::rs274 {

/// Different G codes (and, with `m_codes`, M codes below 100) of the text that `dialect` does not know, up to a dozen.
/// `code`: upper case, without blanks and comments.
[[nodiscard]] int count_unknown_codes(std::string_view code, const dialect::rs274::Dialect& dialect, bool m_codes);

}  // namespace obrys::read::rs274
