#include "check/clamp_guard.hpp"

#include <array>

#include "check/certify_shapes.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

namespace {

constexpr double round_share = 0.25;    ///< of what is allowed: chords of a round clamp, and of a form tool's arcs
constexpr std::size_t looked_at = 200;  ///< hits of one batch whose depth is found to the end

}  // namespace

ClampGuard::ClampGuard(const milling::Stock& body, double allowed, int threads)
    : clamp_(mesh_of(body, round_share * allowed)), allowed_(allowed), threads_(threads), judge_(clamp_, allowed) {}

void ClampGuard::add_tool(const milling::ToolShape& tool) {
    const double off = round_share * allowed_;
    tools_.push_back(std::make_unique<const std::array<certify::Shape, 3>>(std::array<certify::Shape, 3>{
        certified_shape(tool.cutting, off), certified_shape(tool.shank, off), certified_shape(tool.holder, off)}));
}

void ClampGuard::add(const milling::Pass& pass) {
    const std::uint32_t number = passes_++;
    if (pass.tool >= tools_.size()) return;
    const certify::Shape& shape = (*tools_[pass.tool])[static_cast<std::size_t>(pass.part)];
    if (!shape.empty()) queued_.push_back({number, pass.path, pass.axis, &shape});
}

void ClampGuard::carry_out() {
    const auto move = [&](std::size_t i) { return certify::Move{queued_[i].path, queued_[i].axis, queued_[i].shape}; };
    std::vector<char> clear(queued_.size());
    for_all(queued_.size(), threads_, [&](std::size_t i) { clear[i] = judge_.is_clear(move(i)) ? 1 : 0; });
    std::vector<std::size_t> met;
    for (std::size_t i = 0; i < clear.size(); ++i)
        if (clear[i] == 0) met.push_back(i);
    std::vector<Hit> hits(met.size());
    for_all(met.size(), threads_, [&](std::size_t i) {
        if (i >= looked_at) {
            hits[i] = {judge_.rough(move(met[i])), geom::point_at(queued_[met[i]].path, 0.5)};
            return;
        }
        const certify::Depth d = judge_.deepest(move(met[i]));
        hits[i] = {d.depth, d.at};
    });
    for (std::size_t i = 0; i < met.size(); ++i)
        if (hits[i].depth > allowed_) hits_[queued_[met[i]].pass] = hits[i];
    queued_.clear();
}

ClampGuard::Hit ClampGuard::hit_by(std::uint32_t pass) const {
    const auto at = hits_.find(pass);
    return at == hits_.end() ? Hit{} : at->second;
}

}  // namespace obrys::check
