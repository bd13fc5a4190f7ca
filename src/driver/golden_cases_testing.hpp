#pragma once
/// Test side only: the programs of the golden cases, and sessions in which they are run.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "driver/session.hpp"

namespace obrys::driver::testing {

namespace fs = std::filesystem;

struct Case {
    std::string name, file, text;
};

/// The file of a golden case that is run: the first one behind its command.
inline Case read_case(const fs::path& path) {
    std::ifstream in(path);
    Case c;
    c.name = path.stem().string();
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("--- ")) {
            if (inside) break;
            inside = line.starts_with("--- in") || line.starts_with("--- file ");
            if (inside) c.file = line.starts_with("--- in") ? "in" : line.substr(9, line.find(' ', 9) - 9);
        } else if (inside) {
            c.text += line + "\n";
        }
    }
    return c;
}

/// The cases of a folder in the order of their names.
inline std::vector<Case> golden_cases(const std::string& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(OBRYS_SOURCE_DIR) / "tests/golden" / folder))
        if (entry.path().extension() == ".txt") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<Case> cases;
    for (const fs::path& path : paths) cases.push_back(read_case(path));
    return cases;
}

/// Reads the case's program as one of the control; false where there is none. Tools 1, 2 and 3 have a radius of 1, 2
/// and 3 mm.
inline bool open_case(Session& s, const Case& c, std::string_view of, shop::MachineKind kind) {
    const Control* control = find_control(std::string(of));
    const auto file = s.sources.add(c.file, c.text, language_of(*control, c.text, c.file).numbers);
    s.programs = std::make_unique<Programs>(*control, s.sources, s.diagnostics);
    s.job.machine.kind = kind;
    s.programs->set_machine(&s.job.machine);
    s.job.budgets.blocks = 150;
    s.main = s.programs->read(file);
    if (s.main == nullptr) return false;
    for (const std::uint32_t number : {1U, 2U, 3U}) {
        shop::Tool tool;
        tool.number = number;
        tool.kind = kind == shop::MachineKind::lathe ? shop::ToolKind::turning : shop::ToolKind::end_mill;
        tool.radius = number;
        tool.length = 100 + 10 * number;
        s.job.tools.push_back(tool);
    }
    return true;
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// One to three changes: blocks left out, doubled, exchanged, words put in; a word that begins with a line end is a
/// block.
inline std::string mutated(const std::string& text, std::mt19937& random, const std::vector<std::string_view>& words) {
    std::vector<std::string> lines = lines_of(text);
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    for (std::size_t n = 1 + below(3); n > 0 && lines.size() > 2; --n) {
        const std::size_t i = 1 + below(lines.size() - 1);
        const auto at = lines.begin() + static_cast<std::ptrdiff_t>(i);
        switch (below(4)) {
            case 0: lines.erase(at); break;
            case 1: lines.insert(at, std::string(lines[below(lines.size())])); break;
            case 2: std::swap(lines[i], lines[below(lines.size())]); break;
            default: {
                const std::string word(words[below(words.size())]);
                if (word.starts_with('\n'))
                    lines.insert(at, word.substr(1));
                else
                    lines[i] += word;
            }
        }
    }
    std::string out;
    for (const std::string& line : lines) out += line + "\n";
    return out;
}

}  // namespace obrys::driver::testing
