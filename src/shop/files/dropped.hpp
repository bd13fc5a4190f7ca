#pragma once
/// What an importer does not take from a file: counted by name, said once.

#include <map>
#include <string>

#include "base/diagnostic.hpp"

namespace obrys::shop {

class Dropped {
public:
    void add(const std::string& name, const base::Span& where);
    /// One note (code no-effect) at the first place: "not taken from this file: DOC (3), TIME1 (12)"; none where
    /// nothing was dropped.
    void report(base::Diagnostics& diagnostics) const;

private:
    struct Entry {
        std::size_t count = 0;
        base::Span first;
    };
    std::map<std::string, Entry> names_;
};

/// Adds to what a tool's file does not say: "tool 5: length 0 mm, point angle 118 degrees".
void assume(std::string& assumed, std::string_view what);

}  // namespace obrys::shop
