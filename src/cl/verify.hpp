#pragma once
/// Holds a CL stream to its own rules (docs/cl-stream.md), record by record.

#include <vector>

#include "base/diagnostic.hpp"
#include "cl/record.hpp"
#include "cl/stacks.hpp"

namespace obrys::cl {

/// mm that the radii at both ends of an arc may differ
inline constexpr double circle_tolerance = 0.01;

struct VerifyOptions {
    double circle_tolerance = cl::circle_tolerance;
    double spline_tolerance = 0.01;  ///< mm a spline may start beside the position
};

/// Adds one diagnostic for every record that breaks a rule: `arc-radius` where the ends do not lie on the circle,
/// `spline-start` where a spline does not start at the position, `value-range` for values that no record may hold,
/// `unclosed` for brackets of cycles, parts and compensation without their partner.
class Verifier {
public:
    explicit Verifier(base::Diagnostics& diagnostics, VerifyOptions options = {}, const CallStacks* stacks = nullptr)
        : diagnostics_(diagnostics), options_(options), stacks_(stacks) {}

    void operator()(const Record& record);
    /// To be called after the last record: complains about brackets that are still open.
    void finish();

private:
    void complain(const Record& record, std::string_view code, std::string text);
    void check(const Record& r, const Linear& s);
    void check(const Record& r, const Arc& s);
    void check(const Record& r, const Spline& s);
    void check(const Record& r, const AxisEnds& ends);
    void check(const Record& r, const Thread& s);
    void check(const Record& r, const Dwell& s);
    void check(const Record& r, const Feed& s);
    void check(const Record& r, const Spindle& s);
    void check(const Record& r, const OtherSpindle& s);
    void check(const Record& r, const Datum& s);
    void check(const Record& r, const Frame& s);
    void check(const Record& r, const Tolerance& s);
    void check(const Record& r, const PathMode& s);
    void check(const Record& r, const CycleBegin& s);
    void check(const Record& r, const CycleEnd& s);
    void check(const Record& r, const PartBegin& s);
    void check(const Record& r, const PartEnd& s);
    void check(const Record& r, const CompensationBegin& s);
    void check(const Record& r, const CompensationEnd& s);
    void check(const Record& r, const Programmed& s);
    void check(const Record& r, const Stop& s);
    void check(const Record& r, const ToolLength& s);
    void check(const Record& r, const MachinePlace& s);
    void check(const Record& r, const ToolData& s);
    void check(const Record& r, const DatumData& s);
    void check(const Record& r, const Output& s);
    void check(const Record& r, const LeadBegin& s);
    void check(const Record& r, const LeadEnd& s);
    void check(const Record&, const ToolChange&) {}
    void check(const Record&, const Coolant&) {}
    void check(const Record&, const Comment&) {}
    void check(const Record&, const ToolSelection&) {}
    void check(const Record&, const Override&) {}
    void check(const Record&, const Auxiliary&) {}

    base::Diagnostics& diagnostics_;
    VerifyOptions options_;
    const CallStacks* stacks_;
    geom::Vec3 position_{NAN, NAN, NAN};
    std::optional<Datum> zero_;           ///< in force
    std::vector<Record> open_;            ///< CycleBegin records without their end
    std::vector<Record> parts_;           ///< the same of PartBegin
    std::optional<Record> lead_;          ///< LeadBegin without its end; one is in force at most
    std::optional<Record> compensation_;  ///< the same of CompensationBegin; one is in force at most
};

}  // namespace obrys::cl
