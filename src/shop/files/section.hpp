#pragma once
/// One table of a job, machine or tool file while it is read: typed values, complaints with their place, and
/// at the end every key that nobody asked for.

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shop/files/document.hpp"
#include "shop/nearest.hpp"

namespace obrys::shop {

/// Values a number may have. All but `value` are sizes of a shop (mm, mm/min, 1/min, s, kW): at most 1e6, a kilometre;
/// what is `positive` is no smaller than a nanometre. `value` is what a variable of a control may hold.
enum class Range : std::uint8_t { any, positive, not_negative, value };

class Section {
public:
    /// `name` is how messages call the table: "[stock]", "the file". A value that is no table is reported here.
    Section(const Value& table, std::string name, base::Diagnostics& diagnostics);

    [[nodiscard]] bool has(std::string_view key) const { return find(table_, key) != nullptr; }
    [[nodiscard]] const Value& table() const { return table_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] base::Diagnostics& diagnostics() const { return diagnostics_; }

    /// The entry of any type, now counted as known; null where there is none.
    const Entry* take(std::string_view key);
    /// Typed values; nothing where the key is missing or its value was reported.
    std::optional<double> number(std::string_view key, Range range = Range::any);
    std::optional<std::int64_t> integer(std::string_view key, std::int64_t least, std::int64_t most);
    std::optional<bool> boolean(std::string_view key);
    std::optional<std::string> text(std::string_view key);
    /// Position of the text value in `words`.
    std::optional<std::size_t> choice(std::string_view key, std::initializer_list<std::string_view> words);
    std::vector<std::string> texts(std::string_view key);         ///< one text or an array of texts
    std::vector<const Value*> text_values(std::string_view key);  ///< the same with their places
    const Entry* sub_table(std::string_view key);
    /// The tables of `[[key]]`; a single `[key]` counts as one.
    std::vector<const Value*> tables(std::string_view key);

    /// Reports keys that nobody took.
    void finish();
    /// The same of a whole file, then hands on all complaints in the order of their places; a key of the file that was
    /// written behind the first table is said to be one.
    void finish_file(base::Diagnostics& to);

    void error(std::string_view code, base::Span where, std::string text, std::string remedy = {}) const;
    /// Reports a missing key at the table's own place.
    void missing(std::string_view key) const;
    /// Keys of which exactly one (or at most one) may be there; reports otherwise. True where one is.
    bool one_of(std::initializer_list<std::string_view> keys, bool required);

private:
    bool expect(const Entry& e, ValueKind kind, std::string_view wanted) const;
    const Entry* know(std::string_view key, bool is_table);
    [[nodiscard]] std::vector<std::string> known_keys() const;
    [[nodiscard]] std::string nearest_key(const Entry& e) const;

    const Value& table_;
    std::string name_;
    base::Diagnostics& diagnostics_;
    std::vector<std::string> known_, known_tables_;  ///< each key once; those of tables apart
};

[[nodiscard]] std::string_view kind_name(ValueKind kind);
/// The place of a table in messages: its header or brace, not its whole text.
[[nodiscard]] base::Span head(const Value& table);
/// The place of a key's value; where it is missing, of the table.
[[nodiscard]] base::Span place(const Section& s, std::string_view key);
/// Adds complaints in the order of their places, whatever order the reader met them in.
void add_in_order(const base::Diagnostics& from, base::Diagnostics& to);
/// A finite number, or a complaint about `what`.
[[nodiscard]] std::optional<double> finite_number(const Value& v, const std::string& what, Range range,
                                                  base::Diagnostics& diagnostics);

}  // namespace obrys::shop
