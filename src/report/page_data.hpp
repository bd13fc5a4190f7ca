#pragma once
/// What the page's script works on, as JSON that may stand in a <script> element. Shape: the comments of page_data.cpp.

#include <string>

#include "report/report.hpp"

namespace obrys::report {

[[nodiscard]] std::string page_data(const Subject& subject, const HtmlOptions& options);

}  // namespace obrys::report
