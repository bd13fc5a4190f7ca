#include "driver/documents/format_file.hpp"

#include "base/codes.hpp"

namespace obrys::driver {

namespace fmt = format::heidenhain;

std::optional<FormattedFile> format_file(const fs::path& path, const fmt::Options& options, base::Sources& sources,
                                         base::Diagnostics& diagnostics) {
    const auto file = load(*disk(), path, sources, diagnostics, nowhere, Signs::keep);
    if (!file) return std::nullopt;
    const std::string_view text = sources[*file].text;
    const auto language = fmt::language_of(text, path.filename().string());
    if (!language) {
        diagnostics.add({base::Severity::error,
                         base::codes::file_missing,
                         nowhere,
                         path.generic_string() + " holds no HEIDENHAIN program",
                         "Klartext begins with BEGIN PGM, DIN/ISO with %NAME G71 *",
                         {},
                         {}});
        return std::nullopt;
    }
    fmt::Formatted formatted = fmt::formatted(text, *language, options);
    FormattedFile out;
    out.changed = formatted.text != text;
    // A source has no byte order mark any more; the file keeps it.
    std::error_code error;
    if (fs::file_size(path, error) == text.size() + 3 && !error) out.text = "\xEF\xBB\xBF";
    out.text += formatted.text;
    out.left = std::move(formatted.left);
    out.numbers_kept = formatted.numbers_kept;
    return out;
}

}  // namespace obrys::driver
