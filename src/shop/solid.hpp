#pragma once
/// Bodies that a job places in the workpiece frame: stock, part and clamps of milling. File format: docs/job-file.md.

#include <string>
#include <string_view>
#include <variant>

#include "base/source.hpp"
#include "geom/vec.hpp"

namespace obrys::shop {

/// Parallel to the axes, mm; `min` lies below `max` in every one.
struct SolidBox {
    geom::Vec3 min, max;
    bool operator==(const SolidBox&) const = default;
};

/// About a line parallel to an axis, mm.
struct SolidCylinder {
    int axis = 2;             ///< 0 = x …
    geom::Vec3 centre;        ///< a point of the line; 0 along the axis
    double radius = 0;        ///< greater than 0
    double min = 0, max = 0;  ///< along the axis
    bool operator==(const SolidCylinder&) const = default;
};

/// A body in a file of its own (STL or STEP); who reads it multiplies by `unit`, then adds `offset`.
struct SolidFile {
    std::string path;         ///< as written, relative to the job file
    double unit = 1;          ///< mm a unit of the file: 1 or 25.4; of a STEP file 1, it is read in mm
    bool unit_known = false;  ///< the job or the file says it; else it is taken for millimetres
    geom::Vec3 offset;        ///< mm
    base::Span where;         ///< of the path
    bool operator==(const SolidFile&) const = default;
};

/// Whether a file's name says that it is a STEP file: it ends in .step or .stp, in letters of any case.
[[nodiscard]] bool is_step_name(std::string_view path);

using Solid = std::variant<SolidBox, SolidCylinder, SolidFile>;

/// What a milling program begins with.
struct Stock {
    Solid solid;
    base::Span where;
};

/// What it has to leave.
struct Part {
    SolidFile file;
};

/// What holds the workpiece and must not be touched.
struct Clamp {
    std::string name;  ///< for messages; "clamp 2" where the job gives none
    Solid solid;
    base::Span where;
};

}  // namespace obrys::shop
