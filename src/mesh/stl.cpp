#include "mesh/stl.hpp"

#include <algorithm>
#include <limits>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "mesh/little_endian.hpp"
#include "mesh/stl_soup.hpp"
#include "mesh/surface_remarks.hpp"

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

void remark_rest(const StlFile& stl, bool unit_known, Remarks& remarks) {
    if (stl.degenerate > 0)
        remarks.note(counted(stl.degenerate, "triangle", "triangles") + " of " + std::to_string(stl.triangles) +
                     " left out: two corners in one place");
    if (stl.turned_over) remarks.note("the surface was inside out; it was turned over");
    const Vec3 size = bounds(stl.mesh).size();
    if (stl.maybe_inch && !unit_known)
        remarks.note("STL files have no unit: taken for millimetres, the part measures " + base::fixed(size.x, 3) +
                         " x " + base::fixed(size.y, 3) + " x " + base::fixed(size.z, 3) + " mm",
                     "if it was drawn in inch, scale it by 25.4 (in a job: unit = \"inch\")");
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
    // Counts and numbers of a binary file are no text.
    if (stl.binary && bytes.find('\0') == std::string_view::npos && base::is_utf8(bytes))
        return refuse(base::codes::mesh_file, "this is no STL file: it is text that does not begin with \"solid\"");
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
    remarks.surface(stl.topology,
                    "close it in the CAD system; corners that were rounded apart can be joined by a tolerance");
    remark_rest(stl, options.unit_known, remarks);
    return stl;
}

}  // namespace obrys::mesh
