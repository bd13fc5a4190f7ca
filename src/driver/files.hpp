#pragma once
/// Files in and out. What is read comes from a Storage, what is written goes to the disk.

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "driver/storage.hpp"

namespace obrys::driver {

/// A place that is no place: complaints about the command line.
inline constexpr base::Span nowhere{0xFFFFFFFF, 0, 0};

/// Adds an error.
void complain(base::Diagnostics& diagnostics, std::string_view code, const base::Span& where, std::string text,
              std::string remedy = {});

/// Of a transfer, in front of a program and behind it (Ctrl-Z, NUL, ETX …): `keep` for who writes the text again,
/// `refuse` for a text that no transfer brings.
enum class Signs : std::uint8_t { blank, keep, refuse };

/// Adds the file's text to `sources`. A missing, empty, binary or too large file is a complaint at `where`, naming the
/// nearest file names of the folder, and nothing is returned.
std::optional<std::uint32_t> load(const Storage& from, const fs::path& path, base::Sources& sources,
                                  base::Diagnostics& diagnostics, const base::Span& where = nowhere,
                                  Signs signs = Signs::blank);

/// Complains at `where` about a file that is not there, no file or empty.
void check_readable(const Storage& from, const fs::path& path, base::Diagnostics& diagnostics, const base::Span& where);

/// The bytes of a file that is no text (STL); nothing after a complaint at `where`.
std::optional<std::string> load_bytes(const Storage& from, const fs::path& path, base::Diagnostics& diagnostics,
                                      const base::Span& where = nowhere);

/// A path as a job file writes it: relative to the folder of the job.
[[nodiscard]] fs::path beside(const fs::path& job, const std::string& written);

/// Writes a whole file or nothing, also over one that is there. False (and a complaint) where that fails.
bool store(const fs::path& path, std::string_view content, base::Diagnostics& diagnostics);

/// Up to three names of `folder` that look like `name`.
[[nodiscard]] std::string similar_names(const Storage& from, const fs::path& folder, std::string_view name);

}  // namespace obrys::driver
