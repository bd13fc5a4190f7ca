#include "driver/documents/stream_table.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::driver {

namespace {

constexpr int decimals = 9;

/// What CSV and JSON rows are made of.
struct Row {
    const char* kind = "";
    geom::Vec3 to;
    const cl::Arc* arc = nullptr;
    const cl::Spline* spline = nullptr;
    bool rapid = false;
};

bool row_of(const cl::Step& step, Row& row) {
    if (const auto* line = std::get_if<cl::Linear>(&step)) {
        row = {line->rapid ? "rapid" : "linear", line->to, nullptr, nullptr, line->rapid};
        return true;
    }
    if (const auto* arc = std::get_if<cl::Arc>(&step)) {
        row = {"arc", arc->to, arc, nullptr, arc->rapid};
        return true;
    }
    if (const auto* spline = std::get_if<cl::Spline>(&step)) {
        row = {"spline", spline->to, nullptr, spline, false};
        return true;
    }
    if (const auto* thread = std::get_if<cl::Thread>(&step)) {
        row = {"thread", thread->to, nullptr, nullptr, false};
        return true;
    }
    return false;
}

/// Seen against the plane's positive normal, as G2 and G3 are meant.
const char* sense_of(const cl::Arc& a) {
    const double up = a.normal.x + a.normal.y + a.normal.z;
    return (a.sweep > 0) == (up > 0) ? "ccw" : "cw";
}

nlohmann::ordered_json json_number(double v) {
    return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
}
nlohmann::ordered_json json_point(geom::Vec3 p) { return {json_number(p.x), json_number(p.y), json_number(p.z)}; }

void add_coefficients(nlohmann::ordered_json& j, const cl::Spline& s) {
    j["k3_mm"] = json_point(s.k3);
    j["k2_mm"] = json_point(s.k2);
    j["k1_mm"] = json_point(s.k1);
    for (const cl::SplineAxis& a : s.axes) {
        const std::string name(cl::name_of(a.name));
        j["axes"].push_back({{"name", base::as_utf8(name)},
                             {"unit", a.rotary ? "deg" : "mm"},
                             {"to", json_number(a.to)},
                             {"k3", json_number(a.k3)},
                             {"k2", json_number(a.k2)},
                             {"k1", json_number(a.k1)}});
    }
}

void append_number(std::string& out, double v) {
    out += ',';
    if (std::isfinite(v)) base::append_fixed(out, v, decimals);
}

}  // namespace

CsvWriter::CsvWriter(const base::Sources& sources, TextSink out) : sources_(sources), out_(out) {
    out_("i,file,line,block,kind,x,y,z,feed,cx,cy,cz,sense\n");
}

void CsvWriter::operator()(const cl::Record& r) {
    const auto step = cursor_.take(r);
    Row row;
    if (!step || !row_of(r.step, row)) return;
    row_.clear();
    row_ += std::to_string(step->index) + ',' + base::csv_field(sources_[r.from.file].name) + ',' +
            std::to_string(sources_.position(r.from).line) + ',';
    if (const auto block = sources_.block_number(r.from.file, r.from.begin)) row_ += std::to_string(*block);
    row_ += std::string(",") + row.kind;
    append_number(row_, row.to.x);
    append_number(row_, row.to.y);
    append_number(row_, row.to.z);
    append_number(row_, row.rapid ? NAN : step->state.feed.value);
    append_number(row_, row.arc != nullptr ? row.arc->centre.x : NAN);
    append_number(row_, row.arc != nullptr ? row.arc->centre.y : NAN);
    append_number(row_, row.arc != nullptr ? row.arc->centre.z : NAN);
    row_ += std::string(",") + (row.arc != nullptr ? sense_of(*row.arc) : "") + "\n";
    out_(row_);
}

void JsonWriter::operator()(const cl::Record& r) {
    const auto step = cursor_.take(r);
    Row row;
    if (!step || !row_of(r.step, row)) return;
    nlohmann::ordered_json j;
    j["i"] = step->index;
    j["file"] = base::as_utf8(sources_[r.from.file].name);
    j["line"] = sources_.position(r.from).line;
    const auto block = sources_.block_number(r.from.file, r.from.begin);
    j["block"] = block ? nlohmann::ordered_json(*block) : nlohmann::ordered_json(nullptr);
    j["kind"] = row.kind;
    j["x_mm"] = json_number(row.to.x);
    j["y_mm"] = json_number(row.to.y);
    j["z_mm"] = json_number(row.to.z);
    if (!row.rapid) j["feed"] = step->state.feed.value;
    if (row.arc != nullptr) {
        j["centre_mm"] = json_point(row.arc->centre);
        j["sense"] = sense_of(*row.arc);
        j["sweep_deg"] = geom::degrees(row.arc->sweep);
    }
    if (row.spline != nullptr) add_coefficients(j, *row.spline);
    out_((step->index == 0 ? "[\n" : ",\n") + j.dump());
}

void JsonWriter::finish() { out_(cursor_.moves() == 0 ? "[]\n" : "\n]\n"); }

}  // namespace obrys::driver
