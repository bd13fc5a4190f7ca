#include "shop/files/linuxcnc/ini.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "shop/files/lines.hpp"

namespace obrys::shop {

namespace {

class IniReader {
public:
    IniReader(std::string_view text, LinuxcncIni& ini, base::Diagnostics& diagnostics)
        : lines_(text), ini_(ini), diagnostics_(diagnostics) {}

    void read() {
        while (!lines_.done()) line(lines_.take());
    }

private:
    void line(const TableLine& text);
    void section(std::string_view text, std::uint32_t at);
    void entry(std::string_view text, std::uint32_t at, std::size_t equals);
    void warning(std::string_view where, std::uint32_t at, std::string text, std::string remedy) {
        diagnostics_.add({base::Severity::warning,
                          base::codes::job_file,
                          {ini_.file, at, at + static_cast<std::uint32_t>(where.size())},
                          std::move(text),
                          std::move(remedy),
                          {},
                          {}});
    }

    TableLines lines_;
    LinuxcncIni& ini_;
    base::Diagnostics& diagnostics_;
    std::set<std::string, std::less<>> seen_;
    std::string section_;
    bool hidden_ = true;  ///< before the first section, and in one that is there a second time
};

void IniReader::line(const TableLine& text) {
    const std::string_view s = base::trim(text.text);
    if (s.empty() || s[0] == '#' || s[0] == ';') return;
    const std::uint32_t at = text.at + static_cast<std::uint32_t>(s.data() - text.text.data());
    if (s[0] == '[') return section(s, at);
    const std::size_t equals = s.find('=');
    if (equals == std::string_view::npos || equals == 0)
        return warning(s, at, "this line is no section, key or comment", "a key is written KEY = value");
    entry(s, at, equals);
}

void IniReader::section(std::string_view text, std::uint32_t at) {
    const std::size_t shut = text.find(']');
    hidden_ = true;
    if (shut == std::string_view::npos) return warning(text, at, "a section name without ]", "write [SECTION]");
    section_ = base::as_utf8(text.substr(1, shut - 1));
    hidden_ = !seen_.insert(section_).second;
    if (hidden_)
        warning(text.substr(0, shut + 1), at, "section [" + section_ + "] is already there",
                "LinuxCNC sees the first one only: put the keys together");
}

void IniReader::entry(std::string_view text, std::uint32_t at, std::size_t equals) {
    IniEntry e;
    e.section = section_;
    e.key = base::as_utf8(base::trim(text.substr(0, equals)));
    const std::string_view first = base::trim(text.substr(equals + 1));
    const auto offset = first.empty() ? equals + 1 : static_cast<std::size_t>(first.data() - text.data());
    e.where = {ini_.file, at + static_cast<std::uint32_t>(offset),
               at + static_cast<std::uint32_t>(offset + first.size())};
    std::string value(first);
    while (value.ends_with('\\') && !lines_.done()) {
        value.pop_back();
        value += lines_.take().text;
        while (!value.empty() && base::is_blank(value.back())) value.pop_back();
    }
    e.value = base::as_utf8(base::trim(value));
    if (!hidden_) ini_.entries.push_back(std::move(e));
}

class Settings {
public:
    Settings(const LinuxcncIni& ini, base::Diagnostics& diagnostics) : ini_(ini), diagnostics_(diagnostics) {}

    [[nodiscard]] LinuxcncSettings read();

private:
    void complain(const IniEntry& e, std::string text) {
        diagnostics_.add({base::Severity::error,
                          base::codes::job_value,
                          e.where,
                          "[" + e.section + "]" + e.key + ": " + std::move(text),
                          {},
                          {},
                          {}});
    }
    [[nodiscard]] std::string text(std::string_view section, std::string_view key) const {
        const IniEntry* e = find(ini_, section, key);
        return e == nullptr ? std::string() : e->value;
    }
    [[nodiscard]] double number(std::string_view section, std::string_view key, double otherwise);
    [[nodiscard]] bool on(std::string_view section, std::string_view key, bool otherwise);
    [[nodiscard]] double mm_per_unit();
    void switches(LinuxcncSettings& s);
    void axes(LinuxcncSettings& s);

    const LinuxcncIni& ini_;
    base::Diagnostics& diagnostics_;
};

double Settings::number(std::string_view section, std::string_view key, double otherwise) {
    const IniEntry* e = find(ini_, section, key);
    if (e == nullptr) return otherwise;
    if (const auto v = base::parse_double(e->value)) return *v;
    complain(*e, "the value must be a number");
    return otherwise;
}

bool Settings::on(std::string_view section, std::string_view key, bool otherwise) {
    const IniEntry* e = find(ini_, section, key);
    if (e == nullptr) return otherwise;
    for (const std::string_view yes : {"1", "YES", "TRUE", "ON", "Y"})
        if (base::equals_ignoring_case(e->value, yes)) return true;
    for (const std::string_view no : {"0", "NO", "FALSE", "OFF", "N"})
        if (base::equals_ignoring_case(e->value, no)) return false;
    complain(*e, "the value must be 0 or 1");
    return otherwise;
}

double Settings::mm_per_unit() {
    const IniEntry* e = find(ini_, "TRAJ", "LINEAR_UNITS");
    if (e == nullptr) {
        diagnostics_.add({base::Severity::note,
                          base::codes::assumption,
                          {ini_.file, 0, 0},
                          "[TRAJ]LINEAR_UNITS is not there: mm is assumed",
                          {},
                          {},
                          {}});
        return 1;
    }
    for (const std::string_view name : {"mm", "metric"})
        if (base::equals_ignoring_case(e->value, name)) return 1;
    for (const std::string_view name : {"in", "inch", "imperial"})
        if (base::equals_ignoring_case(e->value, name)) return 25.4;
    const double per_mm = base::parse_double(e->value).value_or(0);
    if (per_mm == 1) return 1;
    if (std::abs(per_mm * 25.4 - 1) < 1e-6) return 25.4;
    complain(*e, "the unit must be mm or inch");
    return 1;
}

void Settings::switches(LinuxcncSettings& s) {
    const auto bits = base::clipped<unsigned>(number("RS274NGC", "FEATURES", 0), 0, 63);
    const bool old = find(ini_, "RS274NGC", "FEATURES") != nullptr;
    const auto feature = [&](std::string_view key, unsigned bit, bool otherwise) {
        return on("RS274NGC", key, old ? (bits & bit) != 0 : otherwise);
    };
    s.retain_g43 = feature("RETAIN_G43", 1, s.retain_g43);
    s.oword_nargs = feature("OWORD_NARGS", 2, s.oword_nargs);
    s.ini_vars = feature("INI_VARS", 4, s.ini_vars);
    s.hal_pin_vars = feature("HAL_PIN_VARS", 8, s.hal_pin_vars);
    s.no_downcase_oword = feature("NO_DOWNCASE_OWORD", 16, s.no_downcase_oword);
    s.oword_warnonly = feature("OWORD_WARNONLY", 32, s.oword_warnonly);
    s.fanuc_subprograms = !on("RS274NGC", "DISABLE_FANUC_STYLE_SUB", false);
    s.g92_stays = !on("RS274NGC", "DISABLE_G92_PERSISTENCE", false);
    s.random_tool_changer = on("EMCIO", "RANDOM_TOOLCHANGER", false);
    s.spindle_goes_on = on("EMCIO", "TOOL_CHANGE_WITH_SPINDLE_ON", false);
}

void Settings::axes(LinuxcncSettings& s) {
    for (const char letter : std::string_view("XYZABCUVW")) {
        const std::string section = std::string("AXIS_") + letter;
        if (std::none_of(ini_.entries.begin(), ini_.entries.end(),
                         [&](const IniEntry& e) { return e.section == section; }))
            continue;
        const bool rotary = letter >= 'A' && letter <= 'C';
        const double unit = rotary ? 1 : s.mm_per_unit;
        IniAxis axis;
        axis.letter = letter;
        axis.low = unit * number(section, "MIN_LIMIT", axis.low);
        axis.high = unit * number(section, "MAX_LIMIT", axis.high);
        axis.max_velocity = unit * number(section, "MAX_VELOCITY", axis.max_velocity);
        s.axes.push_back(axis);
    }
}

LinuxcncSettings Settings::read() {
    LinuxcncSettings s;
    s.mm_per_unit = mm_per_unit();
    s.tool_table = text("EMCIO", "TOOL_TABLE");
    s.parameter_file = text("RS274NGC", "PARAMETER_FILE");
    s.startup_code = text("RS274NGC", "RS274NGC_STARTUP_CODE");
    if (s.startup_code.empty()) s.startup_code = text("EMC", "RS274NGC_STARTUP_CODE");
    s.program_prefix = text("DISPLAY", "PROGRAM_PREFIX");
    const std::string path = text("RS274NGC", "SUBROUTINE_PATH");
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find(':', begin), path.size());
        if (end > begin) s.subroutine_path.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    switches(s);
    s.arc_tolerance_mm = std::max(0.001, number("RS274NGC", "CENTER_ARC_RADIUS_TOLERANCE_MM", s.arc_tolerance_mm));
    s.arc_tolerance_inch =
        std::max(0.00004, number("RS274NGC", "CENTER_ARC_RADIUS_TOLERANCE_INCH", s.arc_tolerance_inch));
    axes(s);
    return s;
}

}  // namespace

LinuxcncIni read_linuxcnc_ini(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    LinuxcncIni ini;
    ini.file = file;
    IniReader(sources[file].text, ini, diagnostics).read();
    return ini;
}

const IniEntry* find(const LinuxcncIni& ini, std::string_view section, std::string_view key, std::size_t which) {
    for (const IniEntry& e : ini.entries)
        if (e.section == section && e.key == key && which-- == 0) return &e;
    return nullptr;
}

std::optional<double> ini_number(const LinuxcncIni& ini, std::string_view section, std::string_view key) {
    const IniEntry* e = find(ini, base::to_upper(section), base::to_upper(key));
    return e == nullptr ? std::nullopt : base::parse_double(e->value);
}

LinuxcncSettings settings_of(const LinuxcncIni& ini, base::Diagnostics& diagnostics) {
    return Settings(ini, diagnostics).read();
}

}  // namespace obrys::shop
