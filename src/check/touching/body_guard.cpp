#include "check/touching/body_guard.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "check/certify_shapes.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

namespace {

constexpr std::size_t hits_looked_at = 200;  ///< hits of one batch whose depth is found to the end
/// Of what is allowed: what is surely no deeper and was measured as less than is allowed is no hit.
constexpr double decided_from = 1.1;

}  // namespace

BodyGuard::BodyGuard(const milling::Stock& body, double allowed, int threads)
    : BodyGuard(std::make_shared<const mesh::Distance>(mesh_of(body, round_share * allowed)), allowed, threads, {}) {}

BodyGuard::BodyGuard(std::shared_ptr<const mesh::Distance> body, double allowed, int threads, certify::Before before)
    : body_(std::move(body)), allowed_(allowed), threads_(threads), judge_(*body_, allowed, std::move(before)) {}

void BodyGuard::add_tool(const milling::ToolShape& tool) {
    const double off = round_share * allowed_;
    tools_.push_back(std::make_unique<const std::array<certify::Shape, 3>>(std::array<certify::Shape, 3>{
        certified_shape(tool.cutting, off), certified_shape(tool.shank, off), certified_shape(tool.holder, off)}));
}

void BodyGuard::add(std::uint32_t number, const milling::Pass& pass) {
    if (pass.tool >= tools_.size()) return;
    const certify::Shape& shape = (*tools_[pass.tool])[static_cast<std::size_t>(pass.part)];
    if (!shape.empty()) queued_.push_back({number, pass.path, pass.axis, &shape});
}

/// How deep what is queued goes. Of very many only the deepest are searched to the end, and those of which a short
/// search has not shown that they go in at all.
std::vector<std::optional<certify::Depth>> BodyGuard::depths() const {
    std::vector<std::optional<certify::Depth>> depths(queued_.size());
    const bool many = queued_.size() > hits_looked_at;
    if (many) for_all(depths.size(), threads_, [&](std::size_t i) { depths[i] = judge_.rough(move_of(queued_[i])); });
    std::vector<std::size_t> order(queued_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto deep = [&](std::size_t i) { return depths[i] ? depths[i]->depth : 0; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return deep(a) > deep(b); });
    for_all(order.size(), threads_, [&](std::size_t i) {
        const std::size_t at = order[i];
        if (i >= hits_looked_at && deep(at) > allowed_) return;
        const auto found = judge_.deepest(move_of(queued_[at]));
        if (found && !(found->depth < deep(at))) depths[at] = found;
    });
    return depths;
}

void BodyGuard::carry_out() {
    constexpr auto of = certify::Judge::Of::part_in_stock;
    std::vector<char> clear(queued_.size());
    for_all(queued_.size(), threads_,
            [&](std::size_t i) { clear[i] = judge_.is_clear(move_of(queued_[i]), of) ? 1 : 0; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < clear.size(); ++i)
        if (clear[i] == 0) std::swap(queued_[kept++], queued_[i]);
    queued_.resize(kept);
    const std::vector<std::optional<certify::Depth>> found = depths();
    for (std::size_t i = 0; i < queued_.size(); ++i)
        if (found[i] && found[i]->depth > allowed_)
            hits_.insert_or_assign(queued_[i].number, *found[i]);
        else if (!judge_.is_clear(move_of(queued_[i]), decided_from * allowed_, of) &&
                 !(found[i] && judge_.is_thin(move_of(queued_[i]), found[i]->normal)))
            open_.insert(queued_[i].number);
    queued_.clear();
}

std::optional<certify::Depth> BodyGuard::hit_by(std::uint32_t number) const {
    const auto at = hits_.find(number);
    return at == hits_.end() ? std::nullopt : std::optional{at->second};
}

}  // namespace obrys::check
