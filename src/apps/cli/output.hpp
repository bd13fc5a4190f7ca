#pragma once
/// Long documents into a file or to standard output, piece by piece, so that they never lie in memory as a whole.

#include <cstdio>
#include <string>
#include <string_view>

namespace obrys::cli {

class Output {
public:
    /// Standard output where the path is empty or "-".
    explicit Output(const std::string& path)
        : file_(path.empty() || path == "-" ? stdout : std::fopen(path.c_str(), "wb")) {}
    ~Output() {
        if (file_ != nullptr && file_ != stdout) std::fclose(file_);
    }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    [[nodiscard]] bool good() const { return file_ != nullptr; }
    void write(std::string_view text) { std::fwrite(text.data(), 1, text.size(), file_); }
    /// Whether all of it has been written.
    [[nodiscard]] bool finish() { return std::fflush(file_) == 0 && std::ferror(file_) == 0; }

private:
    std::FILE* file_;
};

}  // namespace obrys::cli
