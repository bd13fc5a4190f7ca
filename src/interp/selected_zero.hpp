#pragma once
/// The run reckons in the frame of one workpiece zero; the stream counts from the zero that the program has selected.
/// Private to interp.

#include "cl/zero.hpp"

namespace obrys::interp {

/// Stands before whoever takes the stream: moves the points of what passes into the frame of the last Datum.
class SelectedZero {
public:
    explicit SelectedZero(cl::Sink out) : out_(out) {}
    /// As another one, for another taker.
    SelectedZero(const SelectedZero& other, cl::Sink out) : SelectedZero(other) { out_ = out; }
    void operator()(const cl::Record& record);
    /// From the frame that the run reckons in into that of the stream.
    [[nodiscard]] geom::Vec3 by() const { return by_; }

private:
    cl::Sink out_;
    std::optional<cl::Datum> first_;
    geom::Vec3 by_;
    bool moved_ = false;  ///< `by_` is not 0
    cl::Record record_;
    [[nodiscard]] const base::SharedValue<cl::Cycle>& moved_cycle(const base::SharedValue<cl::Cycle>& cycle);
    base::SharedValue<cl::Cycle> cycle_from_, cycle_to_;  ///< the last one
    geom::Vec3 cycle_by_;
};

}  // namespace obrys::interp
