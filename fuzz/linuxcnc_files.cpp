// Any bytes are read without crash as LinuxCNC tool table, parameter file and configuration; the first two come back
// byte for byte and take changes; every span lies inside the text.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "shop/files/linuxcnc/ini.hpp"
#include "shop/files/linuxcnc/parameters.hpp"
#include "shop/files/linuxcnc/table.hpp"

namespace {

using namespace obrys;

void require(bool holds) {
    if (!holds) std::abort();
}

void check_span(const base::Span& s, std::size_t size) { require(s.begin <= s.end && s.end <= size); }

struct Input {
    base::Sources sources;
    base::Diagnostics diagnostics;

    explicit Input(std::string text) { (void)sources.add("FUZZ", std::move(text)); }
    [[nodiscard]] std::string_view text() const { return sources[0].text; }
    void check() const {
        for (const base::Diagnostic& d : diagnostics.all())
            check_span(d.where, text().size()), (void)base::render(d, sources);
    }
};

void tool_table(const std::string& text) {
    Input in(text);
    shop::LinuxcncTable table = shop::read_linuxcnc_table(0, in.sources, in.diagnostics);
    require(shop::write_linuxcnc_table(table) == in.text());
    for (const shop::Tool& t : shop::tools_of(table, 25.4, in.diagnostics)) {
        check_span(t.where, in.text().size());
        (void)shop::outline(t);
    }
    in.check();
    for (std::size_t i = 0; i < table.lines.size() && i < 16; ++i)
        for (const char letter : {'Z', 'D', 'T', 'Q'}) {
            if (shop::set_field(table, i, letter, 7)) continue;
            require(shop::value_of(table.lines[i], letter) == 7.0);
            Input again(shop::write_linuxcnc_table(table));
            const auto second = shop::read_linuxcnc_table(0, again.sources, again.diagnostics);
            require(second.lines.size() == table.lines.size());
            require(shop::value_of(second.lines[i], letter) == 7.0);
            require(shop::comment_of(second.lines[i]) == shop::comment_of(table.lines[i]));
        }
    (void)shop::add_tool(table, 31, 31);
}

void parameters(const std::string& text) {
    Input in(text);
    auto p = shop::read_linuxcnc_parameters(0, in.sources, in.diagnostics);
    require(shop::write_linuxcnc_parameters(p) == in.text());
    in.check();
    require(!shop::set_parameter(p, 5221, 7));
    Input again(shop::write_linuxcnc_parameters(p));
    require(shop::value_of(shop::read_linuxcnc_parameters(0, again.sources, again.diagnostics), 5221) == 7.0);
}

void configuration(const std::string& text) {
    Input in(text);
    const auto ini = shop::read_linuxcnc_ini(0, in.sources, in.diagnostics);
    for (const shop::IniEntry& e : ini.entries) {
        check_span(e.where, in.text().size());
        require(shop::find(ini, e.section, e.key) != nullptr);
    }
    const shop::LinuxcncSettings s = shop::settings_of(ini, in.diagnostics);
    require(s.mm_per_unit == 1 || s.mm_per_unit == 25.4);
    require(std::isfinite(s.arc_tolerance_mm) && std::isfinite(s.arc_tolerance_inch));
    in.check();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    tool_table(text);
    parameters(text);
    configuration(text);
    return 0;
}
