// Any bytes are taken as the files of a job, one behind the other, each behind a line `--- file name`: job, machine,
// tools, tables. Two short programs are checked with them, the one that the job names.
#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include "run_case.hpp"

using namespace obrys;

namespace {

constexpr std::array<std::string_view, 7> names{"case.job.toml", "machine.toml", "tools.toml", "tools.toa",
                                                "tool.t",        "tool.tbl",     "tools.json"};

constexpr std::string_view
    mill =
        "T1 D1 M6\nG17 G54 G90 G0 X-20 Y10 Z5 S1000 M3\nZ-3\nG1 X50 F100\nT2 D1 M6\nG0 X10 Y10 Z5 "
        "M3\nG1 Z-5 F100\nG0 Z50\nM30\n",
    turn =
        "T1 D1\nG18 G0 X60 Z5 S1000 M3\nX30\nG1 Z-10 F0.1\nX60\nT2 D1\nG0 Z-5\nG1 X20 F0.1\nG0 "
        "X60\nM30\n";

/// The job's own text; the other files lie in the folder.
std::string unpack(const std::string& text) {
    std::map<std::string_view, std::string> files;
    std::string_view at = names[0];
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const auto* named = std::find_if(names.begin(), names.end(),
                                         [&](std::string_view n) { return line == "--- " + std::string(n); });
        if (named != names.end())
            at = *named;
        else
            files[at] += line + "\n";
    }
    for (const std::string_view name : names)
        if (name != names[0]) fuzz::folder().put(name, files[name]);
    return files[names[0]];
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    fuzz::folder().put("MILL.MPF", mill);
    fuzz::check_case("TURN.MPF", turn, unpack(text));
    return 0;
}
