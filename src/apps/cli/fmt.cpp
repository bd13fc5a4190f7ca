/// obrys fmt.

#include <cstdio>

#include "base/text.hpp"
#include "commands.hpp"
#include "driver/documents/format_file.hpp"

namespace obrys::cli {

namespace {

constexpr std::size_t most_notes = 20;  ///< a file; the rest is counted

void print_notes(const std::string& path, const driver::FormattedFile& file) {
    for (std::size_t i = 0; i < file.left.size() && i < most_notes; ++i) {
        const std::string text = base::as_utf8(base::trim(file.left[i].text));
        std::fprintf(stderr, "%s:%u: note: not understood, left as it is: %s\n", path.c_str(), file.left[i].line,
                     text.c_str());
    }
    if (file.numbers_kept)
        std::fprintf(stderr, "%s: note: free contours refer to block numbers: they stay as they are\n", path.c_str());
    if (file.left.size() > most_notes)
        std::fprintf(stderr, "%s: note: %zu further blocks not understood, left as they are\n", path.c_str(),
                     file.left.size() - most_notes);
}

}  // namespace

int fmt(const Arguments& a) {
    base::Sources sources;
    bool failed = false, changed = false;
    for (const std::string& path : a.files) {
        base::Diagnostics diagnostics;
        const auto file = driver::format_file(path, a.style, sources, diagnostics);
        if (file) {
            print_notes(path, *file);
            changed = changed || file->changed;
            if (a.only_check) {
                if (file->changed) std::printf("%s\n", path.c_str());
            } else if (!a.in_place) {
                std::fwrite(file->text.data(), 1, file->text.size(), stdout);
            } else if (file->changed) {
                failed = !driver::store(path, file->text, diagnostics) || failed;
            }
        }
        failed = failed || !file;
        for (const base::Diagnostic& d : diagnostics.all()) std::fputs(base::render(d, sources).c_str(), stderr);
    }
    return failed ? 2 : a.only_check && changed ? 1 : 0;
}

}  // namespace obrys::cli
