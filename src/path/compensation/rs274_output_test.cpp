/// What rs274 prints, as calls, and where it differs from what was run here.

#include <unistd.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "base/number.hpp"
#include "path/compensation/rs274_testing.hpp"

namespace obrys::path::test {

double number(const std::string& text, std::size_t& i) {
    double v = 0;
    const char* begin = text.data() + i;
    if (*begin == '+') ++begin;
    const auto end = std::from_chars(begin, text.data() + text.size(), v).ptr;
    i = static_cast<std::size_t>(end - text.data());
    return v;
}

namespace {

std::vector<double> numbers(const std::string& text, std::size_t at) {
    std::vector<double> v;
    while (at < text.size() && text[at] != ')') {
        if (text[at] == ' ' || text[at] == ',' || text[at] == '(') {
            ++at;
            continue;
        }
        const std::size_t before = at;
        v.push_back(number(text, at));
        if (at == before) break;
    }
    return v;
}

std::optional<Call> call_of(const std::string& line) {
    struct Name {
        const char* text;
        Call::Kind kind;
    };
    static constexpr std::array<Name, 5> names{{{"STRAIGHT_TRAVERSE(", Call::Kind::traverse},
                                                {"STRAIGHT_FEED(", Call::Kind::feed},
                                                {"ARC_FEED(", Call::Kind::arc},
                                                {"FLOOD_O", Call::Kind::flood},
                                                {"MESSAGE(\"c", Call::Kind::marker}}};
    for (const Name& n : names) {
        const std::size_t at = line.find(n.text);
        if (at == std::string::npos) continue;
        const std::size_t behind = at + std::string_view(n.text).size();
        if (n.kind == Call::Kind::flood) return Call{n.kind, {line[behind] == 'N' ? 1.0 : 0.0}, 0};
        Call c{n.kind, numbers(line, behind), 0};
        c.values.resize(n.kind == Call::Kind::arc ? 6 : n.kind == Call::Kind::marker ? 1 : 3);
        return c;
    }
    return std::nullopt;
}

/// Of a block, or of a line of rs274.
int block_number(const std::string& line) {
    std::size_t at = line.find('N');
    return at == std::string::npos ? 0 : static_cast<int>(number(line, ++at));
}

std::string temporary(const char* what) {
    return (std::filesystem::temp_directory_path() / ("obrys_" + std::to_string(getpid()) + what)).string();
}

/// The last line of each of rs274's complaints is the block; stretches are told apart by the blocks' place.
void add_refusals(std::vector<Stretch>& stretches, const std::string& complaints, const std::string& program) {
    std::map<std::string, std::size_t> stretch_of;
    std::istringstream lines(program);
    std::size_t stretch = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.find("(MSG,c") != std::string::npos) ++stretch;
        stretch_of.emplace(line, stretch);
    }
    std::istringstream in(complaints);
    std::string last;
    for (std::string line; std::getline(in, line);) {
        const std::string before = line.empty() ? last : std::exchange(last, line);
        const auto found = stretch_of.find(line);
        if (found == stretch_of.end() || before.empty() || before == "executing") continue;
        if (found->second >= stretches.size()) continue;
        Stretch& s = stretches[found->second];
        if (!s.refusal.empty()) continue;
        s.refusal = before;
        s.block = line;
    }
}

}  // namespace

std::string text_of(const Call& c) {
    static constexpr std::array<const char*, 5> names{"traverse", "feed", "arc", "flood", "marker"};
    std::string text = names[static_cast<std::size_t>(c.kind)];
    for (const double v : c.values) text += " " + base::fixed(v, 4);
    return text;
}

bool same(const Call& a, const Call& b, double tolerance) {
    if (a.kind != b.kind || a.values.size() != b.values.size()) return false;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        if (!(std::abs(a.values[i] - b.values[i]) <= tolerance)) return false;
    return true;
}

std::string whole_file(const std::string& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<Stretch> calls_of(const std::string& output) {
    std::vector<Stretch> stretches(1);
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        auto c = call_of(line);
        if (!c) continue;
        c->block = block_number(line);
        if (c->kind == Call::Kind::marker) stretches.emplace_back();
        stretches.back().calls.push_back(*c);
    }
    return stretches;
}

bool have_rs274() { return std::filesystem::exists("/usr/bin/rs274"); }

std::vector<Stretch> run_rs274(const std::string& program, const std::vector<TableTool>& table) {
    const std::string in = temporary(".ngc"), out = temporary(".out"), err = temporary(".err"),
                      tools = temporary(".tbl"), home = temporary(".home");
    std::filesystem::create_directories(home);
    std::ofstream(in) << program;
    std::ofstream tbl(tools);
    for (const TableTool& t : table)
        tbl << "T" << t.number << " P" << t.number << " D" << base::fixed(t.diameter, 6) << " Q" << t.orientation
            << "\n";
    tbl.close();
    // It maps $HOME/.tool.mmap: two of them in one home see each other's tools.
    const std::string command = "HOME=" + home + " timeout 20 /usr/bin/rs274 -g -n 0 -t " + tools + " " + in + " >" +
                                out + " 2>" + err + " </dev/null";
    const int status = std::system(command.c_str());
    std::vector<Stretch> stretches = calls_of(whole_file(out));
    add_refusals(stretches, whole_file(err), program);
    for (const std::string& f : {in, out, err, tools, home}) std::filesystem::remove_all(f);
    return status == 0 ? stretches : std::vector<Stretch>(1);
}

std::string difference(const Stretch& here, const Stretch& there) {
    if (here.refusal != there.refusal || here.block != there.block)
        return "refused here: \"" + here.refusal + "\" at " + here.block + "; there: \"" + there.refusal + "\" at " +
               there.block;
    const std::size_t n = std::min(here.calls.size(), there.calls.size());
    for (std::size_t i = 0; i < n; ++i)
        if (!same(here.calls[i], there.calls[i], 1e-4))
            return "call " + std::to_string(i) + " here: " + text_of(here.calls[i]) +
                   "; there: " + text_of(there.calls[i]);
    if (here.calls.size() > n) return "only here: " + text_of(here.calls[n]);
    const bool stopped = !there.refusal.empty() && there.calls.size() > n &&
                         there.calls[n].block > block_number(there.block);  // rs274 runs on behind its complaint
    if (there.calls.size() > n && !stopped) return "only there: " + text_of(there.calls[n]);
    return {};
}

}  // namespace obrys::path::test
