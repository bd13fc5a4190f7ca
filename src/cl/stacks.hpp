#pragma once
/// Call stacks of a run, shared: a record carries one number, equal stacks have equal numbers.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/source.hpp"
#include "cl/record.hpp"

namespace obrys::cl {

class CallStacks {
public:
    /// The stack that has `site` on top of `below`.
    StackId push(StackId below, const base::Span& site);
    /// Call sites, innermost first; empty for the main program.
    [[nodiscard]] std::vector<base::Span> sites(StackId id) const;

private:
    struct Entry {
        StackId below = 0;
        base::Span site;
    };
    std::vector<Entry> entries_{Entry{}};
    std::unordered_map<std::uint64_t, std::vector<StackId>> index_;
};

}  // namespace obrys::cl
