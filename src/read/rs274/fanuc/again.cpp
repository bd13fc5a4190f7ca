/// Pieces of a program read anew, as the control reads them in the state in which the run comes to them.

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Modes;
using program::ModeSet;
using program::PieceRead;

namespace {

/// Of one mode, in the control's words.
std::string mode_text(const FanucControl& control, Mode m, const Modes& modes) {
    const std::int32_t v = modes[static_cast<std::size_t>(m)];
    const auto code = [](int tenths) { return "G" + base::shortest(tenths / 10.0); };
    const auto either = [&](const char* on, const char* off) { return std::string(v != 0 ? on : off); };
    const bool system_a = control.is_lathe() && control.system == dialect::rs274::GSystem::a;
    switch (m) {
        case Mode::inch: return v < 0 ? "no unit that the text says" : either("G20", "G21");
        case Mode::per_rev: return system_a ? either("G99", "G98") : either("G95", "G94");
        case Mode::incremental: return either("G91", "G90");
        case Mode::polar: return either("G16", "G15");
        case Mode::plane: return "G" + std::to_string(v);
        case Mode::hole:
        case Mode::back_bore:
            return modes[static_cast<std::size_t>(Mode::hole)] == 0 ? std::string("no hole cycle")
                                                                    : code(modes[static_cast<std::size_t>(Mode::hole)]);
        case Mode::turning: return v == 0 ? std::string("no cycle") : code(v);
        case Mode::rigid: return either("M29", "no M29");
        case Mode::to_clearance: return either("G99", "G98");
        case Mode::corner_waits: return either("a corner that waits for this block", "no corner before it");
        case Mode::surface: return v == 0 ? "G13.1" : v == 1 ? "G12.1" : "G7.1";
        case Mode::transformed: return either("G68, G51, G51.1 or G68.2", "no G68, G51, G51.1 or G68.2");
        default: return either("another motion or cycle", "no such motion or cycle");
    }
}

class FanucAgain : public program::ReadAgain {
public:
    explicit FanucAgain(const FanucState& s) : control_(s.control), c_is_axis_(s.c_is_axis), draws_(s.draws) {}

    [[nodiscard]] PieceRead read(const program::Unit& unit, std::uint32_t statement, const program::ModeUse& use,
                                 const Modes& modes, const base::Sources& sources, program::Names& names,
                                 base::Diagnostics& diagnostics) const override {
        const program::Statement& at = unit.statements[statement];
        constexpr std::uint16_t longest_known = 0xFFFF;
        if (at.length == longest_known) return {};
        static_cast<void>(sources.text(unit.span(at)));  // it may have been laid aside
        FanucState s(unit.file, control_, names, diagnostics, sources);
        s.system = system_parameter;
        s.whole_number_said = s.corner_said = true;
        s.c_is_axis = c_is_axis_;
        s.draws = draws_;
        s.part = &s.parts.emplace_back(s.file, s.variant, s.names, s.diagnostics, s.text);
        s.unit().name = unit.name;
        s.modes.begin_program(modes);
        read_fanuc_block(s, at.begin, at.begin + at.length);
        if (use.piece >= s.modes.pieces().size() || s.failed) return {};
        const Piece piece = s.modes.pieces()[use.piece];
        program::Unit& read = s.unit();
        if (piece.last < read.statements.size()) {
            read.words.resize(read.statements[piece.last].first);
            read.statements.resize(piece.last);
        }
        return {std::make_unique<const program::Unit>(std::move(read)), piece.first, {}};
    }

    [[nodiscard]] std::string difference(const Modes& text, const Modes& run, ModeSet among) const override {
        const ModeSet found = program::different(text, run, among);
        const auto first = static_cast<Mode>(std::countr_zero(found == 0 ? among : found));
        return "the block stands in the text behind " + mode_text(control_, first, text) + ", but is run while " +
               mode_text(control_, first, run) + " is in force";
    }

private:
    FanucControl control_;
    bool c_is_axis_ = false, draws_ = false;
};

}  // namespace

Modes modes_at_start(const FanucControl& control) {
    Modes m{};
    const auto set = [&](Mode mode, std::int32_t v) { m[static_cast<std::size_t>(mode)] = v; };
    set(Mode::inch, -1);
    set(Mode::per_rev, control.is_lathe() ? 1 : 0);
    set(Mode::plane, control.is_lathe() ? 18 : 17);
    set(Mode::surface_plane, 18);
    set(Mode::motion, static_cast<std::int32_t>(Modal::rapid));
    return m;
}

std::shared_ptr<const program::ReadAgain> reader_of_pieces(const FanucState& s) {
    return std::make_shared<FanucAgain>(s);
}

}  // namespace obrys::read::rs274
