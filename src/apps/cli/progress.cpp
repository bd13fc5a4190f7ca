#include "progress.hpp"

#include <cstdio>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace obrys::cli {

namespace {

bool is_terminal() {
#ifdef _WIN32
    return _isatty(2) != 0;
#else
    return isatty(2) != 0;
#endif
}

}  // namespace

Progress::Progress() : terminal_(is_terminal()), started_(std::chrono::steady_clock::now()), last_(started_) {}

Progress::~Progress() {
    if (shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::uint64_t moves) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - started_ < std::chrono::seconds(1) || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    shown_ = true;
    const double seconds = std::chrono::duration<double>(now - started_).count();
    std::fprintf(stderr, "\r%llu moves checked, %.0f s\x1b[K", static_cast<unsigned long long>(moves), seconds);
    std::fflush(stderr);
}

}  // namespace obrys::cli
