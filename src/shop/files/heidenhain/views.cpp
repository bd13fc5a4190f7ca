#include "shop/files/heidenhain/views.hpp"

#include <cmath>

#include "base/text.hpp"
#include "shop/files/heidenhain/cells.hpp"

namespace obrys::shop {

namespace {

constexpr std::uint32_t largest_row = 99'999'999;

double angle(Cells& row, std::string_view column) {
    const auto v = row.real(column);
    return v ? geom::radians(*v) : no_entry;
}

geom::Vec3 position(Cells& row) {
    return {row.length("X").value_or(no_entry), row.length("Y").value_or(no_entry), row.length("Z").value_or(no_entry)};
}

/// The name of the column that numbers the rows differs: D, NR, NO.
std::optional<std::uint32_t> row_of(Cells& row) {
    const auto n = row.number(largest_row, 0);
    return n ? std::optional(n->whole) : std::nullopt;
}

}  // namespace

std::map<std::uint32_t, DatumRow> datums_of(const HeidenhainTable& table, base::Diagnostics& diagnostics) {
    std::map<std::uint32_t, DatumRow> datums;
    Cells row(table, diagnostics);
    while (row.next()) {
        const auto number = row_of(row);
        if (!number) continue;
        DatumRow d;
        d.position = position(row);
        d.rotary = {angle(row, "A"), angle(row, "B"), angle(row, "C")};
        d.secondary = {row.length("U").value_or(no_entry), row.length("V").value_or(no_entry),
                       row.length("W").value_or(no_entry)};
        const double rotation = angle(row, "ROT");
        d.rotation = std::isnan(rotation) && !row.filled("ROT") ? 0 : rotation;
        d.comment = row.text("DOC");
        d.where = row.where();
        datums.emplace(*number, std::move(d));
    }
    return datums;
}

std::vector<PatternPoint> points_of(const HeidenhainTable& table, base::Diagnostics& diagnostics) {
    std::vector<PatternPoint> points;
    Cells row(table, diagnostics);
    if (!row.need({"X", "Y"})) return points;
    while (row.next()) {
        const auto number = row_of(row);
        if (!number) continue;
        PatternPoint p;
        p.number = *number;
        p.position = position(row);
        p.hidden = base::equals_ignoring_case(row.text("FADE"), "Y");
        p.clearance = row.length("CLEARANCE").value_or(no_entry);
        p.where = row.where();
        points.push_back(p);
    }
    return points;
}

std::vector<CuttingData> cutting_data_of(const HeidenhainTable& table, base::Diagnostics& diagnostics) {
    std::vector<CuttingData> all;
    Cells row(table, diagnostics);
    if (!row.need({"WMAT", "TMAT"})) return all;
    std::size_t pairs = 0;
    while (row.has("Vc" + std::to_string(pairs + 1))) ++pairs;
    while (row.next()) {
        CuttingData data;
        data.work_material = row.text("WMAT");
        data.cutter_material = row.text("TMAT");
        for (std::size_t n = 1; n <= pairs; ++n)
            data.pairs.push_back({row.real("Vc" + std::to_string(n)).value_or(no_entry),
                                  row.real("F" + std::to_string(n)).value_or(no_entry)});
        all.push_back(std::move(data));
    }
    return all;
}

std::optional<CuttingData::Pair> find_cutting_data(const std::vector<CuttingData>& all, std::string_view work_material,
                                                   std::string_view cutter_material, std::size_t n) {
    for (const CuttingData& d : all) {
        if (!base::equals_ignoring_case(d.work_material, work_material) ||
            !base::equals_ignoring_case(d.cutter_material, cutter_material))
            continue;
        if (n < 1 || n > d.pairs.size()) return std::nullopt;
        const CuttingData::Pair& p = d.pairs[n - 1];
        return std::isnan(p.speed) || std::isnan(p.feed) ? std::nullopt : std::optional(p);
    }
    return std::nullopt;
}

SpindleAndFeed spindle_and_feed(const CuttingData::Pair& pair, const Tool& tool) {
    const double speed = tool.radius > 0 ? 1000 * pair.speed / (2 * geom::pi * tool.radius) : no_entry;
    return {speed, tool.teeth > 0 ? speed * tool.teeth * pair.feed : no_entry};
}

std::vector<Material> materials_of(const HeidenhainTable& table) {
    std::vector<Material> materials;
    base::Diagnostics none;
    Cells row(table, none);
    while (row.next())
        if (row.filled("NAME")) materials.push_back({row.text("NAME"), row.text("DOC"), row.where()});
    return materials;
}

}  // namespace obrys::shop
