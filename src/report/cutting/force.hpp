#pragma once
/// Forces of a program's milled moves as text and JSON. What is not known is said, and null.

#include <string>
#include <vector>

#include "base/source.hpp"
#include "check/force/findings.hpp"
#include "check/force/milled.hpp"

namespace obrys::report::cutting {

struct ForceSubject {
    const base::Sources& sources;
    const check::Result& result;
    const check::Setup& setup;
    const shop::CuttingJob& job;
    std::string name, control;
    std::string material;                ///< for people; empty: not known
    std::vector<std::string> not_whole;  ///< why it is not all of the program
    bool feed_is_programmed = false;     ///< and not as planned
    check::force::ForceResult forces;
    std::vector<check::force::ForceFinding> findings;
};

[[nodiscard]] bool is_whole(const ForceSubject& subject);
struct ForceOptions {
    std::size_t lines = 10;  ///< of those with the largest forces
};
[[nodiscard]] std::string as_text(const ForceSubject& subject, const ForceOptions& options);
[[nodiscard]] std::string as_json(const ForceSubject& subject);

}  // namespace obrys::report::cutting
