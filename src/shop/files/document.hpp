#pragma once
/// A TOML text as plain values, each with its place. The TOML library stays behind it.

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"

namespace obrys::shop {

enum class ValueKind : std::uint8_t { boolean, integer, number, text, date, array, table };

struct Entry;

struct Value {
    ValueKind kind = ValueKind::table;
    base::Span where;
    bool boolean = false;
    std::int64_t integer = 0;
    double number = 0;  ///< also set for an integer
    std::string text;
    std::vector<Value> items;    ///< of an array
    std::vector<Entry> entries;  ///< of a table, in the order of the file
};

struct Entry {
    std::string key;
    base::Span where;  ///< the key itself
    Value value;
};

[[nodiscard]] const Entry* find(const Value& table, std::string_view key);

/// The whole text as a table; an error with its place (code job-file), and nothing, where it is not TOML.
[[nodiscard]] std::optional<Value> parse_toml(std::uint32_t file, const base::Sources& sources,
                                              base::Diagnostics& diagnostics);

}  // namespace obrys::shop
