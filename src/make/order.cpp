#include "make/order.hpp"

#include <array>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "shop/files/section.hpp"

namespace obrys::make {

namespace {

using shop::Range;

/// A key and its other names: the letters of drawings and cycles.
struct Names {
    std::string_view name;
    std::array<std::string_view, 2> others{};
};

class Reader {
public:
    explicit Reader(shop::Section& file) : file_(file) {}

    /// Nothing where it is missing or wrong; a second name of the same is an error.
    std::optional<double> number(const Names& names, Range range, bool required) {
        std::string_view found;
        for (const std::string_view name : {names.name, names.others[0], names.others[1]}) {
            if (name.empty() || !file_.has(name)) continue;
            if (!found.empty()) {
                file_.error(base::codes::job_value, shop::find(file_.table(), name)->where,
                            std::string(name) + " says again what " + std::string(found) + " says",
                            "leave one of the two out");
                static_cast<void>(file_.take(name));
                continue;
            }
            found = name;
        }
        if (found.empty()) {
            if (required) file_.missing(names.name);
            // known all the same, for the nearest key of a wrong one
            for (const std::string_view name : {names.name, names.others[0], names.others[1]})
                if (!name.empty()) static_cast<void>(file_.take(name));
            return std::nullopt;
        }
        last_ = shop::place(file_, found);
        return file_.number(found, range);
    }
    double maybe(const Names& names, Range range, double otherwise) {
        return number(names, range, false).value_or(otherwise);
    }
    double need(const Names& names, Range range) { return number(names, range, true).value_or(1); }
    double angle(const Names& names, double least, double most) {
        const std::optional<double> degrees = number(names, Range::any, false);
        if (degrees && (*degrees < least || *degrees > most))
            file_.error(base::codes::job_value, last_,
                        "the angle of " + base::shortest(*degrees) + " degrees is not from " + base::shortest(least) +
                            " to " + base::shortest(most),
                        "angles of flanks are from the direction of the depth, those of the surface from it");
        return geom::radians(degrees.value_or(0));
    }
    groove::Corner corner(const Names& names, groove::Corner::Form chamfer) {
        const double size = maybe(names, Range::any, 0);
        return size < 0 ? groove::Corner{-size, chamfer} : groove::Corner{size, groove::Corner::Form::radius};
    }

private:
    shop::Section& file_;
    base::Span last_;
};

void read_place(shop::Section& file, Placing& placing) {
    const std::size_t surface = file.choice("position", {"outside", "inside", "face"}).value_or(0);
    const bool counter = file.choice("spindle", {"main", "counter"}).value_or(0) == 1;
    placing.surface = surface == 0   ? Surface::outside
                      : surface == 1 ? Surface::inside
                      : counter      ? Surface::counter_face
                                     : Surface::face;
    const bool left = file.choice("start", {"right", "left"}).value_or(0) == 1;
    placing.turned = left;
}

void read_shape(shop::Section& file, Reader& reader, Order& order) {
    using Side = groove::Side;
    groove::Shape& s = order.request.shape;
    const std::size_t right = groove::index(Side::right), left = groove::index(Side::left);
    const auto chamfer = file.choice("chamfer", {"leg", "base"}).value_or(0) == 1 ? groove::Corner::Form::base
                                                                                  : groove::Corner::Form::leg;
    const double x = reader.need({"x", {"x0"}}, Range::any), z = reader.maybe({"z", {"z0"}}, Range::any, 0);
    s.p = order.placing.in_groove({z, x});
    s.slope = order.placing.slope(reader.angle({"slope", {"a0"}}, -89.999, 89.999));
    s.depth = reader.need({"depth", {"h"}}, Range::positive);
    s.width = reader.need({"bottom_width", {"b"}}, Range::positive);
    s.flank[right] = reader.angle({"flank_1", {"f1"}}, 0, 89.999);
    s.flank[left] = reader.angle({"flank_2", {"f2"}}, 0, 89.999);
    s.outer[right] = reader.corner({"outer_1", {"rco1"}}, chamfer);
    s.inner[right] = reader.corner({"inner_1", {"rci1"}}, chamfer);
    s.outer[left] = reader.corner({"outer_2", {"rco2"}}, chamfer);
    s.inner[left] = reader.corner({"inner_2", {"rci2"}}, chamfer);
    s.leave_bottom = reader.maybe({"allow_bottom", {"alb"}}, Range::not_negative, 0);
    s.leave_flank = reader.maybe({"allow_flank", {"alf"}}, Range::not_negative, 0);
}

void read_manner(Reader& reader, Order& order) {
    groove::Insert& insert = order.request.insert;
    groove::Manner& m = order.request.manner;
    insert.width = reader.need({"insert_width", {"width", "w"}}, Range::positive);
    insert.corner_radius = reader.maybe({"corner_radius"}, Range::not_negative, 0);
    insert.reach = reader.maybe({"reach"}, Range::positive, insert.reach);
    m.infeed = reader.need({"infeed"}, Range::any);
    const std::optional<double> step = reader.number({"stepover"}, Range::any, false);
    order.stepover_given = step.has_value();
    m.stepover = step.value_or(0.8 * insert.width);
    m.clearance = reader.maybe({"clearance", {"safe"}}, Range::positive, m.clearance);
    m.peck = reader.maybe({"peck"}, Range::not_negative, 0);
    m.retract = reader.maybe({"retract"}, Range::positive, m.retract);
    m.rib = reader.maybe({"rib"}, Range::positive, m.rib);
    m.layer = reader.maybe({"layer"}, Range::positive, 0);
    m.lift = reader.maybe({"lift"}, Range::not_negative, m.lift);
    m.ramp_angle = geom::radians(reader.maybe({"ramp_angle"}, Range::positive, geom::degrees(m.ramp_angle)));
    m.dwell = reader.maybe({"dwell"}, Range::not_negative, 0);
}

void read_cutting(shop::Section& file, Reader& reader, Cutting& c) {
    for (const char* key : {"feed", "cutting_speed", "speed_limit", "rapid"})
        if (!file.has(key)) c.assumed.emplace_back(key);
    c.feed = reader.maybe({"feed"}, Range::positive, c.feed);
    c.speed = reader.maybe({"cutting_speed"}, Range::positive, c.speed);
    c.speed_limit = reader.maybe({"speed_limit"}, Range::positive, c.speed_limit);
    c.rapid = reader.maybe({"rapid"}, Range::positive, c.rapid);
}

/// The bottom of a groove on a bar, and the surface of one in a bore, lie on this side of the axis.
void look_at_axis(const shop::Section& file, const Order& order) {
    const groove::Shape& s = order.request.shape;
    const bool bar = order.placing.surface == Surface::outside && s.p.y - s.depth < 0;
    const bool bore = order.placing.surface == Surface::inside && s.p.y > 0;
    if (bar || bore)
        file.error(base::codes::job_value, shop::place(file, file.has("h") ? "h" : "depth"),
                   bar ? "the bottom lies beyond the axis of the spindle" : "the surface lies beyond the axis",
                   bar ? "make the groove less deep: x is a radius" : "give x as a radius above 0");
}

}  // namespace

std::optional<Order> read_order(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    const std::optional<shop::Value> table = shop::parse_toml(file, sources, diagnostics);
    if (!table) return std::nullopt;
    base::Diagnostics found;
    shop::Section section(*table, "the file", found);
    Reader reader(section);
    Order order;
    read_place(section, order.placing);
    read_shape(section, reader, order);
    read_manner(reader, order);
    read_cutting(section, reader, order.cutting);
    order.tool = static_cast<std::uint32_t>(section.integer("tool", 1, 99'999).value_or(1));
    if (!found.has_errors()) look_at_axis(section, order);
    section.finish_file(diagnostics);
    if (found.has_errors()) return std::nullopt;
    return order;
}

groove::Request request_for(const Order& order, groove::Strategy strategy) {
    groove::Request r = order.request;
    if (strategy == groove::Strategy::cycle93 && !order.stepover_given)
        r.manner.stepover = 0.95 * (r.insert.width - 2 * r.insert.corner_radius);
    return r;
}

}  // namespace obrys::make
