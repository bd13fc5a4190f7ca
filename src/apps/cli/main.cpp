/// obrys, the command line.

#include <cstdio>
#include <exception>

#include "commands.hpp"

int main(int argc, char** argv) {
    try {
        const obrys::cli::Arguments arguments = obrys::cli::parse(argc, argv);
        if (arguments.exit >= 0) return arguments.exit;
        switch (arguments.command) {
            case obrys::cli::Command::check: return obrys::cli::check(arguments);
            case obrys::cli::Command::run: return obrys::cli::run(arguments);
            case obrys::cli::Command::plot: return obrys::cli::plot(arguments);
            case obrys::cli::Command::fmt: return obrys::cli::fmt(arguments);
            case obrys::cli::Command::version: std::puts("obrys " OBRYS_VERSION); return 0;
            case obrys::cli::Command::none: break;
        }
        return 2;
    } catch (const std::exception& e) {  // the world is wrong: memory, disk, encoding of a path
        std::fprintf(stderr, "obrys: %s\n", e.what());
        return 2;
    }
}
