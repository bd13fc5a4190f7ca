#include "driver/image.hpp"

#include <algorithm>

#include "driver/contours.hpp"

namespace obrys::driver {

std::shared_ptr<const Image> Image::prepare(const Request& request, const MillingRequest& milling) {
    auto image = std::make_shared<Image>();
    image->request_ = request;
    image->request_.prints_nowhere = true;
    auto session = std::make_shared<Session>();
    image->usable_ = open(image->request_, *session);
    if (image->usable_) {
        session->programs->read_called();
        image->setup_ = setup_of(*session, milling);
        image->usable_ = !refused(*session);
    }
    image->session_ = std::move(session);
    return image;
}

std::unique_ptr<Session> Image::run(const Inputs& inputs) const {
    auto s = std::make_unique<Session>(session_);
    for (const shop::Override& o : inputs.set) {
        std::erase_if(s->job.overrides, [&](const shop::Override& there) { return there.name == o.name; });
        s->job.overrides.push_back(o);
    }
    s->job.skip_levels.insert(s->job.skip_levels.end(), inputs.skip.begin(), inputs.skip.end());
    // A contour that a program makes may be another one with other values.
    const bool by_program = s->job.part_program || (s->job.allowance && s->job.allowance->program);
    if (by_program && (!inputs.set.empty() || !inputs.skip.empty())) resolve_contours(*s, s->input);
    return s;
}

check::Setup Image::setup_for(const Session& run) const {
    check::Setup setup = setup_;
    setup.part = run.part;
    setup.allowance = run.allowance;
    setup.right_face = run.right_face;
    return setup;
}

}  // namespace obrys::driver
