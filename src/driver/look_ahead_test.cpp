/// Looking ahead leaves no trace: with some statements tried before every one that is run, each golden program makes
/// the same moves, the same parameters and the same complaints.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "cl/text.hpp"
#include "driver/session.hpp"

namespace obrys::driver {
namespace {

namespace fs = std::filesystem;

struct Case {
    std::string name, file, text;
};

/// The file of a golden case that is run: the first one behind its command.
Case read_case(const fs::path& path) {
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

std::string outcome(const Case& c, std::string_view of, shop::MachineKind kind, std::uint32_t ahead) {
    Session s;
    const Control* control = find_control(std::string(of));
    const auto file = s.sources.add(c.file, c.text, language_of(*control, c.text, c.file).numbers);
    s.programs = std::make_unique<Programs>(*control, s.sources, s.diagnostics);
    s.job.machine.kind = kind;
    s.programs->set_machine(&s.job.machine);
    s.job.budgets.blocks = 150;
    s.looked_ahead_in_vain = ahead;
    s.main = s.programs->read(file);
    if (s.main == nullptr) return {};
    for (const std::uint32_t number : {1U, 2U, 3U}) {
        shop::Tool tool;
        tool.number = number;
        tool.kind = kind == shop::MachineKind::lathe ? shop::ToolKind::turning : shop::ToolKind::end_mill;
        tool.radius = number;
        tool.length = 100 + 10 * number;
        s.job.tools.push_back(tool);
    }
    std::string out;
    const auto end = interpret(s, [&](const cl::Record& r) {
        const std::string line = cl::to_text(r);
        out += line.substr(0, line.find(" @")) + "\n";
    });
    for (const auto& p : end.parameters) out += p.name + "=" + std::to_string(p.value) + "\n";
    for (const base::Diagnostic& d : s.diagnostics.all()) out += std::to_string(d.where.begin) + " " + d.text + "\n";
    return out;
}

/// Compares every case of a folder; the number of those that made something.
int compare(const std::string& folder, std::string_view control, shop::MachineKind kind) {
    const fs::path all = fs::path(OBRYS_SOURCE_DIR) / "tests/golden" / folder;
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(all))
        if (entry.path().extension() == ".txt") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    int compared = 0;
    for (const fs::path& path : paths) {
        const Case c = read_case(path);
        const std::string plain = outcome(c, control, kind, 0);
        if (plain.empty()) continue;
        EXPECT_EQ(plain, outcome(c, control, kind, 7)) << c.name;
        ++compared;
    }
    return compared;
}

TEST(LookAhead, LeavesNoTraceOnHeidenhain) {
    EXPECT_GT(compare("heidenhain", "heidenhain-itnc530", shop::MachineKind::mill), 100);
}

TEST(LookAhead, LeavesNoTraceOnSinumerik) {
    EXPECT_GT(compare("sinumerik", "sinumerik-840d", shop::MachineKind::mill), 100);
    EXPECT_GT(compare("sinumerik", "sinumerik-840d", shop::MachineKind::lathe), 100);
}

TEST(LookAhead, LeavesNoTraceOnFanuc) {
    EXPECT_GT(compare("fanuc", "fanuc", shop::MachineKind::mill), 20);
    EXPECT_GT(compare("fanuc", "fanuc", shop::MachineKind::lathe), 20);
}

TEST(LookAhead, LeavesNoTraceOnLinuxCnc) {
    EXPECT_GT(compare("linuxcnc", "linuxcnc", shop::MachineKind::mill), 20);
    EXPECT_GT(compare("linuxcnc", "linuxcnc", shop::MachineKind::lathe), 20);
}

}  // namespace
}  // namespace obrys::driver
