#pragma once
/// What a job says of its cuts: of the workpiece's material, and of how its tools, wherever they are listed, are used.
/// File format: docs/force.md.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/source.hpp"

namespace obrys::shop {

/// Of a tool, by its number; nothing: not said.
struct ToolUseData {
    std::uint32_t number = 0;
    std::optional<int> teeth;          ///< where its list does not say it
    std::optional<double> helix;       ///< degrees
    std::optional<double> stick_out;   ///< mm from the holder to the tip
    std::optional<double> elasticity;  ///< N/mm2
    /// What it is to be used with, from least to most: mm, m/min.
    std::optional<std::array<double, 2>> feed_per_tooth, cutting_speed;
};

struct CuttingJob {
    std::string material;  ///< a name as written; empty: not said
    base::Span material_where{};
    struct File {
        std::string path;  ///< as written, relative to the job
        base::Span where;
    };
    std::vector<File> materials;
    std::optional<double> spindle_torque;  ///< Nm
    std::vector<ToolUseData> tools;
};

/// Of this number; null where the job says nothing of it.
[[nodiscard]] inline const ToolUseData* find_use(const CuttingJob& job, std::uint32_t number) {
    for (const ToolUseData& t : job.tools)
        if (t.number == number) return &t;
    return nullptr;
}

}  // namespace obrys::shop
