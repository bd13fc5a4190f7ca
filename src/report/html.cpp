#include "report/page_data.hpp"
#include "report/page_parts.hpp"
#include "report/path.hpp"
#include "report/report.hpp"

namespace obrys::report {

void put(std::string& page, std::string_view mark, std::string_view with) {
    const std::size_t at = page.find(mark);
    if (at != std::string::npos) page.replace(at, mark.size(), with);
}

std::string for_script(std::string_view json) {
    std::string out;
    out.reserve(json.size());
    for (const char c : json) {
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    }
    return out;
}

std::string to_html(const Subject& subject, const HtmlOptions& options) {
    std::string page(page_html);
    // From the end to the start, so that no mark is looked for in text that was put in.
    put(page, "@SCRIPT@", page_js);
    put(page, "@DATA@", page_data(subject, options));
    put(page, "@STYLE@", page_css);
    put(page, "@TITLE@", escaped(subject.program + ": " + verdict_line(subject.result)));
    return page;
}

}  // namespace obrys::report
