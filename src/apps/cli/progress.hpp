#pragma once
/// A line on the terminal that says how far the work is; none where standard error is no terminal.

#include <chrono>
#include <cstdint>

namespace obrys::cli {

class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Shows the number of moves after the first second, ten times a second at most.
    void show(std::uint64_t moves);

private:
    bool terminal_, shown_ = false;
    std::chrono::steady_clock::time_point started_, last_;
};

}  // namespace obrys::cli
