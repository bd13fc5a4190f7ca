/// What a program reads of the control: the tool in the spindle, the tool table, what is programmed.

#include "rewrite/writing.hpp"

namespace obrys::rewrite {

using program::SystemVariable;

namespace {

struct Datum {
    SystemVariable variable;
    std::string_view key;
    bool of_tool = false;  ///< of the tool whose number is its index; 0: the one in the spindle
};
constexpr std::array data{
    Datum{SystemVariable::tool_number, "system.tool-number"},
    Datum{SystemVariable::active_radius, "system.tool-radius"},
    Datum{SystemVariable::tool_radius, "system.tool-radius"},
    Datum{SystemVariable::tool_edge, "system.tool-edge"},
    Datum{SystemVariable::feed, "system.feed"},
    Datum{SystemVariable::spindle_speed, "system.spindle-speed"},
    Datum{SystemVariable::table_length, "system.table-length", true},
    Datum{SystemVariable::table_radius, "system.table-radius", true},
    Datum{SystemVariable::table_corner_radius, "system.table-corner-radius", true},
    Datum{SystemVariable::table_delta_length, "system.table-delta-length", true},
    Datum{SystemVariable::table_delta_radius, "system.table-delta-radius", true},
    Datum{SystemVariable::table_delta_corner, "system.table-delta-corner", true},
};

}  // namespace

/// The number of the tool that a datum of the table is asked of.
std::optional<Text> Writing::tool_of(const Expr& e) {
    const std::string* in_spindle = language.find("system.tool-number");
    Text tool = e.count > 0 ? value(unit->children[e.b]) : number_text(0);
    if (tool.number != 0.0) return tool;
    if (in_spindle == nullptr) return std::nullopt;
    return Text{*in_spindle, Level::atom, std::nullopt};
}

Text Writing::system(const Expr& e, ExprId id) {
    const auto variable = static_cast<SystemVariable>(e.op);
    if (variable == SystemVariable::pi) return number_text(3.14159265358979323846);
    for (const Datum& d : data) {
        const std::string* form = d.variable == variable ? language.find(d.key) : nullptr;
        if (form == nullptr || (!d.of_tool && e.count > 0)) continue;
        const auto tool = d.of_tool ? tool_of(e) : Text{};
        if (!tool) break;
        if (form->find("{to}") == std::string::npos)
            return {filled(*form, {{"tool", tool->text}}), Level::atom, std::nullopt};
        const Text to = place_for(id);  // a block of its own: FN 18
        say(filled(*form, {{"to", to.text}, {"tool", tool->text}}));
        return to;
    }
    refuse(span(id), source(span(id)) + " is not translated by structure");
    return number_text(0);
}

}  // namespace obrys::rewrite
