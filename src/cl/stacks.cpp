#include "cl/stacks.hpp"

namespace obrys::cl {

StackId CallStacks::push(StackId below, const base::Span& site) {
    const std::uint64_t key =
        (std::uint64_t{below} * 0x9E3779B97F4A7C15u) ^ (std::uint64_t{site.file} << 32) ^ site.begin;
    std::vector<StackId>& candidates = index_[key];
    for (const StackId id : candidates)
        if (entries_[id].below == below && entries_[id].site == site) return id;
    entries_.push_back({below, site});
    const auto id = static_cast<StackId>(entries_.size() - 1);
    candidates.push_back(id);
    return id;
}

std::vector<base::Span> CallStacks::sites(StackId id) const {
    std::vector<base::Span> sites;
    for (; id != 0; id = entries_[id].below) sites.push_back(entries_[id].site);
    return sites;
}

}  // namespace obrys::cl
