/// What radius compensation does not survive on controls where it keeps its side and its plane.

#include "base/codes.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

/// RR behind RL: at least one straight block without compensation has to stand between them (iTNC 530 manual, 5.3).
void refuse_other_side(Run& run, Modal m) {
    const Modal now = run.modal.compensation;
    if (!run.traits->compensation_keeps_side || run.capture != nullptr) return;
    if (now == Modal::compensation_off || m == Modal::compensation_off || m == now) return;
    alarm(run, base::codes::compensation, run.here(),
          "radius compensation changes its side without being switched off in between",
          "program a straight block without radius compensation (R0, G40) before it");
}

void leave_compensation(Run& run, const std::string& because) {
    ModalState& state = run.modal;
    if (!run.traits->compensation_keeps_side || run.capture != nullptr || state.compensation == Modal::compensation_off)
        return;
    if (state.look_ahead == 0)
        return alarm(run, base::codes::compensation, run.here(), because + " while radius compensation is in force",
                     "switch it off before (R0, G40)");
    // iTNC 530 manual, "The PLANE function": with M120 active it rescinds radius compensation, and M120 with it.
    flush_path(run);
    state.compensation = Modal::compensation_off;
    state.look_ahead = 0;
}

}  // namespace obrys::interp
