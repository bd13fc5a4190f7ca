#include "driver/guarded.hpp"

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <new>
#include <system_error>

#include "base/whole.hpp"
#endif

namespace obrys::driver {

#ifdef _WIN32

Guarded guarded(const Guard&, const std::function<void(const Answer&)>&) { return {}; }

#else

namespace {

using Clock = std::chrono::steady_clock;

/// Address space this process has by now, bytes; 0 where the system does not say.
double address_space() {
    std::ifstream statm("/proc/self/statm");
    double pages = 0;
    statm >> pages;
    return statm ? pages * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}

void limit(decltype(RLIMIT_AS) what, double value) {
    rlimit now{};
    if (getrlimit(what, &now) != 0) return;
    if (now.rlim_cur != RLIM_INFINITY && static_cast<double>(now.rlim_cur) <= value) return;
    now.rlim_cur = base::clipped<rlim_t>(value, 0, std::numeric_limits<std::int64_t>::max());
    setrlimit(what, &now);
}

void write_all(int to, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = write(to, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) _exit(1);
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
}

[[noreturn]] void be_the_copy(const Guard& guard, int to, double space, pid_t parent,
                              const std::function<void(const Answer&)>& work) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // it ended in between
#else
    (void)parent;
#endif
    const int null_device = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (null_device >= 0) dup2(null_device, stream);
    for (const int s : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE, SIGINT, SIGTERM}) std::signal(s, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    if (space > 0) limit(RLIMIT_AS, space + guard.memory_bytes);
    try {
        work([to](std::string_view bytes) { write_all(to, bytes); });
    } catch (...) {
        _exit(1);
    }
    _exit(0);  // without the destructors, buffers and handlers that belong to the original
}

int milliseconds_to(Clock::time_point end) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    return left <= 0 ? 0 : left > 1000 ? 1000 : static_cast<int>(left);
}

/// Reads until the other end is closed; the reason why not.
Guarded::End read_answer(const Guard& guard, int from, std::string& answer) {
    const double seconds = guard.seconds < 1e6 ? guard.seconds : 1e6;
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    std::array<char, 1 << 16> buffer{};
    while (Clock::now() < end) {
        pollfd ready{from, POLLIN, 0};
        if (poll(&ready, 1, milliseconds_to(end)) <= 0) continue;
        const ssize_t n = ::read(from, buffer.data(), buffer.size());
        if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (n <= 0) return Guarded::End::done;
        answer.append(buffer.data(), static_cast<std::size_t>(n));
        if (static_cast<double>(answer.size()) > guard.memory_bytes) return Guarded::End::too_much;
    }
    return Guarded::End::late;
}

}  // namespace

Guarded guarded(const Guard& guard, const std::function<void(const Answer&)>& work) {
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    const auto [from, to] = pipe_ends;
    const double space = address_space();
    const pid_t parent = getpid(), child = fork();
    if (child < 0) {
        const int why = errno;
        close(from);
        close(to);
        throw std::system_error(why, std::generic_category(), "a further process could not be started");
    }
    if (child == 0) {
        close(from);
        be_the_copy(guard, to, space, parent, work);
    }
    close(to);
    Guarded out;
    try {
        out.end = read_answer(guard, from, out.answer);
    } catch (const std::bad_alloc&) {
        out.end = Guarded::End::too_much;
    }
    close(from);
    if (out.end != Guarded::End::done) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (out.end != Guarded::End::done || (WIFEXITED(status) && WEXITSTATUS(status) == 0)) return out;
    out.end = Guarded::End::crashed;
    out.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return out;
}

#endif

}  // namespace obrys::driver
