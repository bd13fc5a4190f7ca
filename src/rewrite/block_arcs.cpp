/// What arcs are made about, and what stands at the corners behind elements.

#include <algorithm>

#include "rewrite/block_words.hpp"

namespace obrys::rewrite {

std::string BlockWords::corner(std::string_view key, const Text& given) {
    const std::string* form = w_.language.find(key);
    Text v = given;
    if (!w_.language.computes && !v.number) v = w_.atom(v, program::no_expr);
    if (form == nullptr) {
        w_.refuse(w_.here, "a chamfer or rounding by its word has no counterpart there");
        return {};
    }
    const bool bare = v.number || v.level == Level::atom;
    return filled(*form,
                  {{"value", v.text}, {"bracketed", bare ? v.text : w_.language.open + v.text + w_.language.close}});
}

std::string BlockWords::absolute_centre(const Text& u, const Text& v) {
    const std::string* form = w_.language.find("words.centre-absolute");
    if (form == nullptr) {
        w_.refuse(w_.here, "an arc's centre by its coordinates has no counterpart there");
        return {};
    }
    return filled(*form, {{"u", u.text},
                          {"v", v.text},
                          {"x", spelt("X", u, true)},
                          {"y", spelt("Y", v, true)},
                          {"i", spelt("I", u, true)},
                          {"j", spelt("J", v, true)}});
}

std::string BlockWords::centre_text() {
    const std::string* names = w_.language.find("words.centre");
    if (radius_) {
        const std::string* form = w_.language.find("words.radius");
        if (form == nullptr) return w_.refuse(w_.here, "an arc by its radius has no counterpart there"), "";
        Text v = *radius_;
        if (!w_.language.computes && !v.number) v = w_.atom(v, program::no_expr);
        const bool bare = v.number || v.level == Level::atom;
        return filled(*form, {{"value", v.text},
                              {"bracketed", bare ? v.text : w_.language.open + v.text + w_.language.close},
                              {"signed", (v.text[0] == '-' ? "" : "+") + v.text}});
    }
    std::string out;
    if (!centre_counts_on_) {
        if (centre_.size() == 2 && centre_[0].first == 0 && centre_[1].first == 1)
            return absolute_centre(centre_[0].second, centre_[1].second);
        return w_.refuse(w_.here, "an arc's centre by coordinates is translated with I=AC and J=AC"), "";
    }
    for (const auto& [i, v] : centre_) {
        const std::string letter =
            names != nullptr && names->size() >= 6 ? names->substr(i * 2, 2) : std::string(1, "IJK"[i]);
        out += (out.empty() ? "" : " ") + spelt(letter, v, true);
    }
    // Where a centre is a pole, a coordinate that is left out is not 0 but that of the last one.
    for (std::size_t i = 0; names != nullptr && names->size() >= 6 && i < 2; ++i) {
        const bool said = std::any_of(centre_.begin(), centre_.end(), [&](const auto& c) { return c.first == i; });
        if (!said) out += (out.empty() ? "" : " ") + spelt(names->substr(i * 2, 2), w_.number_text(0), true);
    }
    return out;
}

/// Where its coordinates are no numbers, they are held: what they are computed from may change before the arc.
void BlockWords::pole() {
    if (axes_.size() != 2 || axes_[0].letter != 'X' || axes_[1].letter != 'Y' ||
        axes_[0].incremental != axes_[1].incremental)
        return w_.refuse(w_.here,
                         "a pole is translated by structure where both its coordinates are given in X and Y, absolute "
                         "or both as increments");
    const auto hold = [&](const Text& v, const char* wanted) {
        if (v.number) return v;
        const auto name = w_.naming.keeper(*w_.unit, wanted);
        if (!name) w_.refuse(w_.here, "there is no parameter left for the pole");
        const Text to{name.value_or("0"), Level::atom, std::nullopt};
        if (name) w_.assign(to, v);
        return to;
    };
    const auto number =
        static_cast<std::size_t>(std::find(w_.programs.begin(), w_.programs.end(), w_.unit) - w_.programs.begin());
    const int place = place_number(number, w_.at);
    const Text u = hold(axes_[0].value, "POLE_X"), v = hold(axes_[1].value, "POLE_Y");
    (axes_[0].incremental ? w_.pole_increments : w_.poles)[place] = {u, v};
}

/// A pole that counts on from where the tool stands is the centre of the arc in the next block, whose centre counts
/// from there as well.
void BlockWords::take_increments_of_pole() {
    const int said = about_pole_ ? w_.held()[Mode::pole] : -1;
    const auto found = w_.pole_increments.find(said);
    if (said < 0 || found == w_.pole_increments.end()) return;
    const StatementPlace place = place_of(said);
    const bool next = w_.programs[place.program] == w_.unit && place.statement + 1 == w_.at &&
                      !w_.graphs.at(w_.unit).jumped_to.contains(w_.at);
    if (!next) return;
    about_pole_ = false;
    centre_counts_on_ = true;
    centre_ = {{0, found->second.first}, {1, found->second.second}};
}

std::optional<std::string> BlockWords::pole_text() {
    const int said = w_.held()[Mode::pole];
    const auto found = w_.poles.find(said);
    const bool foreign = said >= 0 && w_.programs[place_of(said).program] != w_.unit;
    if (said < 0 || found == w_.poles.end() ||
        (foreign && !(found->second.first.number && found->second.second.number))) {
        if (w_.pole_increments.contains(said)) {
            w_.refuse(w_.here,
                      "the pole counts on from where the tool stood at its block: it is translated by structure for "
                      "the arc in the block behind it alone",
                      "write CC with its coordinates");
            return std::nullopt;
        }
        w_.refuse(w_.here,
                  said == several ? "which pole is in force here depends on the way that the run has come"
                                  : "the pole of this arc is not said before it",
                  "write CC before the arc");
        return std::nullopt;
    }
    return absolute_centre(found->second.first, found->second.second);
}

}  // namespace obrys::rewrite
