/// What radius compensation does not survive on controls where it keeps its side and its plane; where it was begun.

#include <string>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/setup/setup.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;

/// RR behind RL: at least one straight block without compensation has to stand between them (iTNC 530 manual, 5.3).
void refuse_other_side(Reckoning& run, Modal m) {
    const Modal now = run.modal.compensation;
    if (!run.traits->compensation_keeps_side || run.capture != nullptr) return;
    if (now == Modal::compensation_off || m == Modal::compensation_off || m == now) return;
    alarm(run, base::codes::compensation, run.here(),
          "radius compensation changes its side without being switched off in between",
          "program a straight block without radius compensation (R0; DIN/ISO: G40) before it");
}

/// R+ and R- lengthen and shorten the way of a block of a single axis. In a contour with RL or RR they are another
/// compensation, which wants a block without one before it (iTNC 530 manual DIN/ISO 606 42x-03, page 205).
void compensate_along_axis(Moving& run, Modal m) {
    run.modal.paraxial = m;
    if (run.modal.compensation != Modal::compensation_off && run.capture == nullptr)
        return alarm(run, base::codes::compensation, run.here(),
                     "compensation along an axis, longer or shorter, while radius compensation is in force",
                     "program a straight block without radius compensation (R0; DIN/ISO: G40) before it");
    if (run.block.paraxial != Modal::linear) {
        run.block.paraxial = m;
        return;
    }
    unchecked(run, base::codes::unsupported, run.here(),
              "longer or shorter by the tool's radius is a block of a single axis: this one is run without that",
              "program the axis alone, without a path function (DIN/ISO: with G07)");
}

void leave_compensation(Telling& run, const std::string& because) {
    ModalState& state = run.modal;
    if (!run.traits->compensation_keeps_side || run.capture != nullptr || state.compensation == Modal::compensation_off)
        return;
    if (state.look_ahead == 0)
        return alarm(run, base::codes::compensation, run.here(), because + " while radius compensation is in force",
                     "switch it off before (R0; DIN/ISO: G40)");
    // iTNC 530 manual, "The PLANE function": with M120 active it rescinds radius compensation, and M120 with it.
    flush_path(run);
    switch_compensation_off(run);
    state.look_ahead = 0;
}

void note_compensation(Telling& run, Modal m) {
    const Unit& unit = run.unit();
    const base::Span here = run.here();
    for (CarriedCompensation& c : run.carried)
        if (c.until == CarriedCompensation{}.until && c.change.file == here.file && c.change.begin < here.begin)
            c.until = here.begin;
    if (run.modal.compensation == m) return;  // said again
    run.modal.compensation_word = here;
    const auto index = static_cast<std::uint32_t>(run.statement - unit.statements.data());
    for (std::uint32_t w = run.statement->first; w < unit.words_end(index); ++w)
        if (program::code_of(unit.words[w]) == program::Code::modal && program::modal_of(unit.words[w]) == m)
            run.modal.compensation_word = unit.span(*run.statement, unit.words[w]);
}

std::string compensation_in_force(const Reckoning& run) {
    const base::Span at = run.modal.compensation_word;
    const std::string_view text = run.env.sources[at.file].text;
    const std::string word = base::to_upper(base::trim(text.substr(at.begin, at.end - at.begin)));
    return word + " of " + block_name(run, at);
}

void say_carried_compensation(Telling& run) {
    if (run.modal.compensation == Modal::compensation_off || run.capture != nullptr) return;
    const std::string word = compensation_in_force(run);
    assume(run, run.here(),
           word + " is still in force while the tool is changed: it goes on with the new tool's radius",
           "switch it off before the change, where the contour ends");
    run.carried.push_back({run.here(), CarriedCompensation{}.until, word});
}

void switch_compensation_off(Telling& run) {
    run.modal.compensation = Modal::compensation_off;
    run.path->tell_end(run);
}

}  // namespace obrys::interp
