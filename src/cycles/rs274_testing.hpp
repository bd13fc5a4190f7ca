#pragma once
/// The installed LinuxCNC interpreter as referee: runs a program with `rs274` and gives its canonical calls.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.hpp"

namespace obrys::cycles::test {

/// One canonical call: its name and its numbers; other arguments are left out.
struct Call {
    std::string name;
    std::vector<double> numbers;
};

inline bool has_referee() { return std::ifstream("/usr/bin/rs274").good(); }

inline Call call_of(std::string_view text) {
    const std::size_t open = text.find('(');
    Call c{std::string(text.substr(0, open)), {}};
    std::string rest(text.substr(open + 1));
    for (char& ch : rest)
        if (ch == ',' || ch == ')') ch = ' ';
    std::istringstream in(rest);
    in.imbue(std::locale::classic());
    for (double v = 0; in >> v;) c.numbers.push_back(v);
    return c;
}

/// All lines of `rs274 -g` that are calls; the text of the error, if there is one, as the last call's name.
inline std::vector<Call> referee(const std::string& program, const std::string& name) {
    namespace fs = std::filesystem;
    // It maps its tool table into memory as a file of the home directory: runs that share it end in bus errors.
    static const fs::path home = fs::temp_directory_path() / ("obrys_" + name + std::to_string(std::random_device{}()));
    fs::create_directories(home);
    const std::string base = (home / "program").string();
    std::ofstream(base + ".ngc") << program;
    const int code = std::system(
        ("echo | HOME=" + home.string() + " timeout 1 /usr/bin/rs274 -g " + base + ".ngc > " + base + ".out 2>&1")
            .c_str());
    std::vector<Call> calls;
    if (code >> 8 >= 124) {  // it ran for ever, or died
        fs::remove_all(home);
        return {{"error: exit " + std::to_string(code >> 8), {}}};
    }
    std::ifstream in(base + ".out");
    for (std::string line; std::getline(in, line);) {
        const std::size_t at = line.find("N..... ");
        if (at != std::string::npos)
            calls.push_back(call_of(std::string_view(line).substr(at + 7)));
        else if (line != "executing" && !line.empty())
            calls.push_back({"error: " + line, {}});
    }
    in.close();
    fs::remove_all(home);
    return calls;
}

}  // namespace obrys::cycles::test
