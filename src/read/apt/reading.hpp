#pragma once
/// Test side only: cutter locations read, with everything that belongs to them.

#include <cmath>
#include <string>

#include "base/diagnostic.hpp"
#include "program/tree_text_testing.hpp"
#include "read/apt/read.hpp"

namespace obrys::read::apt::testing {

struct Reading {
    explicit Reading(std::string text, std::string name = "test.apt") {
        file = sources.add(std::move(name), std::move(text));
        unit = read(file, sources, names, diagnostics);
    }
    [[nodiscard]] std::string tree() const { return program::testing::TreeText(unit, names).all(); }
    /// line:column text of the complaints, one a line.
    [[nodiscard]] std::string messages() const {
        std::string out;
        for (const base::Diagnostic& d : diagnostics.all()) {
            const base::Position at = sources.position(d.where);
            out += std::to_string(at.line) + ":" + std::to_string(at.column) + " " + d.text + "\n";
        }
        return out;
    }
    /// What is known and not run, with the reason, one a line.
    [[nodiscard]] std::string problems() const {
        std::string out;
        for (const program::Problem& p : unit.problems) out += p.text + ": " + p.reason + "\n";
        return out;
    }

    base::Sources sources;
    program::Names names;
    base::Diagnostics diagnostics;
    std::uint32_t file = 0;
    program::Unit unit;
};

/// The literals of the last statement with this code, else NaN.
inline double value(const Reading& r, program::Code code) {
    const auto last = static_cast<std::uint32_t>(r.unit.statements.size() - 1);
    for (std::uint32_t i = r.unit.statements[last].first; i < r.unit.words_end(last); ++i)
        if (program::code_of(r.unit.words[i]) == code) return r.unit.literal(r.unit.words[i]);
    return NAN;
}
inline bool has_modal(const Reading& r, program::Modal m) {
    for (const program::Word& w : r.unit.words)
        if (program::code_of(w) == program::Code::modal && program::modal_of(w) == m) return true;
    return false;
}

}  // namespace obrys::read::apt::testing
