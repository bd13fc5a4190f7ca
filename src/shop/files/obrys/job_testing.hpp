#pragma once
/// Shared by the tests of this room: a job text and its complaints.

#include <string>

#include "shop/files/obrys/job_file.hpp"
#include "shop/reading_testing.hpp"

namespace obrys::shop {

inline std::string job_complaints(const std::string& text) {
    Reading r;
    (void)read_job(r.add(text), r.sources, r.diagnostics);
    return r.complaints();
}

/// The complaints without the source excerpt: "line:column: text" each.
inline std::string job_places(const std::string& text) {
    Reading r;
    (void)read_job(r.add(text), r.sources, r.diagnostics);
    std::string out;
    for (const base::Diagnostic& d : r.diagnostics.all()) {
        const base::Position p = r.sources.position(d.where);
        out += std::to_string(p.line) + ":" + std::to_string(p.column) + ": " + d.text + "\n";
    }
    return out;
}

}  // namespace obrys::shop
