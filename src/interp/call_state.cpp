#include "interp/call_state.hpp"

namespace obrys::interp {

void CallState::have_own_variables() {
    Scope::Copies copies;
    globals.have_own(copies);
    for (Activation& call : calls) call.locals.have_own(copies);
}

}  // namespace obrys::interp
