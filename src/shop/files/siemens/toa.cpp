// Meaning of the parameters: SINUMERIK 840D/840Di/810D Programming Guide Advanced (PGA) 04.00, section 8.1, page 8-265
// (1 type, 2 cutting edge position, 3-5 lengths, 6 radius, 12-14 wear of the lengths, 15 wear of the radius, 21-23 base
// dimensions; geometry, wear and base are added up), and the Programming Manual Job Planning 07/2010, section 7.1.
// Mills (Job Planning 03/2006, section 8.5): 7 + 16 the corner radius, of a side mill and a saw its width, 11 + 20 the
// angle of a cone against the tool's axis. Types: the list of tool types of the same manuals.
#include <algorithm>
#include <map>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "shop/files/dropped.hpp"
#include "shop/files/section.hpp"
#include "shop/files/siemens/toa.hpp"
#include "shop/files/siemens/toa_mills.hpp"
#include "shop/size_range.hpp"

namespace obrys::shop {

namespace {

constexpr std::int64_t largest_toa_tool = 999'999'999, largest_edge = 99;
constexpr int largest_type = 9999;
constexpr int parameters = 25, radius_parameter = 6;

/// One text of the file while it is taken apart, with the offset of its first byte.
struct Piece {
    std::string_view text;
    std::uint32_t at = 0;

    [[nodiscard]] Piece part(std::size_t from, std::size_t count = std::string_view::npos) const {
        from = std::min(from, text.size());
        Piece p{text.substr(from, count), at + static_cast<std::uint32_t>(from)};
        while (!p.text.empty() && base::is_blank(p.text.front())) p.text.remove_prefix(1), ++p.at;
        p.text = base::trim(p.text);
        return p;
    }
};

class ToaReader {
public:
    ToaReader(std::uint32_t file, base::Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

    void line(Piece line);
    [[nodiscard]] std::vector<Tool> tools() const;
    void report_dropped() const { dropped_.report(diagnostics_); }
    void report_other_lines();

private:
    void complain(std::string_view code, Piece where, std::string text, std::string remedy = {}) {
        base::Diagnostic d;
        d.remedy = std::move(remedy);
        d.code = code;
        d.where = {file_, where.at, where.at + static_cast<std::uint32_t>(where.text.size())};
        d.text = std::move(text);
        diagnostics_.add(std::move(d));
    }
    void assignment(Piece name, Piece indices, Piece value);
    void tool_parameter(int n, Piece indices, Piece value);
    std::optional<std::int64_t> index(Piece text, std::int64_t most, const std::string& what);

    std::uint32_t file_;
    base::Diagnostics& diagnostics_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Tool> tools_;
    std::map<std::uint32_t, std::string> names_;
    Dropped dropped_;
    std::size_t other_lines_ = 0, data_lines_ = 0;
    Piece first_other_;
};

/// The line without its comment; a `;` inside quotes is text.
std::string_view without_comment(std::string_view line) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (line[i] == ';' && !quoted) return line.substr(0, i);
    }
    return line;
}

/// Lines that frame the data of a file or an archive: they carry nothing about a tool.
bool is_frame(std::string_view line) {
    const std::string s = base::to_upper(line);
    return s.starts_with('%') || s.starts_with("CHANDATA") || s == "M17" || s == "M2" || s == "M02" || s == "M30" ||
           s == "RET";
}

void ToaReader::line(Piece line) {
    line = Piece{without_comment(line.text), line.at}.part(0);
    if (!line.text.empty() && base::upper(line.text[0]) == 'N' && line.text.size() > 1 &&
        base::is_digit(line.text[1])) {
        std::size_t digits = 1;
        while (digits < line.text.size() && base::is_digit(line.text[digits])) ++digits;
        line = line.part(digits);
    }
    if (line.text.empty() || is_frame(line.text)) return;
    const std::size_t open = line.text.find('['), shut = line.text.find(']'), equals = line.text.find('=');
    if (line.text[0] != '$' || equals == std::string_view::npos) {
        if (other_lines_++ == 0) first_other_ = line;
        return;
    }
    ++data_lines_;
    const bool indexed = open < shut && shut < equals;
    assignment(line.part(0, indexed ? open : equals), indexed ? line.part(open + 1, shut - open - 1) : Piece{},
               line.part(equals + 1));
}

/// Once for all of them: a program in place of tool data has as many as it has blocks.
void ToaReader::report_other_lines() {
    if (other_lines_ == 0) return;
    if (data_lines_ == 0)
        return complain(base::codes::job_file, first_other_,
                        "this is no tool data: no line of the file is like $TC_DP1[1,1]=500",
                        "lists of tools end in .toml, tables of controls in .t or .tbl, libraries of Fusion in "
                        ".json; an NC program is the 'program' of a job");
    const std::size_t more = other_lines_ - 1;
    complain(base::codes::job_file, first_other_,
             "this is not a line of tool data ($TC_DP1[1,1]=500)" +
                 (more == 0 ? std::string{} : ", nor are " + std::to_string(more) + " others of the file"));
}

void ToaReader::assignment(Piece name, Piece indices, Piece value) {
    const std::string upper = base::to_upper(name.text);
    const auto n = upper.starts_with("$TC_DP") ? base::parse_integer(std::string_view(upper).substr(6)) : std::nullopt;
    if (n && *n >= 1 && *n <= parameters) return tool_parameter(static_cast<int>(*n), indices, value);
    if (upper == "$TC_TP2") {
        const auto tool = index(indices, largest_toa_tool, "tool number");
        if (!tool) return;
        if (value.text.size() < 2 || value.text.front() != '"' || value.text.back() != '"')
            return complain(base::codes::job_value, value, "a tool name stands in quotes");
        names_[static_cast<std::uint32_t>(*tool)] = base::as_utf8(value.text.substr(1, value.text.size() - 2));
        return;
    }
    if (upper.starts_with("$TC_")) {
        dropped_.add(upper, {file_, name.at, name.at + static_cast<std::uint32_t>(name.text.size())});
        return;
    }
    complain(base::codes::job_file, name, "this is not a name of tool data ($TC_DP1 … $TC_DP25, $TC_TP2)");
}

std::optional<std::int64_t> ToaReader::index(Piece text, std::int64_t most, const std::string& what) {
    const auto n = base::parse_integer(text.text);
    if (n && *n >= 1 && *n <= most) return n;
    complain(base::codes::job_value, text, "the " + what + " is a whole number from 1 to " + std::to_string(most));
    return std::nullopt;
}

void ToaReader::tool_parameter(int n, Piece indices, Piece value) {
    const std::size_t comma = indices.text.find(',');
    if (comma == std::string_view::npos)
        return complain(base::codes::job_value, indices, "tool data need a tool and an edge: [T,D]");
    const auto tool = index(indices.part(0, comma), largest_toa_tool, "tool number");
    const auto edge = index(indices.part(comma + 1), largest_edge, "edge number");
    if (!tool || !edge) return;
    const auto v = base::parse_double(value.text);
    if (!v) return complain(base::codes::job_value, value, "the value must be a finite number");
    if (n == 2 && !base::whole<int>(*v, 0, 9))
        return complain(base::codes::job_value, value,
                        "the cutting edge position ($TC_DP2) is a whole number from 1 to 9");
    if (n == 1 && !base::whole<int>(*v, 0, largest_type))
        return complain(base::codes::job_value, value,
                        "the tool type ($TC_DP1) is a whole number from 0 to " + std::to_string(largest_type));
    if (const std::string problem = size_problem(*v, n == radius_parameter); !problem.empty())
        return complain(base::codes::job_value, value, "$TC_DP" + std::to_string(n) + " " + problem);
    const auto t = static_cast<std::uint32_t>(*tool), d = static_cast<std::uint32_t>(*edge);
    auto [found, is_new] = tools_.try_emplace({t, d});
    if (is_new) {
        found->second.number = t;
        found->second.edge = d;
        found->second.where = {file_, indices.at, indices.at + static_cast<std::uint32_t>(indices.text.size())};
    }
    found->second.parameters[n] = *v;
}

/// Fills in what the parameters say about the shape.
void shape(Tool& t) {
    const auto sum = [&](std::initializer_list<int> numbers) {
        double s = 0;
        for (const int n : numbers)
            if (const auto p = t.parameters.find(n); p != t.parameters.end()) s += p->second;
        return s;
    };
    const double type = sum({1}), radius = sum({6, 15});
    t.length = sum({3, 12, 21});
    // 520 and 530 are grooving and parting tools: their width is not among the parameters, so they stay `other`.
    const bool turning = type >= 500 && type < 600 && !(type >= 520 && type < 540);
    if (!turning) {
        t.radius = radius;
        take_mill(t, base::clipped<int>(type, 0, largest_type));
        return;
    }
    t.kind = ToolKind::turning;
    t.nose_radius = std::max(0.0, radius);
    const int position = base::clipped<int>(sum({2}), 0, 9);
    t.orientation = position >= 1 ? position : 3;
    if (t.orientation >= 5) t.entering_angle = 90 - t.tip_angle / 2;
    if (position < 1) t.assumed = "cutting edge position 3, ";
    t.assumed += "tip angle " + base::shortest(t.tip_angle) + " degrees, entering angle " +
                 base::shortest(t.entering_angle) + " degrees, edge length " + base::shortest(t.edge_length) + " mm";
}

std::vector<Tool> ToaReader::tools() const {
    std::vector<Tool> out;
    for (const auto& [key, tool] : tools_) {
        out.push_back(tool);
        if (const auto name = names_.find(key.first); name != names_.end()) out.back().name = name->second;
        shape(out.back());
    }
    return out;
}

}  // namespace

std::vector<Tool> read_toa(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    base::Diagnostics found;
    ToaReader reader(file, found);
    const std::string_view text = sources[file].text;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        reader.line({text.substr(begin, end - begin), static_cast<std::uint32_t>(begin)});
        begin = end + 1;
    }
    reader.report_other_lines();
    reader.report_dropped();
    add_in_order(found, diagnostics);
    return reader.tools();
}

}  // namespace obrys::shop
