#include <nlohmann/json.hpp>

#include "cl/unknown_tool.hpp"
#include "report/sheet/sheet.hpp"

namespace obrys::report::sheet {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson known(double value) { return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr); }
OrderedJson known(std::uint32_t number) {
    return number == cl::unknown_tool ? OrderedJson(nullptr) : OrderedJson(number);
}
OrderedJson as_array(const geom::Vec3& v) { return {known(v.x), known(v.y), known(v.z)}; }
OrderedJson as_array(const Extent& e) { return {{"low_mm", as_array(e.low)}, {"high_mm", as_array(e.high)}}; }

void put_times(OrderedJson& out, const Times& t) {
    out["feed_path_mm"] = t.feed_mm;
    out["rapid_path_mm"] = t.rapid_mm;
    out["feed_s"] = t.feed_s;
    out["rapid_s"] = known(t.rapid_s);
    out["dwell_s"] = t.dwell_s;
    out["total_s"] = known(t.seconds());
    out["complete"] = t.is_whole() && std::isfinite(t.rapid_s);
    out["untimed_path_mm"] = t.untimed_mm;
    out["untimed_dwells"] = t.untimed_dwells;
    out["unmeasured_moves"] = t.unmeasured;
    out["rotary_moves"] = t.rotary;
}

OrderedJson tool_json(const ToolUse& t) {
    OrderedJson out{{"number", known(t.number)}, {"edge", known(t.edge)}, {"name", t.name}, {"kind", t.kind}};
    out["diameter_mm"] = known(t.diameter);
    out["width_mm"] = known(t.width);
    out["corner_radius_mm"] = known(t.corner);
    out["length_mm"] = known(t.length);
    out["calls"] = t.calls;
    out["feed_mm_per_min"] = {known(t.least_feed), known(t.most_feed)};
    out["speed_rpm"] = {known(t.least_speed), known(t.most_speed)};
    out["coolant"] = {{"flood", t.flood}, {"mist", t.mist}};
    out["cycles"] = OrderedJson::object();
    for (const auto& [kind, count] : t.cycles) out["cycles"][kind] = count;
    out["cut"] = as_array(t.cut);
    put_times(out, t.times);
    return out;
}

}  // namespace

std::string as_json(const std::vector<Program>& programs) {
    OrderedJson all{{"format", "obrys-sheet"}, {"version", 1}, {"programs", OrderedJson::array()}};
    for (const Program& p : programs) {
        OrderedJson out{{"program", p.name}, {"control", p.control}, {"machine", p.machine}};
        out["stock"] = p.stock.empty() ? OrderedJson(nullptr) : OrderedJson(p.stock);
        out["clamps"] = p.clamps;
        out["whole"] = p.not_whole.empty();
        out["moves"] = p.moves;
        out["tool_changes"] = p.tool_changes;
        out["stops"] = p.stops;
        out["optional_stops"] = p.optional_stops;
        out["rapid_mm_per_min"] = known(p.rapid);
        out["travel"] = as_array(p.travel);
        out["cut"] = as_array(p.cut);
        put_times(out, p.times);
        out["tools"] = OrderedJson::array();
        for (const ToolUse& t : p.tools) out["tools"].push_back(tool_json(t));
        out["zeros"] = OrderedJson::array();
        for (const ZeroUse& z : p.zeros) {
            OrderedJson zero{{"number", z.number}, {"machine_mm", as_array(z.origin)}, {"moves", z.moves}};
            zero["travel"] = as_array(z.extent);
            out["zeros"].push_back(std::move(zero));
        }
        out["called"] = p.called;
        out["messages"] = p.messages;
        all["programs"].push_back(std::move(out));
    }
    return all.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace obrys::report::sheet
