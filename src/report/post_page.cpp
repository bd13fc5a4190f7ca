#include "report/post_page.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/page_parts.hpp"
#include "report/path.hpp"

namespace obrys::report {

namespace {

using Json = nlohmann::ordered_json;

std::string values_line(const PostRow& row) {
    std::string out;
    for (const auto& [name, value] : row.values) out += (out.empty() ? "" : " ") + name + "=" + value;
    return out;
}

std::string row_html(const PostRow& row) {
    std::string out = "<div><h2>" + escaped(row.name) + "</h2>";
    if (!row.form.empty()) out += "<div class=\"values\">" + escaped(row.form) + "</div>";
    if (!row.blocks.empty()) {
        out += "<pre>";
        for (const std::string& block : row.blocks) out += escaped(block) + "\n";
        out += "</pre>";
    }
    if (!row.fault.empty()) out += "<div class=\"fault\">" + escaped(row.fault) + "</div>";
    out += "<div class=\"values\">";
    for (const auto& [name, value] : row.values) out += escaped(name) + " <b>" + escaped(value) + "</b> ";
    return out + "</div></div>\n";
}

std::string padded(std::string text, std::size_t width) {
    if (text.size() < width) text.append(width - text.size(), ' ');
    return text;
}

std::size_t count(const PostCheck& check, std::string_view outcome) {
    return static_cast<std::size_t>(std::count_if(check.samples.begin(), check.samples.end(),
                                                  [&](const PostSample& s) { return s.outcome == outcome; }));
}

std::size_t count_read(const PostCheck& check, std::string_view read) {
    return static_cast<std::size_t>(
        std::count_if(check.samples.begin(), check.samples.end(), [&](const PostSample& s) { return s.read == read; }));
}

std::string summary(const PostCheck& c) {
    std::string out = c.name + (c.title.empty() ? "" : ": " + c.title) + "\n" + std::to_string(c.samples.size()) +
                      " samples: " + std::to_string(count(c, "written")) + " written, " +
                      std::to_string(count(c, "expanded")) + " by their moves or other words, " +
                      std::to_string(count(c, "refused")) + " refused, " + std::to_string(count(c, "nothing")) +
                      " that need no words\n";
    if (!c.has_reader) return out + "nothing is read back: the post names no control that can be read\n";
    return out + "read back by " + c.control + ": " + std::to_string(count_read(c, "same")) + " the same, " +
           std::to_string(count_read(c, "said-otherwise")) + " the same in other words, " +
           std::to_string(count_read(c, "differs")) + " otherwise, " + std::to_string(count_read(c, "unclear")) +
           " not understood\n";
}

std::string sample_text(const PostSample& s, bool all) {
    const bool remarkable = s.read == "differs" || s.read == "unclear" || s.outcome == "refused";
    std::string out = padded(s.outcome, 9) + "  " + s.name + "\n";
    if (all || remarkable || s.outcome == "expanded")
        for (const std::string& note : s.notes) out += "             " + note + "\n";
    if (all || s.read == "differs" || s.read == "unclear")
        for (const std::string& block : s.blocks) out += "           | " + block + "\n";
    for (const std::string& d : s.differences)
        out += std::string("           ") +
               (s.read == "differs"   ? "reads back otherwise: "
                : s.read == "unclear" ? "not understood: "
                                      : "reads back in other words: ") +
               d + "\n";
    return out;
}

}  // namespace

std::string preview_text(const PostSheet& sheet) {
    std::string out;
    for (const PostRow& row : sheet.rows) {
        out += row.name + (row.form.empty() ? "" : " (" + row.form + ")") + "\n";
        if (!row.values.empty()) out += "  with " + values_line(row) + "\n";
        for (const std::string& block : row.blocks) out += "  | " + block + "\n";
        if (!row.fault.empty()) out += "  writes nothing: " + row.fault + "\n";
    }
    return out;
}

std::string preview_html(const PostSheet& sheet) {
    std::string page(post_html), rows;
    for (const PostRow& row : sheet.rows) rows += row_html(row);
    put(page, "@ROWS@", rows);
    put(page, "@ABOUT@", escaped(sheet.title + (sheet.control.empty() ? "" : " · read back by " + sheet.control)));
    put(page, "@TITLE@", escaped("Post " + sheet.name));  // the heading, which is the last one
    put(page, "@STYLE@", page_css);
    put(page, "@TITLE@", escaped("Post " + sheet.name));
    return page;
}

std::string post_check_text(const PostCheck& check, bool all) {
    std::string out = summary(check);
    for (const PostSample& s : check.samples) out += sample_text(s, all);
    return out;
}

std::string post_check_json(const PostCheck& check) {
    Json samples = Json::array();
    for (const PostSample& s : check.samples)
        samples.push_back({{"name", s.name},
                           {"kind", s.kind},
                           {"outcome", s.outcome},
                           {"read_back", s.read},
                           {"blocks", s.blocks},
                           {"notes", s.notes},
                           {"differences", s.differences}});
    const Json out{{"post", check.name},
                   {"title", check.title},
                   {"control", check.control},
                   {"has_reader", check.has_reader},
                   {"written", count(check, "written")},
                   {"expanded", count(check, "expanded")},
                   {"refused", count(check, "refused")},
                   {"differs", count_read(check, "differs")},
                   {"unclear", count_read(check, "unclear")},
                   {"samples", samples}};
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string post_list_text(const std::vector<PostLine>& posts) {
    std::size_t name = 4, title = 5, extends = 7;
    for (const PostLine& p : posts) {
        name = std::max(name, p.name.size());
        title = std::max(title, p.title.size());
        extends = std::max(extends, p.extends.size());
    }
    std::string out =
        padded("post", name) + "  " + padded("title", title) + "  " + padded("extends", extends) + "  read back by\n";
    for (const PostLine& p : posts)
        out += padded(p.name, name) + "  " + padded(p.title, title) + "  " +
               padded(p.extends.empty() ? "-" : p.extends, extends) + "  " + (p.control.empty() ? "-" : p.control) +
               "\n";
    return out;
}

std::string post_list_json(const std::vector<PostLine>& posts) {
    Json all = Json::array();
    for (const PostLine& p : posts)
        all.push_back({{"name", p.name}, {"title", p.title}, {"extends", p.extends}, {"control", p.control}});
    return Json{{"posts", all}}.dump(2) + "\n";
}

}  // namespace obrys::report
