#pragma once
/// Milling: tools that move through a stock and take away what they meet. Frame of the stock, millimetres.
///
/// Every move becomes one sweep or several (quarter circles; chords of helices, splines and of circles that do not lie
/// normal to a tool axis along x, y or z: within tolerance / 20 of the curve). A sweep's removal is exact on every ray.
/// The result does not depend on the number of threads.

#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "base/shared_log.hpp"
#include "geom/interpolation.hpp"
#include "sim/milling/cut/air.hpp"
#include "sim/milling/cut/stack.hpp"
#include "sim/milling/cut/states.hpp"
#include "sim/milling/cutter.hpp"
#include "sim/milling/dexel.hpp"
#include "sim/milling/stock.hpp"
#include "sim/milling/track.hpp"

namespace obrys::sim::milling {

enum class Part : std::uint8_t { cutting, shank, holder };

/// A move of a part of a tool.
struct Pass {
    geom::PathElement path;    ///< of the tip
    geom::Vec3 axis{0, 0, 1};  ///< from the tip to the holder, any length; the same all along the move
    std::uint32_t tool = 0;    ///< as `add_tool` gave it
    Part part = Part::cutting;
    bool cut = true;       ///< false: nothing is taken away; the pass's Engagement says what it meets
    bool goes_on = false;  ///< a piece of the same straight or circular move as the pass that cut before it
};

/// What became of a pass.
enum class Taken : std::uint8_t {
    taken,
    no_motion,  ///< shorter than 1e-9 mm: nothing to do
    not_known,  ///< a coordinate or the sweep is not finite, or the axis has no direction
    no_tool,    ///< no tool of this number
    too_long,   ///< over a million sweeps in one move, or 2^32 in all
};

/// What a pass met. Lengths and volumes come from the rays that run most nearly along the tool's axis, `volume` as the
/// length removed times the area of a ray's cell: where a wall along these rays is cut, it is off by up to half a
/// cell's width along the wall, for walls at all angles much less; sums over passes are for slanting faces not as good
/// as `volume`. A pass that removes less than a ray's cell may have `touched` without a volume.
struct Engagement {
    bool touched = false;  ///< met material on a ray of any direction
    double volume = 0;     ///< mm3
    double lowest =
        std::numeric_limits<double>::infinity();  ///< along the axis, of what was met: dot(point, unit axis)
    double highest = -std::numeric_limits<double>::infinity();
    /// Of what was met: distance left of the tip's way seen against the axis, negative to the right; of moves along the
    /// axis the distance from it. Climb milling with M3 has material on the right.
    double rightmost = std::numeric_limits<double>::infinity();
    double leftmost = -std::numeric_limits<double>::infinity();
    /// Passes that do not cut: how far the material reaches into the swept part, at least (from points on rays), and
    /// where.
    double depth = 0;
    geom::Vec3 deepest;
};

/// Directions that a cutter's edge is engaged in, seen against the axis, counter-clockwise from `from` to `to`; 0 is
/// the direction of the feed, radians: for moves that do not run along the axis, of the half of the tool that faces the
/// feed.
struct Angles {
    double from = 0, to = 0;
};
[[nodiscard]] Angles engaged_angles(const Engagement& e, double radius);

struct Job;

/// A point of the surface, exact, and the cut that made it; 0: the stock's own face.
struct SurfacePoint {
    geom::Vec3 at;
    std::uint32_t cut = 0;
};

/// A value: copies share tiles of rays and what was added, as far as neither has gone on since. Bodies and shapes that
/// one hands out live as long as it does.
class Simulation {
public:
    /// `stock` has no problem. `tolerance`: of chords, a twentieth; `threads` 0: as many as there are processors.
    Simulation(const Stock& stock, const Lattice& lattice, double tolerance, int threads = 0);

    [[nodiscard]] std::uint32_t add_tool(ToolShape shape);
    /// Stays where it is as long as the simulation does.
    [[nodiscard]] const ToolShape& tool(std::uint32_t number) const { return tools_[number]; }
    /// Queues a pass; passes take effect in this order. An Engagement belongs to every call, also to those not taken.
    Taken add(const Pass& pass);
    /// Carries out what is queued. What the members below say is right after it.
    void flush();

    [[nodiscard]] const Dexels& dexels() const { return dexels_; }
    [[nodiscard]] std::uint64_t open_rays() const { return open_rays_; }  ///< of a mesh stock that is not closed
    /// In the order of `add`.
    [[nodiscard]] const base::SharedLog<Engagement>& engagements() const { return engagements_; }
    /// Of a pass that does not cut: what stood above the lower side of the tool.
    [[nodiscard]] Stacks stacks_of(std::uint32_t pass) const {
        const auto at = stacks_.find(pass);
        return at == stacks_.end() ? Stacks{} : at->second;
    }
    /// Number of the pass (from 0) that a cut of an Interval belongs to; `cut` is not 0.
    [[nodiscard]] std::uint32_t pass_of(std::uint32_t cut) const { return sweeps_[cut - 1].pass; }
    /// Unit normal out of the material at a point that sweep `cut` made, or of the stock's own face where cut is 0.
    [[nodiscard]] geom::Vec3 normal_at(std::uint32_t cut, geom::Vec3 p) const;
    /// Points of the surface in a box, on rays of all three directions at most `step` apart: all that was cut is cut
    /// again there. None where the box has no size.
    [[nodiscard]] std::vector<SurfacePoint> surface_points(const Box3& box, double step) const;
    [[nodiscard]] std::size_t sweeps() const { return sweeps_.size(); }
    /// From here on keeps states between which `at` cuts again: at most so many bytes beside `bytes`.
    void keep_states(std::size_t bytes) { states_ = States(bytes); }
    /// What it was when so many passes were carried out. `flush` has been called.
    [[nodiscard]] Simulation at(std::size_t passes) const;
    /// What has been taken, and what was never there, as far as it may lie in a box. The simulation must outlive it.
    [[nodiscard]] Air air_in(const Box3& box) const;
    /// The same, moves that were added in pieces in one.
    [[nodiscard]] Air whole_air_in(const Box3& box) const;
    /// Cuts after each other whose bodies are one: pieces of one straight way, or of a quarter of a circle.
    struct Whole {
        std::uint32_t first = 0, last = 0;
    };
    /// Of these cuts, which ascend; all that cut something.
    [[nodiscard]] std::vector<Whole> wholes(std::span<const std::uint32_t> cuts) const;
    [[nodiscard]] std::vector<Whole> wholes() const;
    [[nodiscard]] Air::Sweep body_of(Whole whole) const;
    [[nodiscard]] Job job_of(Whole whole) const;
    [[nodiscard]] Box3 reach_of(Whole whole) const;
    [[nodiscard]] geom::Vec3 normal_at(Whole whole, geom::Vec3 p) const;
    /// Sweeps by the number of their cut: what cuts (null: nothing), the body, the same made ready to be cut, and a box
    /// around it.
    [[nodiscard]] const Shape* cutting_of(std::uint32_t cut) const;
    [[nodiscard]] Air::Sweep body_of(std::uint32_t cut) const;
    [[nodiscard]] Job job_of(std::uint32_t cut) const;
    /// Numbers of the cuts behind one number and up to another that may reach into a box, upwards.
    [[nodiscard]] std::vector<std::uint32_t> cuts_in(const Box3& box, std::uint32_t behind, std::uint32_t last) const;
    [[nodiscard]] std::vector<std::uint32_t> cuts_in(const Box3& box) const {
        return cuts_in(box, 0, static_cast<std::uint32_t>(done_));
    }
    [[nodiscard]] const StockBody& stock_body() const { return body(); }
    [[nodiscard]] const Stock& stock() const { return *stock_; }
    [[nodiscard]] double tolerance() const { return tolerance_; }
    [[nodiscard]] int threads() const { return threads_; }
    /// Material on the line along `axis` through a point, as rays have it, between two of its coordinates: cut again.
    [[nodiscard]] std::vector<Interval> line(int axis, geom::Vec3 through, double low, double high) const;
    [[nodiscard]] std::size_t bytes() const;

    /// One straight or circular piece of a pass.
    struct Sweep {
        geom::Vec3 from, to;
        std::uint32_t tool = 0, orientation = 0, pass = 0;
        std::uint32_t circle = 0;  ///< number in `circles`, from 1; 0: straight
        Part part = Part::cutting;
        bool cut = true;
        bool goes_on = false;  ///< as of Pass
    };
    struct Circle {
        geom::Vec3 centre;
        double turn = 1;  ///< +1 counter-clockwise seen against the tool's axis
    };

private:
    void add_straight(const Pass& pass, geom::Vec3 from, geom::Vec3 to);
    void add_circle(const Pass& pass, const geom::Circular& arc, int pieces);
    std::uint32_t orientation_for(geom::Vec3 axis);
    [[nodiscard]] const Shape& shape_of(const Sweep& sweep) const;
    [[nodiscard]] Track track_of(const Sweep& sweep) const;
    [[nodiscard]] Sweep sweep_of(Whole whole) const;
    [[nodiscard]] bool is_one(Whole whole, std::uint32_t next) const;
    [[nodiscard]] Box3 rays_box() const;  ///< from the first to the last node
    void index_runs();
    [[nodiscard]] std::vector<Job> jobs_of(std::size_t first, std::size_t end) const;
    [[nodiscard]] std::vector<Job> jobs_in(const Box3& box) const;
    [[nodiscard]] const StockBody& body() const;  ///< made when it is asked for

    Dexels dexels_;
    std::shared_ptr<const Stock> stock_;
    StockFaces faces_;
    mutable std::shared_ptr<const StockBody> body_;
    double tolerance_ = 0.01;
    int threads_ = 0;
    std::uint64_t open_rays_ = 0;
    std::deque<ToolShape> tools_;  ///< their places stay
    std::vector<Orientation> orientations_;
    std::vector<geom::Vec3> axes_;             ///< as given, of `orientations_`
    static constexpr std::size_t in_run = 32;  ///< sweeps that share a box: they lie near each other as a rule

    base::SharedLog<Sweep> sweeps_;
    base::SharedLog<Box3> runs_;  ///< boxes around so many sweeps after each other
    base::SharedLog<Circle> circles_;
    base::SharedLog<Engagement> engagements_;
    std::map<std::uint32_t, Stacks> stacks_;  ///< by pass: few do not cut and meet something
    std::size_t done_ = 0;                    ///< sweeps carried out
    States states_;
};

/// Volume of the material, mm3. Around each node of the lattice lies a cell of one step; what rays of the three axes
/// say of it counts the more, the nearer the axis lies to the face's normal. Exact for faces normal to an axis and
/// their edges. Of what a slot or bore a dozen steps wide holds it was seen to be off by 0.02 % as a rule and 0.1 % at
/// most (edges between faces that slant are not known better than to part of a cell); the closed surface (surface.hpp)
/// is as near and costs more.
[[nodiscard]] double volume(const Simulation& simulation);

}  // namespace obrys::sim::milling
