#include "driver/tool_files.hpp"

#include "base/codes.hpp"
#include "base/text.hpp"
#include "driver/control.hpp"
#include "driver/files.hpp"
#include "driver/first_tool.hpp"
#include "shop/files/fusion/tools.hpp"
#include "shop/files/heidenhain/views.hpp"
#include "shop/files/linuxcnc/table.hpp"
#include "shop/files/obrys/tool_file.hpp"
#include "shop/files/siemens/toa.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

/// A tool list (.toml), a HEIDENHAIN (.t) or LinuxCNC (.tbl) tool table, a Fusion tool library (.json, or what begins
/// like JSON), or SINUMERIK tool data (any other ending).
std::vector<shop::Tool> read_tool_file(const fs::path& path, std::uint32_t file, Session& s) {
    if (base::equals_ignoring_case(path.extension().string(), ".toml"))
        return shop::read_tools(file, s.sources, s.diagnostics);
    if (base::equals_ignoring_case(path.extension().string(), ".tbl"))
        return shop::read_tbl(file, s.sources, s.machine_unit, s.diagnostics);
    if (base::equals_ignoring_case(path.extension().string(), ".t"))
        return shop::read_tool_t(file, s.sources, s.diagnostics);
    const std::string_view text = base::trim(s.sources[file].text);
    if (base::equals_ignoring_case(path.extension().string(), ".json") || text.starts_with('{'))
        return shop::read_fusion_tools(file, s.sources, s.diagnostics);
    return shop::read_toa(file, s.sources, s.diagnostics);
}

void load_tool_file(Session& s, const fs::path& path, const base::Span& where) {
    const auto file = load(*s.storage, path, s.sources, s.diagnostics, where);
    if (file) s.job.tools = shop::merge_tools(std::move(s.job.tools), read_tool_file(path, *file, s));
}

/// The control's stand-alone interpreter knows some tools.
void take_example_tools(Session& s) {
    const std::string_view table = find_control(s.control)->interpreter_tools;
    if (table.empty()) return;
    s.job.tools =
        shop::read_tbl(s.sources.add("tool.tbl", std::string(table)), s.sources, s.machine_unit, s.diagnostics);
    if (selects_tool(*s.main))
        s.diagnostics.add(
            {base::Severity::note,
             codes::assumption,
             nowhere,
             "no tools are given: those of LinuxCNC's stand-alone interpreter are taken (T1, T2, T3, T99999)",
             "give the tool table with --tools",
             {},
             {}});
}

}  // namespace

void load_tools(Session& s, const Request& request, const fs::path& base_path) {
    for (const shop::NamedFile& f : s.job.tool_files) load_tool_file(s, beside(base_path, f.path), f.where);
    for (const std::string& name : request.tools) load_tool_file(s, name, nowhere);
    if (s.stand_alone && s.job.tools.empty()) take_example_tools(s);
    for (const shop::Tool& t : s.job.tools)
        if (!t.assumed.empty())
            s.diagnostics.add({base::Severity::note, codes::assumption, t.where, t.assumed, {}, {}, {}});
}

}  // namespace obrys::driver
