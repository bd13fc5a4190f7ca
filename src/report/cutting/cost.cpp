#include "report/cutting/cost.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number.hpp"
#include "report/cutting/rows.hpp"

namespace obrys::report::cutting {

using OrderedJson = nlohmann::ordered_json;

namespace {

constexpr std::size_t name_width = 18, columns = 18;
constexpr int cents = 2;

std::string money(const std::optional<double>& v) { return v ? base::fixed(*v, cents) : "?"; }

std::optional<double> item(const CostColumn& c, const std::string& name) {
    if (!c.cost) return std::nullopt;
    for (const sim::cost::Item& i : c.cost->items)
        if (i.name == name) return i.money;
    return 0;
}

std::vector<std::string> item_names(const std::vector<CostColumn>& all) {
    std::vector<std::string> found;
    for (const CostColumn& c : all) {
        if (!c.cost) continue;
        for (const sim::cost::Item& i : c.cost->items)
            if (std::find(found.begin(), found.end(), i.name) == found.end()) found.push_back(i.name);
    }
    return found;
}

template <typename Text>
void put_row(std::string& out, const std::vector<CostColumn>& all, const std::string& name, Text text) {
    out += padded(name, name_width);
    for (const CostColumn& c : all) out += " " + padded(text(c), columns, true);
    out.erase(out.find_last_not_of(' ') + 1);
    out += "\n";
}

std::string title(const CostColumn& c, std::size_t at, std::size_t count) {
    if (!c.variant.name.empty()) return c.variant.name;
    return count == 1 ? "" : "variant " + std::to_string(at + 1);
}

std::vector<std::string> gaps(const CostColumn& c) {
    std::vector<std::string> all = c.not_whole;
    if (!c.cost) return all;
    for (const std::string& tool : c.cost->tools_left_out)
        all.push_back("how long tool '" + tool + "' cuts in a piece is not known: its wear is left out");
    return all;
}

}  // namespace

std::string as_text(const std::vector<CostColumn>& all) {
    std::string out;
    const std::string currency = all.front().variant.table.currency;
    const bool titles = all.size() > 1 || !all.front().variant.name.empty();
    std::size_t at = 0;
    if (titles) put_row(out, all, currency, [&](const CostColumn& c) { return title(c, at++, all.size()); });
    put_row(out, all, "time of a piece",
            [](const CostColumn& c) { return c.seconds ? base::fixed(*c.seconds, 1) + " s" : std::string("?"); });
    const auto estimated = [](const CostColumn& c) { return c.seconds && c.time_from != "given"; };
    if (std::any_of(all.begin(), all.end(), estimated))
        put_row(out, all, "  estimated of", [&](const CostColumn& c) { return estimated(c) ? c.time_from : ""; });
    for (const std::string& name : item_names(all))
        put_row(out, all, "  " + name, [&](const CostColumn& c) { return money(item(c, name)); });
    const auto total = [&](const char* name, auto value) {
        const auto some = [&](const CostColumn& c) { return c.cost && value(*c.cost).has_value(); };
        if (std::any_of(all.begin(), all.end(), some))
            put_row(out, all, name, [&](const CostColumn& c) { return c.cost ? money(value(*c.cost)) : "?"; });
    };
    total("a piece", [](const sim::cost::Cost& c) { return std::optional<double>(c.per_piece); });
    total("a batch", [](const sim::cost::Cost& c) { return c.per_batch; });
    total("a year", [](const sim::cost::Cost& c) { return c.per_year; });
    if (all.size() > 1)
        put_row(out, all, "against the first", [&](const CostColumn& c) {
            if (!c.cost || !all.front().cost) return std::string("?");
            const double more = c.cost->per_piece - all.front().cost->per_piece;
            return (more > 0 ? "+" : "") + base::fixed(100 * more / all.front().cost->per_piece, 1) + " %";
        });
    if (!titles && !currency.empty()) out += "in " + currency + "\n";
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const std::string& gap : gaps(all[i])) {
            const std::string name = title(all[i], i, all.size());
            out += "not fully costed: " + (name.empty() ? "" : name + ": ") + gap + "\n";
        }
    return out;
}

namespace {

OrderedJson column_json(const CostColumn& c) {
    const auto optional = [](const std::optional<double>& v) { return v ? OrderedJson(*v) : OrderedJson(nullptr); };
    OrderedJson out;
    out["name"] = c.variant.name;
    out["time_s"] = optional(c.seconds);
    out["time_from"] = c.time_from;
    out["complete"] = c.is_whole();
    out["not_whole"] = gaps(c);
    out["per_piece"] = c.cost ? OrderedJson(c.cost->per_piece) : OrderedJson(nullptr);
    out["per_piece_exact"] = c.cost ? OrderedJson(c.cost->exact) : OrderedJson(nullptr);
    out["per_batch"] = c.cost ? optional(c.cost->per_batch) : OrderedJson(nullptr);
    out["per_year"] = c.cost ? optional(c.cost->per_year) : OrderedJson(nullptr);
    out["items"] = OrderedJson::object();
    if (c.cost)
        for (const sim::cost::Item& i : c.cost->items) out["items"][i.name] = i.money;
    return out;
}

}  // namespace

std::string as_json(const std::vector<CostColumn>& all) {
    OrderedJson out{{"format", "obrys-cost"}, {"version", 1}};
    const std::string& currency = all.front().variant.table.currency;
    out["currency"] = currency.empty() ? OrderedJson(nullptr) : OrderedJson(currency);
    const OrderedJson first = column_json(all.front());
    for (const auto& [key, value] : first.items()) out[key] = value;
    out["variants"] = OrderedJson::array();
    for (const CostColumn& c : all) out["variants"].push_back(column_json(c));
    return out.dump(2) + "\n";
}

}  // namespace obrys::report::cutting
