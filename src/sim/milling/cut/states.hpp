#pragma once
/// Stocks as they were after so many sweeps, between which a simulation is cut again. Where they take more memory than
/// they may, every second one goes: they stay as far apart as each other.

#include <cstddef>
#include <vector>

#include "sim/milling/dexel.hpp"

namespace obrys::sim::milling {

class States {
public:
    struct State {
        std::size_t sweeps = 0;
        Dexels dexels;
    };

    States() = default;
    /// At most so many bytes, of tiles that the stock itself does not hold any more.
    explicit States(std::size_t bytes) : most_(bytes) {}
    /// `sweeps` more than last time.
    void add(std::size_t sweeps, const Dexels& stock);
    /// The last one with no more sweeps than so many; null: none.
    [[nodiscard]] const State* before(std::size_t sweeps) const;
    /// Forgets those with more.
    void cut_to(std::size_t sweeps);
    [[nodiscard]] std::size_t count() const { return states_.size(); }
    /// What they take beside the stock.
    [[nodiscard]] std::size_t bytes(const Dexels& stock) const;

private:
    std::size_t most_ = 0;
    std::size_t apart_ = 1, left_out_ = 0;  ///< calls of `add` from one state to the next, and since the last
    std::vector<State> states_;             ///< with ascending sweeps
};

}  // namespace obrys::sim::milling
