/// obrys, the command line.

#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>

#include "commands.hpp"
#include "driver/output_file.hpp"

namespace {

int command(int argc, char** argv) {
    const obrys::cli::Arguments arguments = obrys::cli::parse(argc, argv);
    if (arguments.exit >= 0) return arguments.exit;
    switch (arguments.command) {
        case obrys::cli::Command::check: return obrys::cli::check(arguments);
        case obrys::cli::Command::run: return obrys::cli::run(arguments);
        case obrys::cli::Command::plot: return obrys::cli::plot(arguments);
        case obrys::cli::Command::fmt: return obrys::cli::fmt(arguments);
        case obrys::cli::Command::translate: return obrys::cli::translate(arguments);
        case obrys::cli::Command::compare: return obrys::cli::compare(arguments);
        case obrys::cli::Command::post: return obrys::cli::post(arguments);
        case obrys::cli::Command::sheet: return obrys::cli::sheet(arguments);
        case obrys::cli::Command::time: return obrys::cli::time(arguments);
        case obrys::cli::Command::calibrate: return obrys::cli::calibrate(arguments);
        case obrys::cli::Command::version: std::puts("obrys " OBRYS_VERSION); return 0;
        case obrys::cli::Command::none: break;
    }
    return 2;
}

/// Whoever reads standard output must not take a part of it for the whole.
int with_output_written(int code) {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    if (code != 2) {
        const std::string why = std::generic_category().message(errno != 0 ? errno : EIO);
        std::fprintf(stderr, "obrys: standard output cannot be written: %s\n", why.c_str());
    }
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        // Help and verdicts go out in one piece at the end, where a full disk still says what it is.
        static char buffer[1 << 16];
        std::setvbuf(stdout, buffer, _IOFBF, sizeof buffer);
        obrys::driver::clean_up_on_signals();
        return with_output_written(command(argc, argv));
    } catch (const std::exception& e) {  // the world is wrong: memory, disk, encoding of a path
        std::fprintf(stderr, "obrys: %s\n", e.what());
        return 2;
    }
}
