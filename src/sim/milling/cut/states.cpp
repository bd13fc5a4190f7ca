#include "sim/milling/cut/states.hpp"

#include <algorithm>

namespace obrys::sim::milling {

/// A tile that has been changed does not come back: what a state holds alone is what the next one does not share.
std::size_t States::bytes(const Dexels& stock) const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < states_.size(); ++i)
        sum += states_[i].dexels.bytes_apart_from(i + 1 < states_.size() ? states_[i + 1].dexels : stock);
    return sum;
}

void States::add(std::size_t sweeps, const Dexels& stock) {
    if (most_ == 0) return;
    if (++left_out_ >= apart_) {
        left_out_ = 0;
        states_.push_back({sweeps, stock});
    }
    while (!states_.empty() && bytes(stock) > most_) {
        std::vector<State> kept;
        for (std::size_t i = 1; i < states_.size(); i += 2) kept.push_back(std::move(states_[i]));
        states_ = std::move(kept);
        apart_ *= 2;
    }
}

const States::State* States::before(std::size_t sweeps) const {
    const auto behind = std::upper_bound(states_.begin(), states_.end(), sweeps,
                                         [](std::size_t n, const State& s) { return n < s.sweeps; });
    return behind == states_.begin() ? nullptr : &*(behind - 1);
}

void States::cut_to(std::size_t sweeps) {
    while (!states_.empty() && states_.back().sweeps > sweeps) states_.pop_back();
}

}  // namespace obrys::sim::milling
