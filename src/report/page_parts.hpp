#pragma once
/// The files of page/, compiled in by page/embed.cmake.

#include <string_view>

namespace obrys::report {

extern const std::string_view page_html, page_css, page_js;

}  // namespace obrys::report
