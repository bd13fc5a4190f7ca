#pragma once
/// Where the tool stands when the zero offset changes on the way: the stock keeps the frame of the first one.

#include "cl/record.hpp"

namespace obrys::motion {

class Position {
public:
    /// The workpiece frame changes; the machine does not move.
    void take(const cl::Datum& datum);
    /// The tool has moved to a point of the frame in force.
    void move_to(geom::Vec3 to);

    [[nodiscard]] geom::Vec3 here() const { return here_; }  ///< in the frame in force
    /// From the frame in force to the stock's frame.
    [[nodiscard]] geom::Vec3 to_stock() const { return shift_; }

private:
    cl::Datum datum_{0, {NAN, NAN, NAN}};
    cl::Datum stock_{0, {NAN, NAN, NAN}};
    bool datum_set_ = false, fixed_ = false;
    geom::Vec3 here_{NAN, NAN, NAN};
    geom::Vec3 shift_;
};

}  // namespace obrys::motion
