#include "mesh/stl.hpp"

#include <algorithm>
#include <limits>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "mesh/little_endian.hpp"
#include "mesh/stl_soup.hpp"

namespace obrys::mesh {

namespace {

using geom::Vec3;

/// A part below this in every direction may have been drawn in inch, mm. A guess, so only a hint is made of it.
constexpr double small_part = 10;

/// Binary files may begin with the word "solid" too; then their size gives them away.
bool is_ascii(std::string_view bytes) {
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n\v\f");
    if (begin == std::string_view::npos || !base::equals_ignoring_case(bytes.substr(begin, 5), "solid")) return false;
    if (bytes.size() >= 84) {
        if (bytes.size() == 84 + 50 * std::size_t{read_u32(bytes, 80)}) return false;
    }
    return bytes.substr(0, 512).find('\0') == std::string_view::npos;
}

std::string place(Vec3 p) {
    return "X " + base::fixed(p.x, 3) + " Y " + base::fixed(p.y, 3) + " Z " + base::fixed(p.z, 3);
}

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

class Remarks {
public:
    Remarks(std::uint32_t file, base::Diagnostics& out) : file_(file), out_(out) {}

    void say(base::Severity severity, std::string_view code, std::string text, std::string remedy = "") {
        base::Diagnostic d;
        d.severity = severity;
        d.code = code;
        d.where = {file_, 0, 0};
        d.text = std::move(text);
        d.remedy = std::move(remedy);
        out_.add(std::move(d));
    }

    void edges(const EdgeFault& fault, const std::string& what, std::string remedy) {
        if (fault.count == 0) return;
        say(base::Severity::warning, base::codes::mesh_not_closed,
            "the surface does not bound a solid: " + counted(fault.count, "edge", "edges") + " " + what +
                ", the first from " + place(fault.from) + " to " + place(fault.to),
            std::move(remedy));
    }

    void note(std::string text, std::string remedy = "") {
        say(base::Severity::note, base::codes::assumption, std::move(text), std::move(remedy));
    }

private:
    std::uint32_t file_;
    base::Diagnostics& out_;
};

void remark_surface(const StlFile& stl, Remarks& remarks) {
    remarks.edges(stl.topology.open, "with one triangle only (holes, or corners that do not meet)",
                  "close it in the CAD system; corners that were rounded apart can be joined by a tolerance");
    remarks.edges(stl.topology.crowded, "with more than two triangles (bodies that touch)", "export one body");
    remarks.edges(stl.topology.turned, "between triangles of opposite orientation", "make its normals point outwards");
}

void remark_rest(const StlFile& stl, Remarks& remarks) {
    if (stl.degenerate > 0)
        remarks.note(counted(stl.degenerate, "triangle", "triangles") + " of " + std::to_string(stl.triangles) +
                     " left out: two corners in one place");
    if (stl.turned_over) remarks.note("the surface was inside out; it was turned over");
    const Vec3 size = bounds(stl.mesh).size();
    if (stl.maybe_inch)
        remarks.note("STL files have no unit: taken for millimetres, the part measures " + base::fixed(size.x, 3) +
                         " x " + base::fixed(size.y, 3) + " x " + base::fixed(size.z, 3) + " mm",
                     "if it was drawn in inch, scale it by 25.4");
}

/// A volume that can be told from rounding, and is negative.
bool is_inside_out(const Mesh& m) {
    const Vec3 size = bounds(m).size();
    return volume(m) < -1e-12 * size.x * size.y * size.z;
}

}  // namespace

std::optional<StlFile> read_stl(std::uint32_t file, std::string_view bytes, base::Diagnostics& out,
                                const StlOptions& options) {
    Remarks remarks(file, out);
    const auto refuse = [&](std::string_view code, std::string text) {
        remarks.say(base::Severity::error, code, std::move(text));
        return std::nullopt;
    };
    if (bytes.empty()) return refuse(base::codes::file_empty, "the STL file is empty");
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
        return refuse(base::codes::mesh_file, "STL files of 4 GiB and more are not read");
    StlFile stl;
    stl.binary = !is_ascii(bytes);
    Soup soup(options.weld);
    const bool ok = stl.binary ? read_binary_stl(file, bytes, soup, out) : read_ascii_stl(file, bytes, soup, out);
    if (!ok) return std::nullopt;
    stl.mesh.triangles = std::move(soup.triangles);
    stl.mesh.vertices = soup.welder.take();
    stl.triangles = soup.read;
    stl.degenerate = soup.degenerate;
    if (stl.mesh.empty())
        return refuse(
            base::codes::mesh_file,
            "the STL file holds no triangle" + std::string(stl.triangles > 0 ? " with three different corners" : ""));
    stl.topology = topology(stl.mesh);
    stl.turned_over = stl.topology.closed() && is_inside_out(stl.mesh);
    if (stl.turned_over) turn_over(stl.mesh);
    const Vec3 size = bounds(stl.mesh).size();
    stl.maybe_inch = std::max({size.x, size.y, size.z}) < small_part;
    remark_surface(stl, remarks);
    remark_rest(stl, remarks);
    return stl;
}

}  // namespace obrys::mesh
