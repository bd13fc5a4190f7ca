/// Where the selected datum lies.

#include <cmath>
#include <optional>

#include "interp/values/values.hpp"

namespace obrys::interp {

namespace {

/// Where a datum lies in the machine, with its basic rotation about Z.
struct DatumPlace {
    geom::Vec3 origin;
    double rotation = 0;
};

std::optional<DatumPlace> datum_place(const Reckoning& run, std::uint32_t n) {
    const shop::Machine& machine = run.env.machine;
    if (const auto found = machine.datums.find(n); found != machine.datums.end()) {
        const auto turned = machine.datum_rotations.find(n);
        geom::Vec3 origin = found->second;
        for (int k = 0; k < 3 && n == run.modal.datum; ++k)
            if (std::isnan(coordinate(origin, k))) coordinate(origin, k) = coordinate(run.modal.datum_before, k);
        return DatumPlace{origin, turned == machine.datum_rotations.end() ? 0 : turned->second};
    }
    if (n == program::no_datum && run.traits->datum.none_is_machine_zero) return DatumPlace{};
    return std::nullopt;
}

}  // namespace

std::optional<geom::Frame> datum_shift(const Reckoning& run) {
    if (run.modal.datum == run.reference_datum) return geom::Frame{};
    const auto active = datum_place(run, run.modal.datum), reference = datum_place(run, run.reference_datum);
    if (!active || !reference || !geom::is_finite(active->origin - reference->origin)) return std::nullopt;
    if (active->rotation == 0 && reference->rotation == 0)
        return geom::Frame::shift(active->origin - reference->origin);
    const auto frame = [](const DatumPlace& p) {
        return geom::Frame::shift(p.origin) * geom::Frame::rotation(2, p.rotation);
    };
    return geom::inverse(frame(*reference)) * frame(*active);
}

geom::Vec3 datum_origin(const Reckoning& run) {
    const auto place = datum_place(run, run.modal.datum);
    return place ? place->origin : geom::Vec3{NAN, NAN, NAN};
}

}  // namespace obrys::interp
