/// [variables] of a job file.

#include "base/codes.hpp"
#include "shop/files/obrys/job_tables.hpp"

namespace obrys::shop {

namespace {

constexpr std::size_t most_dimensions = 3;

/// One value, or an array of them with its indices: MY_I = [4, 5] is MY_I[0] and MY_I[1].
void take(Section& file, const std::string& name, const std::string& indices, std::size_t depth, const Value& v,
          GivenValues& out) {
    if (v.kind == ValueKind::array) {
        if (depth == most_dimensions || name.ends_with(']'))
            return file.error(base::codes::job_value, v.where,
                              depth == most_dimensions ? "an array has at most three dimensions"
                                                       : "'" + name + "' is one element and cannot hold an array",
                              depth == most_dimensions ? "" : "give the array to the name without its index");
        for (std::size_t k = 0; k < v.items.size(); ++k)
            take(file, name, indices + (depth > 0 ? "," : "") + std::to_string(k), depth + 1, v.items[k], out);
        return;
    }
    GivenValue given{GivenKind::number, 0, v.text, v.where};
    if (v.kind == ValueKind::text)
        given.kind = GivenKind::text;
    else if (v.kind == ValueKind::boolean)
        given = {GivenKind::truth, v.boolean ? 1.0 : 0.0, {}, v.where};
    else if (const auto number = finite_number(v, "'" + name + "'", Range::value, file.diagnostics()))
        given.number = *number;
    else
        return;
    const std::string key = depth > 0 ? name + "[" + indices + "]" : name;
    if (!out.emplace(key, std::move(given)).second)
        file.error(base::codes::job_value, v.where,
                   "'" + key + "' is given twice (capitals and small letters are the same)");
}

}  // namespace

GivenValues read_variables(Section& file) {
    GivenValues values;
    if (const Entry* table = file.sub_table("variables"))
        for (const Entry& e : table->value.entries) take(file, given_key(e.key), {}, 0, e.value, values);
    return values;
}

}  // namespace obrys::shop
