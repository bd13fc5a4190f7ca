/// A cycle with an infeed of 0.002 mm is run by the control as it is written, for hours: a number without a point that
/// counts increments (FANUC, Haas: 0.001 mm), or a point at the wrong place. What is ordinary work decides by two
/// things: how small the infeed is, and how many moves it makes of the cycle.

#include "interp/moves/small_infeed.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::interp {

namespace {

using cl::CycleRole;

/// mm. Below the first nobody cuts: an edge of a few thousandths pushes the material away instead (finest infeeds of
/// turning and drilling are hundredths). Below the second the point is asked for where most lengths of the program
/// have one and this one has none.
constexpr double finest = 0.01, fine = 0.1;
/// Moves of a cycle: fewer are no sign of a slip (a last infeed that was reckoned may be as small as it likes), and so
/// many are not run.
constexpr std::size_t few_moves = 100, many_moves = 400, most_moves = 4000;

constexpr std::array infeeds{CycleRole::infeed, CycleRole::first_depth, CycleRole::stepover,
                             CycleRole::chip_break_depth};

/// What stands in the text: "U2", its number, and how the control counts it.
struct Written {
    std::string word;
    double number = 0;
    bool bare = false;         ///< whole, without a point
    bool takes_point = false;  ///< it is a length that lacks its point where most others have one
};

Written written_at(const Saying& run, const base::Span& where) {
    Written w;
    const std::string_view text = base::trim(run.env.sources.text(where));
    std::size_t i = 0;
    while (i < text.size() && base::is_letter(text[i])) ++i;
    const std::string_view digits = base::trim(text.substr(i));
    w.bare = i == 1 && !digits.empty() && digits.size() < 9 &&
             std::all_of(digits.begin(), digits.end(), [](char c) { return base::is_digit(c); });
    if (!w.bare) return w;
    w.word = std::string(1, text.front()) + std::string(digits);
    for (const char c : digits) w.number = 10 * w.number + (c - '0');
    const auto& all = run.unit().small_lengths;
    w.takes_point = run.unit().file == where.file && run.unit().lengths_with_point > all.size() &&
                    std::any_of(all.begin(), all.end(),
                                [&](const auto& n) { return n.first >= where.begin && n.second <= where.end; });
    return w;
}

/// A whole number of thousandths of a millimetre, or ten-thousandths of an inch.
bool counts_increments(const Written& w, double mm) {
    constexpr double increments[]{0.001, 0.00254}, slack = 1e-6;
    return w.bare && std::any_of(std::begin(increments), std::end(increments),
                                 [&](double step) { return std::abs(w.number * step - mm) < slack; });
}

std::string what_it_is(CycleRole r) {
    if (r == CycleRole::first_depth) return "a first cut";
    if (r == CycleRole::stepover) return "a step to the side";
    return "an infeed";
}

std::string remedy_for(const Written& w, bool increments) {
    if (!increments) return "see where its decimal point stands";
    if (w.takes_point) return "did you mean " + w.word + ".? write the decimal point";
    return "did you mean " + w.word + "000? it counts increments of the control";
}

/// Of a cycle that is not run there stays how the tool comes to its place and leaves it; false where that is not to be
/// told.
bool keep_ends(cycles::Expansion& e) {
    const auto* last = e.steps.empty() ? nullptr : std::get_if<cl::Linear>(&e.steps.back());
    if (last == nullptr || !last->rapid || e.leads >= e.steps.size()) return false;
    e.steps.erase(e.steps.begin() + static_cast<std::ptrdiff_t>(e.leads), e.steps.end() - 1);
    return true;
}

}  // namespace

base::Span place_of_word(const Saying& run, program::Code code) {
    const program::Unit& unit = run.unit();
    const auto index = static_cast<std::uint32_t>(run.statement - unit.statements.data());
    for (std::uint32_t w = run.statement->first; w < unit.words_end(index); ++w)
        if (program::code_of(unit.words[w]) == code) return unit.span(*run.statement, unit.words[w]);
    return run.here();
}

bool doubt_infeeds(Saying& run, std::string_view name, const cycles::Demand& demand, cycles::Expansion& e,
                   const PlaceOfRole& place) {
    for (const CycleRole role : infeeds) {
        const double v = std::abs(demand.get(role));
        if (!(v > 0 && v < fine)) continue;
        const auto endless = [&](const cycles::Complaint& k) { return k.fatal && (k.too_many || k.role == role); };
        const bool gave_up = std::any_of(e.complaints.begin(), e.complaints.end(), endless);
        const std::size_t moves = gave_up ? cycles::most_steps : e.steps.size();
        const base::Span where = place(role);
        const Written w = written_at(run, where);
        if (moves < (v < finest ? few_moves : many_moves) || (v >= finest && !w.takes_point)) continue;
        const bool increments = counts_increments(w, v);
        const std::string cycle(name), size = base::shortest(v) + " mm";
        doubt(run, base::codes::infeed_implausible, where,
              cycle + ": " +
                  (increments ? w.word + " without a point is " + size + " here" : what_it_is(role) + " of " + size) +
                  ": so small that the cycle makes " + (gave_up ? "more than " : "") + base::shortest(double(moves)) +
                  " moves",
              remedy_for(w, increments));
        if (!gave_up && moves <= most_moves) continue;
        unchecked(run, base::codes::budget, where,
                  cycle + " is not run: so many moves of " + size + " each cannot be meant");
        if (gave_up || !keep_ends(e)) return false;
    }
    return true;
}

}  // namespace obrys::interp
