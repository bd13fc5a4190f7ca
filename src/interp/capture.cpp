#include "interp/capture.hpp"

#include <utility>

namespace obrys::interp {

std::optional<std::vector<Captured>> Looked::said(Saying& run, const std::string& of) && {
    say(run, complaints_, of);
    if (run.stopped || !ended_) return std::nullopt;
    return std::move(elements_);
}

}  // namespace obrys::interp
