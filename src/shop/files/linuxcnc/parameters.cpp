#include "shop/files/linuxcnc/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "shop/files/lines.hpp"

namespace obrys::shop {

namespace {

/// The next word of a line from `from` on; empty at its end.
std::string_view word(std::string_view line, std::size_t from) {
    while (from < line.size() && base::is_blank(line[from])) ++from;
    std::size_t stop = from;
    while (stop < line.size() && !base::is_blank(line[stop])) ++stop;
    return line.substr(std::min(from, line.size()), stop - from);
}

bool holds_no_parameter(std::string_view line) {
    const std::string_view s = base::trim(line);
    return s.empty() || s.front() == ';' || s.front() == '#' || s.front() == '(';
}

class FileReader {
public:
    FileReader(LinuxcncParameters& parameters, base::Diagnostics& diagnostics)
        : p_(parameters), diagnostics_(diagnostics) {}

    void line(const TableLine& text);
    void finish();

private:
    void tell(base::Severity severity, std::string_view code, base::Span where, std::string text, std::string remedy) {
        diagnostics_.add({severity, code, where, std::move(text), std::move(remedy), {}, {}});
    }

    LinuxcncParameters& p_;
    base::Diagnostics& diagnostics_;
    int last_ = 0;
};

void FileReader::line(const TableLine& text) {
    LinuxcncParameter& l = p_.lines.emplace_back();
    l.text = text.text;
    l.line_end = text.end;
    l.at = text.at;
    if (holds_no_parameter(l.text)) return;
    const std::string_view name = word(l.text, 0);
    const auto name_at = static_cast<std::uint32_t>(name.data() - l.text.data());
    const std::string_view digits = word(l.text, name_at + name.size());
    const auto number = base::parse_integer(name);
    const auto value = base::parse_double(digits);
    if (!number || !value) {
        const auto end = static_cast<std::uint32_t>(l.text.size());
        return tell(base::Severity::warning, base::codes::job_file, {p_.file, l.at + name_at, l.at + end},
                    "this line is no parameter", "a parameter is its number, a tab and its value");
    }
    const base::Span where{p_.file, l.at + name_at, l.at + name_at + static_cast<std::uint32_t>(name.size())};
    if (*number < 1 || *number > last_linuxcnc_parameter)
        return tell(base::Severity::error, base::codes::job_value, where,
                    "a parameter has a number from 1 to " + std::to_string(last_linuxcnc_parameter), "");
    if (*number <= last_)
        return tell(base::Severity::error, base::codes::job_value, where,
                    "parameter " + std::to_string(*number) + " does not come after " + std::to_string(last_),
                    "LinuxCNC refuses the file: bring the lines into the order of their numbers, each once");
    last_ = static_cast<int>(*number);
    l.number = last_;
    l.value = *value;
    l.begin = static_cast<std::uint32_t>(digits.data() - l.text.data());
    l.end = l.begin + static_cast<std::uint32_t>(digits.size());
}

void FileReader::finish() {
    std::set<int> there;
    for (const LinuxcncParameter& l : p_.lines) there.insert(l.number);
    const auto& needed = needed_parameters();
    const auto missing = [&](int n) { return !there.contains(n); };
    const auto first = std::find_if(needed.begin(), needed.end(), missing);
    if (first == needed.end()) return;
    const auto count = std::count_if(needed.begin(), needed.end(), missing);
    tell(base::Severity::note, base::codes::assumption, {p_.file, 0, 0},
         std::to_string(count) + " of the parameters that LinuxCNC keeps are not in the file, the first is " +
             std::to_string(*first),
         "they count as 0");
}

}  // namespace

LinuxcncParameters read_linuxcnc_parameters(std::uint32_t file, const base::Sources& sources,
                                            base::Diagnostics& diagnostics) {
    LinuxcncParameters p;
    p.file = file;
    FileReader reader(p, diagnostics);
    for (TableLines lines(sources[file].text); !lines.done();) reader.line(lines.take());
    reader.finish();
    return p;
}

std::string write_linuxcnc_parameters(const LinuxcncParameters& p) {
    std::string out;
    for (const LinuxcncParameter& l : p.lines) {
        out += l.text;
        out += l.line_end;
    }
    return out;
}

std::optional<double> value_of(const LinuxcncParameters& p, int number) {
    for (const LinuxcncParameter& l : p.lines)
        if (l.number == number && number > 0) return l.value;
    return std::nullopt;
}

std::map<int, double> values_of(const LinuxcncParameters& p) {
    std::map<int, double> out;
    for (const LinuxcncParameter& l : p.lines)
        if (l.number > 0) out.emplace(l.number, l.value);
    return out;
}

std::optional<std::string> set_parameter(LinuxcncParameters& p, int number, double value) {
    if (number < 1 || number > last_linuxcnc_parameter)
        return "a parameter has a number from 1 to " + std::to_string(last_linuxcnc_parameter);
    if (!std::isfinite(value)) return "#" + std::to_string(number) + ": the value is not finite";
    const std::string text = base::fixed(value, 6);
    for (LinuxcncParameter& l : p.lines) {
        if (l.number != number) continue;
        l.text.replace(l.begin, l.end - l.begin, text);
        l.end = l.begin + static_cast<std::uint32_t>(text.size());
        l.value = value;
        return std::nullopt;
    }
    // Behind the last smaller number; where there is none, before the first larger one, or at the end.
    std::size_t at = p.lines.size();
    while (at > 0 && !(p.lines[at - 1].number > 0 && p.lines[at - 1].number < number)) --at;
    if (at == 0)
        at = static_cast<std::size_t>(
            std::find_if(p.lines.begin(), p.lines.end(), [](const LinuxcncParameter& l) { return l.number > 0; }) -
            p.lines.begin());
    const auto ended =
        std::find_if(p.lines.begin(), p.lines.end(), [](const LinuxcncParameter& l) { return !l.line_end.empty(); });
    LinuxcncParameter l;
    l.line_end = ended == p.lines.end() ? "\n" : ended->line_end;
    l.text = std::to_string(number) + "\t" + text;
    l.number = number;
    l.value = value;
    l.end = static_cast<std::uint32_t>(l.text.size());
    l.begin = l.end - static_cast<std::uint32_t>(text.size());
    if (at > 0 && p.lines[at - 1].line_end.empty()) std::swap(l.line_end, p.lines[at - 1].line_end);
    p.lines.insert(p.lines.begin() + static_cast<std::ptrdiff_t>(at), std::move(l));
    return std::nullopt;
}

const std::vector<int>& needed_parameters() {
    static const std::vector<int> numbers = [] {
        std::vector<int> n;
        const auto range = [&n](int first, int last) {
            for (int i = first; i <= last; ++i) n.push_back(i);
        };
        range(5161, 5169);
        range(5181, 5189);
        range(5210, 5230);
        for (int system = 5241; system <= 5381; system += 20) range(system, system + 9);
        return n;
    }();
    return numbers;
}

}  // namespace obrys::shop
