#include "shop/files/obrys/tables.hpp"

#include <algorithm>
#include <array>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "shop/files/obrys/holder.hpp"
#include "shop/files/obrys/milling_keys.hpp"

namespace obrys::shop {

namespace {

constexpr std::array groove_keys{"width",     "corner_radius", "corner_radius_left", "corner_radius_right",
                                 "reference", "direction",     "cutting_depth"};
constexpr std::array turning_keys{"nose_radius", "orientation", "tip_angle", "entering_angle", "edge_length"};
/// Words of `kind`: "groove", "turning", "mill", then those of ToolKind::other and behind it in their order. "mill" is
/// an end mill, bull nose or ball by its corner radius, and `other` without a radius.
const std::initializer_list<std::string_view> kind_words{
    "groove",       "turning",     "mill", "other",  "end-mill", "ball",   "bull-nose", "drill",
    "centre-drill", "countersink", "tap",  "reamer", "chamfer",  "t-slot", "form"};
constexpr std::size_t groove_word = 0, turning_word = 1, mill_word = 2;

template <class Keys>
void refuse(const Section& s, const Keys& keys, std::string_view kind, std::string_view allowed = {}) {
    for (const std::string_view key : keys)
        if (const Entry* e = find(s.table(), key); e && key != allowed)
            s.error(base::codes::job_value, e->where,
                    "'" + std::string(key) + "' means nothing for a tool of kind \"" + std::string(kind) + "\"");
}

void set(double& to, std::optional<double> from) { to = from.value_or(to); }

void read_blade(Section& s, Tool& t) {
    set(t.width, s.number("width", Range::positive));
    const auto both = s.number("corner_radius", Range::not_negative);
    set(t.corner_radius, both);
    t.corner_radius_left = s.number("corner_radius_left", Range::not_negative).value_or(t.corner_radius);
    t.corner_radius_right = s.number("corner_radius_right", Range::not_negative).value_or(t.corner_radius);
    if (const auto r = s.choice("reference", {"left", "right"}))
        t.reference = *r == 0 ? ReferenceCorner::left : ReferenceCorner::right;
    if (const auto d = s.choice("direction", {"out", "in", "face"})) t.direction = static_cast<BladeDirection>(*d);
    set(t.cutting_depth, s.number("cutting_depth", Range::not_negative));
}

void read_insert(Section& s, Tool& t) {
    set(t.nose_radius, s.number("nose_radius", Range::not_negative));
    if (const auto o = s.integer("orientation", 1, 9)) t.orientation = static_cast<int>(*o);
    set(t.tip_angle, s.number("tip_angle", Range::positive));
    // An insert whose tip lies on the nose axis is symmetrical unless its angle is given.
    if (t.orientation >= 5) t.entering_angle = 90 - t.tip_angle / 2;
    set(t.entering_angle, s.number("entering_angle", Range::positive));
    set(t.edge_length, s.number("edge_length", Range::positive));
}

void check_blade(const Section& s, const Tool& t) {
    refuse(s, turning_keys, "groove");
    refuse(s, std::array{"radius"}, "groove");
    if (!s.has("width")) s.missing("width");
    const double radii = t.corner_radius_left + t.corner_radius_right;
    const double widest = std::max(t.corner_radius_left, t.corner_radius_right);
    if (t.width > 0 && radii > t.width * (1 + 1e-9))
        s.error(base::codes::job_value,
                place(s, s.has("corner_radius")        ? "corner_radius"
                         : s.has("corner_radius_left") ? "corner_radius_left"
                                                       : "corner_radius_right"),
                "the corner radii (" + base::shortest(radii) + " mm together) do not fit on a width of " +
                    base::shortest(t.width) + " mm");
    else if (t.cutting_depth > 0 && widest > t.cutting_depth)
        s.error(base::codes::job_value, place(s, "cutting_depth"), "'cutting_depth' is smaller than a corner radius");
}

void check_insert(const Section& s, const Tool& t) {
    refuse(s, groove_keys, "turning", t.orientation == 9 ? "direction" : "");
    refuse(s, std::array{"radius"}, "turning");
    if (t.orientation == 9 && t.direction == BladeDirection::face)
        s.error(base::codes::job_value, place(s, "direction"),
                "a turning insert has the 'direction' \"out\" or \"in\"");
    if (t.tip_angle >= 180)
        s.error(base::codes::job_value, place(s, "tip_angle"), "'tip_angle' must be less than 180 degrees");
    else if (t.tip_angle + t.entering_angle > 180)
        s.error(base::codes::job_value, place(s, s.has("entering_angle") ? "entering_angle" : "tip_angle"),
                "'tip_angle' and 'entering_angle' are more than 180 degrees together: the second edge would cut below "
                "the tip");
}

void read_parameters(Section& s, Tool& t) {
    const Entry* e = s.sub_table("parameters");
    if (!e) return;
    for (const Entry& p : e->value.entries) {
        const std::string name = base::to_upper(p.key);
        const auto n = name.starts_with("DP") ? base::parse_integer(std::string_view(name).substr(2)) : std::nullopt;
        if (!n || *n < 1 || *n > 25) {
            s.error(base::codes::job_file, p.where, "unknown key '" + p.key + "' in 'parameters'", "DP1 … DP25");
        } else if (const auto v = finite_number(p.value, "'" + p.key + "'", Range::value, s.diagnostics())) {
            t.parameters[static_cast<int>(*n)] = *v;
        }
    }
}

/// The kind that a word and the dimensions read so far say.
ToolKind kind_of(std::size_t word, const Tool& t) {
    if (word == groove_word) return ToolKind::groove;
    if (word == turning_word) return ToolKind::turning;
    if (word == mill_word) return assumed_kind(t);
    return static_cast<ToolKind>(static_cast<std::size_t>(ToolKind::other) + word - mill_word - 1);
}

/// Holds what was read against the kind.
void check_kind(const Section& s, std::size_t word, Tool& t) {
    const std::string_view said = kind_words.begin()[word];
    t.kind = kind_of(word, t);
    t.reach_given = t.kind == ToolKind::groove ? t.cutting_depth > 0 : s.has("edge_length");
    if (t.kind == ToolKind::groove || t.kind == ToolKind::turning) {
        refuse_milling_keys(s, said);
        if (t.kind == ToolKind::groove)
            check_blade(s, t);
        else
            check_insert(s, t);
        return;
    }
    refuse(s, turning_keys, said);
    if (t.kind == ToolKind::other) {
        refuse_milling_keys(s, said);
        refuse(s, groove_keys, said);
        return;
    }
    refuse(s, std::array{"corner_radius_left", "corner_radius_right", "reference", "direction", "cutting_depth"}, said);
    check_milling_keys(s, t, word == mill_word);
}

/// Nothing where something of a milling tool was reported.
std::optional<Tool> read_tool(Section& s) {
    Tool t;
    const std::size_t before = s.diagnostics().all().size();
    t.where = s.table().where;
    if (const auto n = s.integer("number", 0, 999'999'999)) t.number = static_cast<std::uint32_t>(*n);
    if (const auto e = s.integer("edge", 1, 99)) {
        t.edge = static_cast<std::uint32_t>(*e);
        t.edge_given = true;
    }
    if (const auto name = s.text("name")) t.name = *name;
    const auto kind = s.choice("kind", kind_words);
    read_blade(s, t);
    read_insert(s, t);
    set(t.radius, s.number("radius", Range::not_negative));
    set(t.length, s.number("length"));
    if (kind == groove_word || kind == turning_word) {
        t.kind = kind_of(*kind, t);
        t.bodies = read_holder(s, t);
    }
    read_milling_keys(s, t);
    read_parameters(s, t);
    s.finish();
    if (!s.has("number")) s.missing("number");
    if (!s.has("kind")) s.missing("kind");
    if (kind) check_kind(s, *kind, t);
    const auto sound = [&] { return s.diagnostics().all().size() == before; };
    if (is_milling(t.kind) && sound()) check_dimensions(s, t);
    return sound() || !is_milling(t.kind) ? std::optional(t) : std::nullopt;
}

/// Number in "G59.1" (591) and "G54.1 P3", "G54P3", "G154 P3" (5403), of controls that have these; nothing of others.
std::optional<std::uint32_t> extended_datum(std::string_view key) {
    if (key.size() == 5 && base::to_upper(key).starts_with("G59.") && key[4] >= '1' && key[4] <= '3')
        return 590 + static_cast<std::uint32_t>(key[4] - '0');
    const auto p = base::to_upper(key).find('P');
    if (p == std::string::npos) return std::nullopt;
    const std::string g = base::to_upper(base::trim(key.substr(0, p)));
    const auto n = base::parse_integer(base::trim(key.substr(p + 1)));
    if ((g != "G54.1" && g != "G54" && g != "G154") || !n || *n < 1 || *n > 300) return std::nullopt;
    return 5400 + static_cast<std::uint32_t>(*n);
}

/// Number of "G54" … "G59", "G505" … "G599", "preset0" …; "active_preset" is the one a program finds in force.
std::optional<std::uint32_t> datum_number(std::string_view key) {
    if (key == "active_preset") return 500;
    if (base::to_upper(key).starts_with("PRESET")) {
        const auto n = base::parse_integer(key.substr(6));
        return n && *n >= 0 && *n <= 99'999 ? std::optional(first_preset + static_cast<std::uint32_t>(*n))
                                            : std::nullopt;
    }
    if (key.size() < 2 || base::upper(key[0]) != 'G') return std::nullopt;
    if (const auto extended = extended_datum(key)) return extended;
    const auto n = base::parse_integer(key.substr(1));
    if (!n || !((*n >= 54 && *n <= 59) || (*n >= 505 && *n <= 599))) return std::nullopt;
    return static_cast<std::uint32_t>(*n);
}

}  // namespace

void read_tool_tables(Section& file, std::vector<Tool>& tools) {
    for (const Value* v : file.tables("tool")) {
        Section s(*v, "[[tool]]", file.diagnostics());
        if (v->kind != ValueKind::table) continue;
        auto t = read_tool(s);
        if (!t || !s.has("number")) continue;
        const auto same = std::find_if(tools.begin(), tools.end(),
                                       [&](const Tool& o) { return o.number == t->number && o.edge == t->edge; });
        if (same == tools.end()) {
            tools.push_back(std::move(*t));
            continue;
        }
        base::Diagnostic d;
        d.code = base::codes::job_value;
        d.where = place(s, "number");
        d.text = "tool " + std::to_string(t->number) + " edge " + std::to_string(t->edge) + " is defined twice";
        d.related.push_back({{same->where.file, same->where.begin, same->where.begin + 1}, "first defined here"});
        file.diagnostics().add(std::move(d));
    }
}

DefaultsOverride read_defaults(Section& file) {
    DefaultsOverride out;
    const Entry* e = file.sub_table("defaults");
    if (!e) return out;
    Section s(e->value, "[defaults]", file.diagnostics());
    out.diameter_programming = s.boolean("diameter_programming");
    out.inch = s.boolean("inch");
    out.feed_per_rev = s.boolean("feed_per_rev");
    if (const auto p = s.integer("plane", 17, 19)) out.plane = static_cast<int>(*p);
    out.circle_tolerance = s.number("circle_tolerance", Range::not_negative);
    s.finish();
    return out;
}

std::map<std::uint32_t, geom::Vec3> read_datums(Section& file) {
    std::map<std::uint32_t, geom::Vec3> out;
    const Entry* e = file.sub_table("datum");
    if (!e) return out;
    bool diameter = false;
    if (const Entry* d = find(e->value, "diameter")) {
        Section flag(e->value, "[datum]", file.diagnostics());
        diameter = flag.boolean("diameter").value_or(d->value.boolean);
    }
    for (const Entry& datum : e->value.entries) {
        if (datum.key == "diameter") continue;
        const auto n = datum_number(datum.key);
        if (!n) {
            file.error(base::codes::job_file, datum.where, "unknown key '" + datum.key + "' in [datum]",
                       "G54 … G59, \"G59.1\" … \"G59.3\", \"G54.1 P1\" … \"G54.1 P300\", G505 … G599, preset0 … "
                       "preset99999, active_preset, diameter");
            continue;
        }
        Section s(datum.value, "'" + datum.key + "'", file.diagnostics());
        const double x = s.number("x").value_or(0), y = s.number("y").value_or(0), z = s.number("z").value_or(0);
        s.finish();
        out[*n] = {diameter ? x / 2 : x, y, z};
    }
    return out;
}

}  // namespace obrys::shop
