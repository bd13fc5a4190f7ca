#pragma once
/// Identifiers of a run, interned: equal names (case ignored) have equal numbers in every program of the run.

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

namespace obrys::program {

using NameId = std::uint32_t;

class Names {
public:
    /// Number of a name; `upper` must be upper case already.
    NameId id(std::string_view upper);
    [[nodiscard]] const std::string& text(NameId id) const { return names_[id]; }

private:
    std::deque<std::string> names_;
    std::unordered_map<std::string_view, NameId> index_;
};

}  // namespace obrys::program
