#pragma once
/// Gouges by geometry (sim/certify): every move of the tool against the part, whatever lies between the rays.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "check/gouge/thread_band.hpp"
#include "check/result.hpp"
#include "check/setup.hpp"
#include "sim/certify/certify.hpp"
#include "sim/milling/cutter.hpp"

namespace obrys::check {

/// A place where the part was cut into; `at`, deviation, shares and peak as those of a place of the surface. Without an
/// area the rays did not see it, and the shares of its moves are depths, mm.
struct Gouge {
    mesh::Place place;
    double width = 0;    ///< mm, of the tool in the surface; 0: not known
    bool edge = false;   ///< of an edge
    bool lacks = false;  ///< no move has made it: the stock does not hold the part
};

class Certificate {
public:
    /// A move that is deeper than allowed.
    struct Found {
        std::uint32_t move = 0;
        sim::certify::Depth depth;
        double beside = 0;  ///< mm of way along the surface there
    };
    /// A place of which it is not decided whether a move is too deep there.
    struct Open {
        std::uint32_t move = 0;  ///< index in Milled::moves
        geom::Vec3 at;
    };
    Certificate(const MillingSetup& setup, double allowed);

    Certificate(const Certificate&) = delete;
    Certificate& operator=(const Certificate&) = delete;

    /// By the tool's number in the simulation, in that order.
    void add_tool(const sim::milling::ToolShape& tool);
    /// What the cutting part of a tool does; `move`: index in Milled::moves.
    void add(std::uint32_t move, const geom::PathElement& path, geom::Vec3 axis, std::uint32_t tool);
    /// Judges what has been added.
    void carry_out();
    /// How deep all that was added goes. What was not measured when it is told to `stop` is left out. `threads`
    /// outlives this.
    void measure(const ThreadBands& threads, const std::function<bool()>& stop);
    /// What the rays show of a gouge tells more of one that was measured or is not decided, or is no move's.
    [[nodiscard]] bool may_be(const mesh::Place& rays) const;
    /// What the rays show of a gouge is nothing: its moves are proved to be clear, not only where the stock lacks it.
    [[nodiscard]] bool is_none(const mesh::Place& rays) const;
    /// All gouges, measured before. `rays`: what was found on the simulated surface. Of these only places are left out
    /// whose moves are proved to be clear.
    [[nodiscard]] std::vector<Gouge> gouges(const std::vector<MilledMove>& moves, const std::vector<mesh::Place>& rays);
    /// What `gouges` could neither prove to be clear nor measure.
    [[nodiscard]] const std::vector<Open>& open() const { return open_; }

private:
    struct Queued {
        std::uint32_t move = 0, tool = 0;
        geom::PathElement path;
        geom::Vec3 axis;
    };
    enum class State : std::uint8_t {
        open,   ///< not searched, or neither found to be deep nor proved not to be
        clear,  ///< measured as no deeper than allowed, and proved to be hardly deeper
        found,  ///< deeper
    };
    /// A move that is not clear at once.
    struct Suspect {
        Queued queued;
        State state = State::open;
        bool searched = false;  ///< to the end
        std::optional<sim::certify::Depth> depth = {};
    };
    [[nodiscard]] sim::certify::Move move_of(const Queued& q) const { return {q.path, q.axis, &shapes_[q.tool]}; }
    [[nodiscard]] bool stopped() const { return stop_ && stop_(); }
    [[nodiscard]] bool is_proved(const Suspect& suspect) const;
    void search(Suspect& suspect, std::optional<geom::Vec3> from) const;
    [[nodiscard]] std::vector<Suspect*> suspects_in(const mesh::Place& rays);
    void settle(const mesh::Place& rays);
    [[nodiscard]] std::vector<Found> found() const;
    [[nodiscard]] bool finish_worst(const std::vector<std::vector<std::uint32_t>>& groups);
    [[nodiscard]] std::optional<Gouge> unclaimed(const mesh::Place& rays);
    void add_lack(std::vector<Gouge>& gouges) const;

    int threads_ = 0;
    double allowed_ = 0;
    std::shared_ptr<const mesh::Distance> part_;
    sim::certify::Before before_;
    sim::certify::Judge judge_;
    std::function<bool()> stop_;
    std::vector<sim::certify::Shape> shapes_;
    std::vector<Queued> queued_;
    std::vector<Suspect> suspects_;
    std::map<std::uint32_t, std::vector<std::size_t>> of_move_;  ///< in `suspects_`
    std::set<std::uint32_t> beside_;  ///< moves that are clear only since there was no material
    std::vector<Open> open_;
};

}  // namespace obrys::check
