#pragma once
/// The files of page/ and the script made of web/, compiled in by page/embed.cmake; what puts them together.

#include <string>
#include <string_view>

namespace obrys::report {

extern const std::string_view page_html, page_css, page_js;
extern const std::string_view post_html;
/// Empty script: the library was built without node and npm.
extern const std::string_view milling_html, milling_css, milling_js;

/// Puts `with` in the place of the mark, which stands once in the template.
void put(std::string& page, std::string_view mark, std::string_view with);
/// JSON as it may stand in a script element: inside one "<" could end it; as an escape it means the same.
[[nodiscard]] std::string for_script(std::string_view json);

}  // namespace obrys::report
