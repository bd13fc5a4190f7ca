#pragma once
/// A program file, formatted (obrys fmt).

#include <optional>
#include <string>
#include <vector>

#include "driver/files.hpp"
#include "format/heidenhain/format.hpp"

namespace obrys::driver {

struct FormattedFile {
    std::string text;
    bool changed = false;  ///< the text differs from the file
    std::vector<format::heidenhain::Left> left;
    bool numbers_kept = false;
};

/// Nothing where the file cannot be read or holds no HEIDENHAIN program; a complaint is made.
[[nodiscard]] std::optional<FormattedFile> format_file(const fs::path& path, const format::heidenhain::Options& options,
                                                       base::Sources& sources, base::Diagnostics& diagnostics);

}  // namespace obrys::driver
