#pragma once
/// Test side only: a word put into a block of a program, and what comes out with and without it. What may stay without
/// either stands in `silent`, with its reason.

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "cl/text.hpp"
#include "driver/session.hpp"
#include "shop/files/obrys/machine_file.hpp"

namespace obrys::driver::testing {

/// How the programs of a control are written for this test.
struct Way {
    std::string_view control, file;
    std::string_view before, after;  ///< the blocks around; `after` lets words act that wait for a later block
    std::vector<std::string_view> blocks;
    std::vector<std::string_view> words;
    shop::MachineKind machine = shop::MachineKind::mill;
    std::vector<std::string_view> passed_over{};  ///< words that the control itself passes over in all these blocks
    bool every_line = false;  ///< a word is put into every line of a block, not into its last one alone
};

/// A word that does nothing here and rightly so.
struct Silent {
    std::string_view control, block, word;  ///< empty: every one; `block` and `word` are the text they begin with
    std::string_view reason;
};

inline constexpr Silent silent[] = {
    {"fanuc", "G81", "P7", "kept for the next cycle of the series"},
    {"haas", "G81", "P7", "kept for the next cycle of the series"},
    {"", "G85", "P7", "kept for the next cycle of the series"},
    {"", "G86", "P7", "kept for the next cycle of the series"},
    {"", "G98 G81", "P7", "kept for the next cycle of the series"},
    {"", "X9.", "P7", "kept for the next cycle of the series"},
    {"", "G31", "P7", "which signal ends the move; where it ends is not known either way"},
    {"", "G50.1 X0.", "Y7", "ends a mirror image that is not there"},
    {"", "G50.1 X0.", "Z7", "ends a mirror image that is not there"},
    {"", "G31", "E7", "the block says that it is not simulated"},
    {"", "G31", "L2", "the block says that it is not simulated"},
    {"", "M19", "S7", "how the spindle turns to its angle"},
    {"", "M19", "P7", "how the spindle turns to its angle"},
    {"", "M19", "R7", "how the spindle turns to its angle"},
    {"haas", "G103", "", "a code without effect on the path, and its words"},
    {"", "N10 G0", "S7", "of a contour: acts in G70 alone (docs/dialects/fanuc.md)"},
    {"", "N10 G0", "T0202", "of a contour: acts in G70 alone (docs/dialects/fanuc.md)"},
    {"", "N10 G0", "F.7", "of a contour: acts in G70 alone (docs/dialects/fanuc.md)"},
    {"", "N15 G1", "S7", "of a contour: acts in G70 alone (docs/dialects/fanuc.md)"},
    {"", "N20 ", "S7", "of a contour: acts in G70 alone (docs/dialects/fanuc.md)"},
    {"", "N15 G1", "F.7", "of a contour: acts in G70 alone (docs/dialects/fanuc.md)"},
    {"", "N20 ", "F.7", "of a contour: acts in G70 alone (docs/dialects/fanuc.md)"},
    {"", "G50 ", "V7.", "an axis that this lathe has not, and no block moves: one that does is said"},
    {"", "G50 ", "Y7.", "an axis that this lathe has not, and no block moves: one that does is said"},
    {"sinumerik-840d", "TRANS Z1", "Y7", "an axis that this lathe has not, and no block moves: one that does is said"},
    {"sinumerik-840d", "ATRANS X1", "Y7", "an axis that this lathe has not, and no block moves: one that does is said"},
    {"sinumerik-840d", "G42 X30", "FRC=7", "acts at a chamfer or rounding, and here is none"},
    {"linuxcnc", "G10 L1", "", "data of the tool, which act when it is taken next"},
    {"linuxcnc", "G43.1", "", "the offset of an axis that no block moves"},
    {"", "G10 L2", "L2", "what it says already"},
    {"fanuc", "G49", "H2", "the length ends, whatever H says"},
    {"haas", "G49", "H2", "the length ends, whatever H says"},
    {"fanuc", "", "D2", "kept for the next G41 or G42"},
    {"haas", "", "D2", "kept for the next G41 or G42"},
    {"", "M98 P1000", "", "the program called is not there"},
    {"linuxcnc", "G92", "", "where these axes stand is not known before their first move"},
    {"linuxcnc", "G64", "Q7", "a path mode: the stream of moves is the programmed path"},
    {"linuxcnc", "M66", "", "what an input waits for and when; its value is unknown either way"},
    {"linuxcnc", "M19", "", "how the spindle turns to its angle"},
    {"sinumerik-840d", "", "M1=3", "in force already"},
    {"sinumerik-840d", "", "ADIS", "acts with G641"},
    {"sinumerik-840d", "", "DISC", "acts with G450 at a corner under compensation"},
    {"sinumerik-840d", "", "FA[", "acts with POS"},
    {"sinumerik-840d", "", "FRCM", "acts at a rounding that follows"},
    {"sinumerik-840d", "SUPA", "", "the block says that where it ends is not known"},
    {"heidenhain-itnc530", "", "R0", "in force already"},
    {"heidenhain-itnc530", "", "M3", "in force already"},
    {"heidenhain-itnc530", "", "M98", "acts on a corner under compensation, where there is none"},
    {"heidenhain-itnc530", "", "G90", "in force already"},
    {"heidenhain-itnc530", "", "G01", "in force already, or the block's own"},
    {"heidenhain-itnc530", "", "I+7", "a circle centre, for arcs that follow"},
    {"heidenhain-itnc530", "", "J+7", "a circle centre, for arcs that follow"},
    {"heidenhain-itnc530", "", "K+7", "a circle centre, for arcs that follow"},
    {"heidenhain-itnc530", "L Z+50 FMAX M91", "", "the block says that where it ends is not known"},
    {"heidenhain-itnc530", "TOOL CALL", "DR", "acts with radius compensation"},
    {"heidenhain-itnc530", "L X+9 Y+9 RL", "RL", "in force already"},
};

inline bool begins(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

inline bool may_be_silent(const Way& way, std::string_view block, std::string_view word) {
    const auto& over = way.passed_over;
    if (std::find(over.begin(), over.end(), word) != over.end()) return true;
    return std::any_of(std::begin(silent), std::end(silent), [&](const Silent& s) {
        return (s.control.empty() || way.control == s.control) && begins(block, s.block) && begins(word, s.word);
    });
}

/// All that comes out of a program, without the places; `ends`: whether it runs to its end.
inline std::string outcome(const Way& way, std::string_view block, bool* ends = nullptr) {
    Session s;
    const std::string text = std::string(way.before) + std::string(block) + "\n" + std::string(way.after);
    const Control* control = find_control(std::string(way.control));
    const auto file = s.sources.add(std::string(way.file), text, language_of(*control, text, way.file).numbers);
    s.programs = std::make_unique<Programs>(*control, s.sources, s.diagnostics);
    s.job.machine.kind = way.machine;
    const bool lathe = way.machine == shop::MachineKind::lathe;
    if (lathe) {
        s.job.machine = *shop::shipped_machine("lathe-generic");
        s.programs->set_machine(&s.job.machine);
    }
    s.main = s.programs->read(file);
    std::string out;
    if (s.main == nullptr) return out + "no program";
    for (const std::uint32_t number : {1U, 2U, 3U}) {
        shop::Tool tool;
        tool.number = number;
        tool.kind = lathe ? shop::ToolKind::turning : shop::ToolKind::end_mill;
        tool.radius = tool.nose_radius = number;
        tool.length = 100 + 10 * number;
        s.job.tools.push_back(tool);
    }
    const auto end = interpret(s, [&](const cl::Record& r) {
        const std::string line = cl::to_text(r);
        out += line.substr(0, line.find(" @")) + "\n";
    });
    if (ends != nullptr) *ends = end.ending == interp::Ending::regular;
    for (const auto& p : end.parameters) out += p.name + "=" + std::to_string(p.value) + "\n";
    for (const base::Diagnostic& d : s.diagnostics.all()) out += d.text + "\n";
    for (const program::Ignored& i : s.main->ignored) out += i.text + "\n";
    return out;
}

/// The lines of the block, as where each of them ends.
inline std::vector<std::size_t> line_ends(const Way& way, std::string_view block) {
    std::vector<std::size_t> ends;
    for (std::size_t at = block.find('\n'); way.every_line && at != block.npos; at = block.find('\n', at + 1))
        ends.push_back(at);
    ends.push_back(block.size());
    return ends;
}

inline std::string without_effect(const Way& way) {
    std::string found;
    for (const std::string_view block : way.blocks) {
        bool ends = false;
        const std::string plain = outcome(way, block, &ends);
        EXPECT_TRUE(ends) << "a block that shows nothing, since it stops the run: " << block << "\n" << plain;
        std::size_t begin = 0;
        for (const std::size_t end : line_ends(way, block)) {
            const std::string_view line = block.substr(begin, end - begin);
            begin = end + 1;
            for (const std::string_view word : way.words) {
                std::string with(block);
                with.insert(end, " " + std::string(word));
                if (!may_be_silent(way, line, word) && outcome(way, with) == plain)
                    found += std::string(block) + "   " + std::string(word) +
                             (line == block ? "" : " in " + std::string(line)) + "\n";
            }
        }
    }
    return found;
}

inline const std::vector<std::string_view> letters{"A7", "B7", "C7", "D2", "E7", "F7", "H2", "I7", "J7", "K7", "L2",
                                                   "P7", "Q7", "R7", "S7", "T2", "U7", "V7", "W7", "X7", "Y7", "Z7"};

}  // namespace obrys::driver::testing
