#pragma once
/// The text of a large file: a private copy in memory of its own, whose pieces go back to the system once they are read
/// and come from the file again when a message shows a line of them. The copy, not a mapping of the file: a mapped file
/// that another program cuts short kills its reader, and one that is changed in place changes under it (ADR 11).

#include <cstdint>
#include <memory>
#include <string>

#include "base/source.hpp"

namespace obrys::driver {

inline constexpr std::uintmax_t large_text = 2 * base::Store::piece;  ///< bytes from which a text is kept like this

/// Reads the whole file, of about `size` bytes; null where that fails, and where the system offers no such memory. What
/// is fetched again later is held against a sum of what was read: a difference throws std::runtime_error that names
/// `shown`.
[[nodiscard]] std::unique_ptr<base::Store> read_large_text(const std::string& path, const std::string& shown,
                                                           std::uintmax_t size);

}  // namespace obrys::driver
