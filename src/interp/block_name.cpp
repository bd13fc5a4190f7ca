/// What messages call a block, and the loop that is being run.

#include "interp/say.hpp"

namespace obrys::interp {

std::string block_name(const Saying& run, const base::Span& at) {
    const auto number = run.env.sources.block_number(at.file, at.begin);
    return number ? "N" + std::to_string(*number)
                  : "line " + std::to_string(run.env.sources.position(at.file, at.begin).line);
}

std::string loop_being_run(const Saying& run) {
    for (auto act = run.calls.rbegin(); act != run.calls.rend(); ++act) {
        const Activation::Passes* most = nullptr;
        for (const Activation::Passes& p : act->passes)
            if (p.target < act->pc && act->pc <= p.statement + 1 && p.count >= passes_between_looks &&
                (most == nullptr || p.count > most->count))
                most = &p;
        if (most == nullptr) continue;
        return "the loop of " + block_name(run, act->unit->span(act->unit->statements[most->target])) + " had run " +
               std::to_string(most->count) + " passes";
    }
    return {};
}

}  // namespace obrys::interp
