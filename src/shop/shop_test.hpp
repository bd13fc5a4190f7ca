#pragma once
/// Shared by the tests of shop: reads a text and gives all complaints as the user sees them.

#include <gtest/gtest.h>

#include <string>

#include "shop/job.hpp"

namespace obrys::shop {

struct Reading {
    base::Sources sources;
    base::Diagnostics diagnostics;

    std::uint32_t add(const std::string& text, const std::string& name = "job.toml") { return sources.add(name, text); }
    [[nodiscard]] std::string complaints() const {
        std::string out;
        for (const base::Diagnostic& d : diagnostics.all()) out += base::render(d, sources);
        return out;
    }
};

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
