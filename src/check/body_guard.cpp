#include "check/body_guard.hpp"

#include "check/certify_shapes.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

namespace {

constexpr std::size_t hits_looked_at = 200;  ///< hits of one batch whose depth is found to the end

}  // namespace

BodyGuard::BodyGuard(const milling::Stock& body, double allowed, int threads)
    : BodyGuard(std::make_shared<const mesh::Distance>(mesh_of(body, round_share * allowed)), allowed, threads, {}) {}

BodyGuard::BodyGuard(std::shared_ptr<const mesh::Distance> body, double allowed, int threads,
                     std::function<double(geom::Vec3)> within)
    : body_(std::move(body)), allowed_(allowed), threads_(threads), judge_(*body_, allowed, std::move(within)) {}

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

void BodyGuard::carry_out() {
    const auto move = [&](std::size_t i) { return certify::Move{queued_[i].path, queued_[i].axis, queued_[i].shape}; };
    std::vector<char> clear(queued_.size());
    for_all(queued_.size(), threads_, [&](std::size_t i) { clear[i] = judge_.is_clear(move(i)) ? 1 : 0; });
    std::vector<std::size_t> met;
    for (std::size_t i = 0; i < clear.size(); ++i)
        if (clear[i] == 0) met.push_back(i);
    std::vector<certify::Depth> hits(met.size());
    for_all(met.size(), threads_, [&](std::size_t i) {
        if (i < hits_looked_at) {
            hits[i] = judge_.deepest(move(met[i]));
            return;
        }
        hits[i].depth = judge_.rough(move(met[i]));
        hits[i].at = hits[i].surface = geom::point_at(queued_[met[i]].path, 0.5);
    });
    for (std::size_t i = 0; i < met.size(); ++i)
        if (hits[i].depth > allowed_) hits_[queued_[met[i]].number] = hits[i];
    queued_.clear();
}

certify::Depth BodyGuard::hit_by(std::uint32_t number) const {
    const auto at = hits_.find(number);
    return at == hits_.end() ? certify::Depth{} : at->second;
}

}  // namespace obrys::check
