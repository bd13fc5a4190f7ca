#include "shop/section.hpp"

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

std::string quoted(std::string_view key) { return "'" + std::string(key) + "'"; }

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& w : words) out += (out.empty() ? "" : ", ") + w;
    return out;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

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

std::string nearest(std::string_view word, const std::vector<std::string>& words) {
    if (word.size() > 64) return {};
    const std::string wanted = base::to_upper(word);
    std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
    std::string found;
    for (const std::string& w : words) {
        const std::size_t d = edit_distance(wanted, base::to_upper(w));
        if (d < best) {
            best = d;
            found = w;
        }
    }
    return found;
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
    error(base::codes::job_value, head(table_), name_ + " has no " + quoted(key));
}

const Entry* Section::take(std::string_view key) {
    known_.emplace_back(key);
    return find(table_, key);
}

bool Section::expect(const Entry& e, ValueKind kind, std::string_view wanted) const {
    if (e.value.kind == kind) return true;
    error(base::codes::job_value, e.value.where,
          quoted(e.key) + " must be " + std::string(wanted) + ", not " + std::string(kind_name(e.value.kind)));
    return false;
}

std::optional<double> Section::number(std::string_view key, Range range) {
    const Entry* e = take(key);
    return e ? finite_number(e->value, quoted(key), range, diagnostics_) : std::nullopt;
}

std::optional<std::int64_t> Section::integer(std::string_view key, std::int64_t least, std::int64_t most) {
    const Entry* e = take(key);
    if (!e || !expect(*e, ValueKind::integer, "a whole number")) return std::nullopt;
    const std::int64_t v = e->value.integer;
    if (v >= least && v <= most) return v;
    error(base::codes::job_value, e->value.where,
          quoted(key) + " must lie between " + std::to_string(least) + " and " + std::to_string(most) + ", it is " +
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
    error(base::codes::job_value, e->value.where, quoted(key) + " is empty");
    return std::nullopt;
}

std::optional<std::size_t> Section::choice(std::string_view key, std::initializer_list<std::string_view> words) {
    const Entry* e = take(key);
    if (!e || !expect(*e, ValueKind::text, "text")) return std::nullopt;
    const auto at = std::find(words.begin(), words.end(), e->value.text);
    if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
    const std::vector<std::string> list(words.begin(), words.end());
    const std::string near = nearest(e->value.text, list);
    error(base::codes::job_value, e->value.where, quoted(key) + " cannot be \"" + e->value.text + "\"",
          (near.empty() ? "" : "did you mean \"" + near + "\"? ") + ("one of: " + joined(list)));
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
                  "an item of " + quoted(key) + " must be text, not " + std::string(kind_name(v.kind)));
    }
    return out;
}

const Entry* Section::sub_table(std::string_view key) {
    const Entry* e = take(key);
    return e && expect(*e, ValueKind::table, "a table") ? e : nullptr;
}

std::vector<const Value*> Section::tables(std::string_view key) {
    std::vector<const Value*> out;
    const Entry* e = take(key);
    if (!e) return out;
    if (e->value.kind == ValueKind::table) return {&e->value};
    if (!expect(*e, ValueKind::array, "a table")) return out;
    for (const Value& v : e->value.items) out.push_back(&v);
    return out;
}

void Section::finish() {
    for (const Entry& e : table_.entries) {
        if (std::find(known_.begin(), known_.end(), e.key) != known_.end()) continue;
        const std::string near = nearest(e.key, known_);
        error(base::codes::job_file, e.where, "unknown key " + quoted(e.key) + " in " + name_,
              near.empty() ? "known keys: " + joined(known_) : "did you mean " + quoted(near) + "?");
    }
}

bool Section::one_of(std::initializer_list<std::string_view> keys, bool required) {
    const Entry* first = nullptr;
    std::vector<std::string> names(keys.begin(), keys.end());
    for (const std::string_view key : keys) {
        const Entry* e = take(key);
        if (e && first)
            error(base::codes::job_value, e->where, name_ + " has both " + quoted(first->key) + " and " + quoted(key));
        if (e && !first) first = e;
    }
    if (!first && required && table_.kind == ValueKind::table)
        error(base::codes::job_value, head(table_), name_ + " says nothing", "give one of: " + joined(names));
    return first != nullptr;
}

}  // namespace obrys::shop
