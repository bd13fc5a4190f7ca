#pragma once
/// A program and what it calls, written for another control statement by statement.

#include <functional>
#include <string>
#include <vector>

#include "base/fate.hpp"
#include "base/source.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"
#include "rewrite/language.hpp"

namespace obrys::rewrite {

using base::Fate;  // expanded: in several statements, or something is taken for granted

struct Note {
    Fate fate = Fate::expanded;
    base::Span from;
    std::string what;      ///< of a lost one: "CHF= is not translated by structure"
    std::string remedy;    ///< may be empty
    std::size_t line = 0;  ///< of the text, from 1; 0: none
};

/// What a parameter or variable is called on the other side.
struct Renamed {
    std::string from, to;
    std::string program;  ///< that has it for itself; empty: all have it in common
};

struct Input {
    const program::Unit* main = nullptr;
    std::function<const program::Unit*(std::string_view)> find;  ///< a program by its name
    const program::Names* names = nullptr;
    const base::Sources* sources = nullptr;
    bool lathe = false;             ///< the machine
    bool diameters = false;         ///< X words are diameters when the run begins
    bool angles_from_zero = false;  ///< arc tangents and arc sines that would be negative are a full turn more
};

struct Rewritten {
    std::string text;
    std::vector<Renamed> names, programs;
    std::vector<Note> notes;
    std::vector<std::pair<std::size_t, base::Span>> lines;  ///< of the text, and where they come from
    [[nodiscard]] bool loses() const;
};

/// `name` is what the main program is called.
[[nodiscard]] Rewritten rewrite(const Input& input, const Language& language, const std::string& name);

}  // namespace obrys::rewrite
