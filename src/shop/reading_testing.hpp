#pragma once
/// Shared by the tests of shop and its rooms: reads a text and gives all complaints as the user sees them.

#include <gtest/gtest.h>

#include <string>

#include "base/diagnostic.hpp"
#include "base/source.hpp"

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

}  // namespace obrys::shop
