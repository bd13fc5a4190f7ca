#pragma once
/// The binary file as text: one record a line, so that the number of the line is the record's. Each line begins with
/// the byte at which the record begins; then its name and its values by name (dialect/fusion/records.hpp). Single
/// precision numbers stand as the shortest decimals that denote them.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace obrys::read::fusion {

/// Every listing begins so.
inline constexpr std::string_view first_words = "0 compact-nci ";

/// The bytes are of such a file.
[[nodiscard]] bool is_intermediate(std::string_view bytes);
/// The listing; nothing where it would be longer than `most` bytes. A file that ends too early or holds a record of
/// which nothing is known has a last line that says so.
[[nodiscard]] std::optional<std::string> listing_of(std::string_view bytes, std::size_t most);

}  // namespace obrys::read::fusion
