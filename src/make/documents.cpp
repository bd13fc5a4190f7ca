/// What was made, as text, JSON and tables.

#include <cmath>

#include "base/number.hpp"
#include "make/made.hpp"

namespace obrys::make {

namespace {

/// A JSON object in the making; numbers that are not known are null.
class Object {
public:
    Object& text(std::string_view key, std::string_view value) {
        std::string quoted = "\"";
        for (const char c : value) {
            if (c == '"' || c == '\\') quoted += '\\';
            quoted += c;
        }
        return raw(key, quoted + "\"");
    }
    Object& number(std::string_view key, double value) {
        return raw(key, std::isfinite(value) ? base::shortest(std::round(value * 1e9) / 1e9 + 0.0) : "null");
    }
    Object& count(std::string_view key, std::size_t value) { return raw(key, std::to_string(value)); }
    Object& raw(std::string_view key, std::string_view value) {
        out_ += std::string(out_.empty() ? "" : ", ") + "\"" + std::string(key) + "\": " + std::string(value);
        return *this;
    }
    [[nodiscard]] std::string done() const { return "{" + out_ + "}"; }

private:
    std::string out_;
};

std::string refusal_of(const Made& made) {
    if (!made.refusal) return "null";
    return Object()
        .text("guard", groove::name_of(made.refusal->guard))
        .text("text", made.refusal->text)
        .text("remedy", made.refusal->remedy)
        .done();
}

double figure(const Made& made, double value) { return made.refusal ? std::nan("") : value; }

void add_figures(Object& o, const Made& m) {
    const groove::Doings& d = m.path.does;
    const Proof& p = m.proof;
    if (m.refusal)
        o.raw("plunges", "null");
    else
        o.count("plunges", d.plunges);
    o.number("feed_length_mm", figure(m, d.feed))
        .number("air_length_mm", figure(m, d.air))
        .number("rapid_length_mm", figure(m, d.rapid))
        .number("removed_area_mm2", figure(m, p.removed_area))
        .number("asked_area_mm2", figure(m, p.asked_area))
        .number("gouge_max_mm", figure(m, p.gouge))
        .number("rapid_in_stock_max_mm", figure(m, p.rapid_in_stock))
        .number("rest_max_mm", figure(m, p.rest))
        .number("rest_bound_mm", figure(m, p.rest_bound))
        .number("slot_max_mm", figure(m, d.slot))
        .number("confined_length_mm", figure(m, d.confined))
        .number("open_area_min", figure(m, d.open))
        .number("longest_cut_mm", figure(m, d.longest))
        .number("feed_time_s", figure(m, m.feed_time))
        .number("rapid_time_s", figure(m, m.rapid_time));
}

std::string assumed_of(const Order& order) {
    std::string list;
    for (const std::string& key : order.cutting.assumed) list += (list.empty() ? "\"" : ", \"") + key + "\"";
    return "[" + list + "]";
}

std::string assumed_line(const Order& order) {
    if (order.cutting.assumed.empty()) return {};
    const Cutting& c = order.cutting;
    std::string text = "times with values that the file does not say:";
    for (const std::string& key : c.assumed) {
        const double value = key == "feed"            ? c.feed
                             : key == "cutting_speed" ? c.speed
                             : key == "speed_limit"   ? c.speed_limit
                                                      : c.rapid;
        text += " " + key + " = " + base::shortest(value) + (key == c.assumed.back() ? "\n" : ",");
    }
    return text;
}

/// At least so many columns, with the text at the left.
std::string padded(std::string text, std::size_t width) {
    if (text.size() < width) text.append(width - text.size(), ' ');
    return text;
}
std::string right(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

struct Column {
    const char* head;
    std::string (*value)(const Made&);
};
constexpr Column columns[] = {
    {"plunges", [](const Made& m) { return std::to_string(m.path.does.plunges); }},
    {"feed mm", [](const Made& m) { return base::fixed(m.path.does.feed, 0); }},
    {"air mm", [](const Made& m) { return base::fixed(m.path.does.air, 0); }},
    {"rapid mm", [](const Made& m) { return base::fixed(m.path.does.rapid, 0); }},
    {"feed s", [](const Made& m) { return base::fixed(m.feed_time, 0); }},
    {"rapid s", [](const Made& m) { return base::fixed(m.rapid_time, 0); }},
    {"slot mm", [](const Made& m) { return base::fixed(m.path.does.slot, 2); }},
    {"confined mm", [](const Made& m) { return base::fixed(m.path.does.confined, 0); }},
    {"open", [](const Made& m) { return std::isnan(m.path.does.open) ? "-" : base::fixed(m.path.does.open, 2); }},
    {"longest mm", [](const Made& m) { return base::fixed(m.path.does.longest, 1); }},
    {"rest mm", [](const Made& m) { return base::fixed(m.proof.rest, 3); }},
};

}  // namespace

std::string as_json(const Order& order, const Made& made) {
    Object o;
    o.text("strategy", groove::named(made.strategy).word)
        .text("verdict", verdict_of(made))
        .raw("refused", refusal_of(made));
    add_figures(o, made);
    o.raw("assumed", assumed_of(order));
    return o.done() + "\n";
}

std::string as_text(const Order& order, const Made& made) {
    const std::string title(groove::named(made.strategy).title);
    if (made.refusal)
        return title + ": refused [" + std::string(groove::name_of(made.refusal->guard)) + "]: " + made.refusal->text +
               "\n  " + made.refusal->remedy + "\n";
    const groove::Doings& d = made.path.does;
    const Proof& p = made.proof;
    std::string text = title + ": " + std::string(verdict_of(made)) + "\n";
    text += "  plunges " + std::to_string(d.plunges) + ", feed " + base::fixed(d.feed, 1) +
            " mm, of it without stock " + base::fixed(d.air, 1) + " mm, rapid " + base::fixed(d.rapid, 1) + " mm\n";
    text +=
        "  feed time " + base::fixed(made.feed_time, 1) + " s, rapid time " + base::fixed(made.rapid_time, 1) + " s\n";
    text +=
        "  slot " + base::fixed(d.slot, 3) + " mm deep at most, longest plunge " + base::fixed(d.longest, 3) + " mm\n";
    text += "  removed " + base::fixed(p.removed_area, 3) + " of " + base::fixed(p.asked_area, 3) + " mm2, gouge " +
            base::fixed(p.gouge, 6) + " mm, rapid in stock " + base::fixed(p.rapid_in_stock, 6) + " mm, rest " +
            base::fixed(p.rest, 4) + " mm (at most " + base::fixed(p.rest_bound, 4) + " is meant to stay)\n";
    return text + assumed_line(order);
}

std::string table_as_text(const Order& order, const std::vector<Made>& all) {
    constexpr std::size_t first = 35;
    std::string text = padded("strategy", first);
    for (const Column& c : columns) text += "  " + right(c.head, 8);
    text += "  verdict\n";
    for (const Made& m : all) {
        text += padded(std::string(groove::named(m.strategy).title), first);
        if (m.refusal) {
            text += "  refused [" + std::string(groove::name_of(m.refusal->guard)) + "]: " + m.refusal->text + "\n";
            continue;
        }
        for (const Column& c : columns)
            text += "  " + right(c.value(m), std::max<std::size_t>(8, std::string_view(c.head).size()));
        text += "  " + std::string(verdict_of(m)) + "\n";
    }
    return text + assumed_line(order);
}

std::string table_as_csv(const std::vector<Made>& all) {
    std::string text =
        "strategy,verdict,guard,plunges,feed_length_mm,air_length_mm,rapid_length_mm,feed_time_s,rapid_time_s,"
        "slot_max_mm,confined_length_mm,open_area_min,longest_cut_mm,rest_max_mm,removed_area_mm2\n";
    for (const Made& m : all) {
        text += std::string(groove::named(m.strategy).word) + "," + std::string(verdict_of(m)) + ",";
        if (m.refusal) {
            text += std::string(groove::name_of(m.refusal->guard)) + ",,,,,,,,,,,,\n";
            continue;
        }
        const groove::Doings& d = m.path.does;
        text += "," + std::to_string(d.plunges);
        for (const double value : {d.feed, d.air, d.rapid, m.feed_time, m.rapid_time, d.slot, d.confined, d.open,
                                   d.longest, m.proof.rest, m.proof.removed_area})
            text += "," + (std::isnan(value) ? std::string() : base::fixed(value, 4));
        text += "\n";
    }
    return text;
}

std::string table_as_json(const Order& order, const std::vector<Made>& all) {
    std::string rows;
    for (const Made& m : all) {
        Object o;
        o.text("strategy", groove::named(m.strategy).word).text("verdict", verdict_of(m)).raw("refused", refusal_of(m));
        add_figures(o, m);
        rows += (rows.empty() ? "\n  " : ",\n  ") + o.done();
    }
    return Object().raw("strategies", "[" + rows + "\n]").raw("assumed", assumed_of(order)).done() + "\n";
}

}  // namespace obrys::make
