#pragma once
/// Results on their way to a file: whole or not at all, and never over what they were made of.

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "driver/session.hpp"

namespace obrys::driver {

/// A document on its way to a file. A regular file gets it in one piece when it is finished: until then it stands in a
/// neighbour of its own, which goes away where the work ends early (a signal, an exception). Links are followed, not
/// replaced, and hard links stay (their content is then copied in, the one step that a signal can cut); devices and
/// pipes are written to as it comes.
class OutputFile {
public:
    /// An empty path, "-" and /dev/stdout are standard output.
    explicit OutputFile(const fs::path& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] bool good() const { return error_ == 0; }
    void write(std::string_view text);
    /// All of it has left this program, in its place or in that of its neighbour. False where that fails.
    bool flush();
    /// Puts the document in its place. False where not all of it could be written.
    bool finish();
    /// Why it could not be written, in the words of the system.
    [[nodiscard]] std::string error() const;

private:
    void fail();
    void discard();

    std::FILE* file_ = nullptr;
    fs::path target_, part_;  ///< part_: the neighbour; empty where there is none
    int slot_ = -1;
    int error_ = 0;
};

/// Ctrl-C and its like take the unfinished neighbours away before they end the program. To be called once.
void clean_up_on_signals();

[[nodiscard]] bool is_standard_output(std::string_view path);

/// One file by two names, or what would be one if it were there.
[[nodiscard]] bool is_same_file(const fs::path& a, const fs::path& b);

/// A file that was asked for.
struct Wanted {
    std::string option;  ///< "--html"
    std::string path;
};

/// Every file that the session has read by now, or will.
[[nodiscard]] std::vector<fs::path> inputs_of(const Session& session);

/// Why the files may not be written, one line each: one is an input or the same as another one, it exists (unless
/// `force`), it is a folder, there is no folder for it. Empty: they may.
[[nodiscard]] std::vector<std::string> refusals(const std::vector<Wanted>& wanted, const std::vector<fs::path>& inputs,
                                                bool force);

}  // namespace obrys::driver
