#pragma once
/// What a simulation has emptied, by columns along the tools' axes: a body that stays in columns that single cuts have
/// emptied is clear for sure, in microseconds; how deep a place lies in what is left is exact. Frame of the stock, mm.
///
/// Columns that the cuts before have not emptied are quartered, down to a thirty-second of a bin. Bodies and cuts of
/// the same axis alone are compared; a body that is not shown to be clear may be so all the same.

#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

#include "check/touching/bins.hpp"
#include "check/touching/clearing_cut.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::check {

class Cleared {
public:
    /// `slack`: so far beside counts as within; `finest`: of the bins.
    Cleared(const sim::milling::Stock& stock, double slack, double finest);

    /// Takes in what was cut before a pass; passes never go back.
    void advance(const sim::milling::Simulation& simulation, std::uint32_t pass);
    /// `axis`: unit length; the body in the stock's frame.
    [[nodiscard]] bool is_clear(const Upright& body, geom::Vec3 axis);
    /// How far a place of what is left lies from all that is not there, at most `enough`; 0: nothing is there, or too
    /// many axes were cut with to tell.
    [[nodiscard]] double depth_at(geom::Vec3 p, double enough);

private:
    struct Column {
        Zones empty;                      ///< all over it
        std::vector<std::uint32_t> cuts;  ///< that took more of a part of it
        std::uint32_t taken = 0;          ///< cuts of the simulation that were looked at
    };
    struct Cut {
        ClearingCut shape;
        std::uint32_t number = 0;  ///< as of the simulation
    };
    /// Of one axis.
    struct Field {
        sim::milling::Orientation frame;
        Zone heights;  ///< of the stock
        Bins<Column> columns;
        std::vector<Cut> cuts;
        std::unordered_map<std::uint32_t, std::uint32_t> known;  ///< cuts of the simulation: their places in `cuts`
    };
    struct Query {
        const Upright& body;  ///< in the field's frame
        const Field& field;
        std::size_t left = 0;  ///< columns that may still be looked at
    };
    Field& field_for(const sim::milling::Orientation& frame);
    void fill(Field& field, Column& column, const Patch& patch) const;
    void take(Field& field, Column& column, const Patch& patch, std::uint32_t number) const;
    /// Makes fields of all axes that were cut with; false: too many.
    [[nodiscard]] bool know_axes();
    [[nodiscard]] double depth_in(Field& field, geom::Vec3 p, double depth) const;
    [[nodiscard]] bool is_empty(Query& q, const Column& column, const Patch& patch, int level) const;
    [[nodiscard]] bool misses_stock(const Field& field, const Patch& patch) const;

    const sim::milling::Stock& stock_;
    double slack_ = 0, finest_ = 0;
    const sim::milling::Simulation* simulation_ = nullptr;
    std::uint32_t cuts_ = 0;       ///< made before the pass
    std::uint32_t axes_from_ = 0;  ///< cuts whose axes have a field
    std::deque<Field> fields_;
};

}  // namespace obrys::check
