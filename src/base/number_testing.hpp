#pragma once
/// Test side only: numbers as programmers write them.

#include <rapidcheck.h>

#include <algorithm>
#include <string>

namespace obrys::base::testing {

/// Sign, digits, point (or comma, where `comma`), digits, at least one digit.
inline rc::Gen<std::string> number_text(bool comma = false) {
  const auto digits = rc::gen::container<std::string>(
      rc::gen::inRange('0', static_cast<char>('9' + 1)));
  return rc::gen::apply(
      [comma](const std::string &sign, std::string whole, std::string fraction,
              int shape) {
        whole.resize(std::min<std::size_t>(whole.size(), 12));
        fraction.resize(std::min<std::size_t>(fraction.size(), 12));
        if (shape == 0)
          return sign + (whole.empty() ? "7" : whole);
        if (whole.empty() && fraction.empty())
          fraction = "5";
        return sign + whole + (comma && shape == 1 ? "," : ".") + fraction;
      },
      rc::gen::element<std::string>("", "-", "+"), digits, digits,
      rc::gen::inRange(0, comma ? 4 : 3));
}

} // namespace obrys::base::testing
