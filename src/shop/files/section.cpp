#include "shop/files/section.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "shop/size_range.hpp"

namespace obrys::shop {

namespace {

constexpr double largest_value = 1e12;  ///< squares of it stay exact enough

void complain(base::Diagnostics& diagnostics, std::string_view code, base::Span where, std::string text,
              std::string remedy = {}) {
    base::Diagnostic d;
    d.code = code;
    d.where = where;
    d.text = std::move(text);
    d.remedy = std::move(remedy);
    diagnostics.add(std::move(d));
}

std::string in_quotes(std::string_view key) { return "'" + std::string(key) + "'"; }

}  // namespace

std::string_view kind_name(ValueKind kind) {
    switch (kind) {
        case ValueKind::boolean: return "true or false";
        case ValueKind::integer: return "a whole number";
        case ValueKind::number: return "a number";
        case ValueKind::text: return "text";
        case ValueKind::date: return "a date";
        case ValueKind::array: return "an array";
        case ValueKind::table: return "a table";
    }
    return "something else";
}

base::Span head(const Value& table) {
    return {table.where.file, table.where.begin, std::min(table.where.end, table.where.begin + 1)};
}

void add_in_order(const base::Diagnostics& from, base::Diagnostics& to) {
    std::vector<base::Diagnostic> all = from.all();
    std::stable_sort(all.begin(), all.end(), [](const base::Diagnostic& a, const base::Diagnostic& b) {
        return a.where.begin < b.where.begin;
    });
    for (base::Diagnostic& d : all) to.add(std::move(d));
}

std::optional<double> finite_number(const Value& v, const std::string& what, Range range,
                                    base::Diagnostics& diagnostics) {
    if (v.kind != ValueKind::number && v.kind != ValueKind::integer) {
        complain(diagnostics, base::codes::job_value, v.where,
                 what + " must be a number, not " + std::string(kind_name(v.kind)));
        return std::nullopt;
    }
    if (!std::isfinite(v.number)) {
        complain(diagnostics, base::codes::job_value, v.where, what + " must be a finite number");
        return std::nullopt;
    }
    const double largest = range == Range::value ? largest_value : largest_size;
    if (std::abs(v.number) > largest) {
        complain(diagnostics, base::codes::job_value, v.where,
                 what + " is too large: at most " + base::shortest(largest));
        return std::nullopt;
    }
    if (range == Range::positive && v.number <= 0) {
        complain(diagnostics, base::codes::job_value, v.where,
                 what + " must be greater than 0, not " + base::shortest(v.number));
        return std::nullopt;
    }
    if (range == Range::positive && v.number < smallest_size) {
        complain(diagnostics, base::codes::job_value, v.where,
                 what + " is too small: at least " + base::fixed(smallest_size, 6));
        return std::nullopt;
    }
    if (range == Range::not_negative && v.number < 0) {
        complain(diagnostics, base::codes::job_value, v.where,
                 what + " must not be negative, it is " + base::shortest(v.number));
        return std::nullopt;
    }
    return v.number;
}

Section::Section(const Value& table, std::string name, base::Diagnostics& diagnostics)
    : table_(table), name_(std::move(name)), diagnostics_(diagnostics) {
    if (table.kind != ValueKind::table)
        error(base::codes::job_value, table.where,
              name_ + " must be a table, not " + std::string(kind_name(table.kind)));
}

void Section::error(std::string_view code, base::Span where, std::string text, std::string remedy) const {
    complain(diagnostics_, code, where, std::move(text), std::move(remedy));
}

void Section::missing(std::string_view key) const {
    if (table_.kind != ValueKind::table) return;  // already reported
    error(base::codes::job_value, head(table_), name_ + " has no " + in_quotes(key));
}

const Entry* Section::take(std::string_view key) { return know(key, false); }

const Entry* Section::know(std::string_view key, bool is_table) {
    auto& known = is_table ? known_tables_ : known_;
    auto& other = is_table ? known_ : known_tables_;
    if (is_table) std::erase(other, key);  // what asked for any value before knows better now
    const auto has = [&](const std::vector<std::string>& keys) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    if (!has(known) && !has(other)) known.emplace_back(key);
    return find(table_, key);
}

bool Section::expect(const Entry& e, ValueKind kind, std::string_view wanted) const {
    if (e.value.kind == kind) return true;
    error(base::codes::job_value, e.value.where,
          in_quotes(e.key) + " must be " + std::string(wanted) + ", not " + std::string(kind_name(e.value.kind)));
    return false;
}

std::optional<double> Section::number(std::string_view key, Range range) {
    const Entry* e = take(key);
    return e ? finite_number(e->value, in_quotes(key), range, diagnostics_) : std::nullopt;
}

std::optional<std::int64_t> Section::integer(std::string_view key, std::int64_t least, std::int64_t most) {
    const Entry* e = take(key);
    if (!e || !expect(*e, ValueKind::integer, "a whole number")) return std::nullopt;
    const std::int64_t v = e->value.integer;
    if (v >= least && v <= most) return v;
    error(base::codes::job_value, e->value.where,
          in_quotes(key) + " must lie between " + std::to_string(least) + " and " + std::to_string(most) + ", it is " +
              std::to_string(v));
    return std::nullopt;
}

std::optional<bool> Section::boolean(std::string_view key) {
    const Entry* e = take(key);
    if (!e || !expect(*e, ValueKind::boolean, "true or false")) return std::nullopt;
    return e->value.boolean;
}

std::optional<std::string> Section::text(std::string_view key) {
    const Entry* e = take(key);
    if (!e || !expect(*e, ValueKind::text, "text")) return std::nullopt;
    if (!e->value.text.empty()) return e->value.text;
    error(base::codes::job_value, e->value.where, in_quotes(key) + " is empty");
    return std::nullopt;
}

std::optional<std::size_t> Section::choice(std::string_view key, std::initializer_list<std::string_view> words) {
    const Entry* e = take(key);
    if (!e || !expect(*e, ValueKind::text, "text")) return std::nullopt;
    const auto at = std::find(words.begin(), words.end(), e->value.text);
    if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
    const std::vector<std::string> list(words.begin(), words.end());
    error(base::codes::job_value, e->value.where, in_quotes(key) + " cannot be \"" + e->value.text + "\"",
          words_remedy(e->value.text, list));
    return std::nullopt;
}

std::vector<std::string> Section::texts(std::string_view key) {
    std::vector<std::string> out;
    for (const Value* v : text_values(key)) out.push_back(v->text);
    return out;
}

std::vector<const Value*> Section::text_values(std::string_view key) {
    std::vector<const Value*> out;
    const Entry* e = take(key);
    if (!e) return out;
    if (e->value.kind == ValueKind::text) return {&e->value};
    if (!expect(*e, ValueKind::array, "text or an array of texts")) return out;
    for (const Value& v : e->value.items) {
        if (v.kind == ValueKind::text)
            out.push_back(&v);
        else
            error(base::codes::job_value, v.where,
                  "an item of " + in_quotes(key) + " must be text, not " + std::string(kind_name(v.kind)));
    }
    return out;
}

const Entry* Section::sub_table(std::string_view key) {
    const Entry* e = know(key, true);
    return e && expect(*e, ValueKind::table, "a table") ? e : nullptr;
}

std::vector<const Value*> Section::tables(std::string_view key) {
    std::vector<const Value*> out;
    const Entry* e = know(key, true);
    if (!e) return out;
    if (e->value.kind == ValueKind::table) return {&e->value};
    if (!expect(*e, ValueKind::array, "a table")) return out;
    for (const Value& v : e->value.items) out.push_back(&v);
    return out;
}

std::vector<std::string> Section::known_keys() const {
    std::vector<std::string> all = known_;
    all.insert(all.end(), known_tables_.begin(), known_tables_.end());
    return all;
}

/// A key of the same form as the one that is wrong, a value or a table, before any other.
std::string Section::nearest_key(const Entry& e) const {
    const bool table =
        e.value.kind == ValueKind::table ||
        (e.value.kind == ValueKind::array && !e.value.items.empty() && e.value.items.front().kind == ValueKind::table);
    const std::string near = nearest(e.key, table ? known_tables_ : known_);
    return near.empty() ? nearest(e.key, known_keys()) : near;
}

void Section::finish() {
    const std::vector<std::string> all = known_keys();
    for (const Entry& e : table_.entries) {
        if (std::find(all.begin(), all.end(), e.key) != all.end()) continue;
        const std::string near = nearest_key(e);
        error(base::codes::job_file, e.where, "unknown key " + in_quotes(e.key) + " in " + name_,
              near.empty() ? "known keys: " + joined(all) : "did you mean " + in_quotes(near) + "?");
    }
}

namespace {

/// The key of this place in the tables of the file; null where there is none.
const Entry* entry_at(const Value& table, base::Span where) {
    for (const Entry& e : table.entries) {
        if (e.where == where) return &e;
        if (const Entry* inner = entry_at(e.value, where)) return inner;
    }
    for (const Value& item : table.items)
        if (const Entry* inner = entry_at(item, where)) return inner;
    return nullptr;
}

}  // namespace

void Section::finish_file(base::Diagnostics& to) {
    finish();
    base::Diagnostics all;
    for (base::Diagnostic d : diagnostics_.all()) {
        const Entry* e = d.code == base::codes::job_file ? entry_at(table_, d.where) : nullptr;
        const bool of_file = e != nullptr && find(table_, e->key) == nullptr &&
                             std::find(known_.begin(), known_.end(), e->key) != known_.end();
        if (of_file) d.remedy = in_quotes(e->key) + " is a key of the whole file: it belongs above the first [table]";
        all.add(std::move(d));
    }
    add_in_order(all, to);
}

bool Section::one_of(std::initializer_list<std::string_view> keys, bool required) {
    const Entry* first = nullptr;
    std::vector<std::string> names(keys.begin(), keys.end());
    for (const std::string_view key : keys) {
        const Entry* e = take(key);
        if (e && first)
            error(base::codes::job_value, e->where,
                  name_ + " has both " + in_quotes(first->key) + " and " + in_quotes(key));
        if (e && !first) first = e;
    }
    if (!first && required && table_.kind == ValueKind::table)
        error(base::codes::job_value, head(table_), name_ + " says nothing", "give one of: " + joined(names));
    return first != nullptr;
}

base::Span place(const Section& s, std::string_view key) {
    const Entry* e = find(s.table(), key);
    return e ? e->value.where : head(s.table());
}

}  // namespace obrys::shop
