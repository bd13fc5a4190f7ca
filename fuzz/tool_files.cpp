// Any bytes are read without crash as job, tool list, machine, SINUMERIK tool data and Fusion tool library; every span
// lies inside the text, and a milling tool that a library or a tool list gives has dimensions that make one.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "shop/files/fusion/tools.hpp"
#include "shop/files/obrys/job_file.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/files/obrys/tool_file.hpp"
#include "shop/files/siemens/toa.hpp"
#include "shop/job.hpp"
#include "shop/kinematics.hpp"

namespace {

using namespace obrys;

void require(bool holds) {
    if (!holds) std::abort();
}

template <class Read>
void with(const std::string& text, const Read& read) {
    base::Sources sources;
    base::Diagnostics diagnostics;
    const std::uint32_t file = sources.add("FUZZ", text);
    read(file, sources, diagnostics);
    for (const base::Diagnostic& d : diagnostics.all()) {
        require(d.where.begin <= d.where.end && d.where.end <= sources[file].text.size());
        (void)base::render(d, sources);
    }
}

void check_tools(const std::vector<shop::Tool>& tools, bool sound) {
    for (const shop::Tool& t : tools) {
        if (sound) require(shop::dimension_fault(t).ok());
        (void)shop::outline(t);
        (void)shop::cutting_height(t);
        (void)shop::may_plunge(t);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    with(text,
         [](auto file, const auto& sources, auto& d) { check_tools(shop::read_fusion_tools(file, sources, d), true); });
    with(text, [](auto file, const auto& sources, auto& d) { check_tools(shop::read_toa(file, sources, d), false); });
    with(text, [](auto file, const auto& sources, auto& d) { check_tools(shop::read_tools(file, sources, d), true); });
    with(text,
         [](auto file, const auto& sources, auto& d) { check_tools(shop::read_job(file, sources, d).tools, true); });
    with(text, [](auto file, const auto& sources, auto& d) {
        const shop::Chain chain = shop::chain_of(shop::read_machine(file, sources, d));
        (void)shop::positions_for(chain, {{1, 2, 3}, {0, 0.6, 0.8}}, 100);
    });
    return 0;
}
