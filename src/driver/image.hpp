#pragma once
/// A program prepared once, to be run often: with other values, also by several threads at once.

#include <memory>
#include <vector>

#include "driver/check_program.hpp"

namespace obrys::driver {

/// What one run has for itself.
struct Inputs {
    std::vector<shop::Override> set;  ///< R3=150, above those of the job
    std::vector<int> skip;            ///< block skip levels that are on, besides those of the job
};

/// Programs, job, machine and tools as they were read, contours resolved, bodies loaded. Nothing of it changes any
/// more, and nothing that is made of it prints into a file.
class Image {
public:
    /// Reads everything; never null. What is wrong stands in the session's diagnostics.
    [[nodiscard]] static std::shared_ptr<const Image> prepare(const Request& request,
                                                              const MillingRequest& milling = {});

    /// False: the input cannot be used at all, and there is nothing to run.
    [[nodiscard]] bool usable() const { return usable_; }
    [[nodiscard]] const Session& session() const { return *session_; }
    [[nodiscard]] const Request& request() const { return request_; }

    /// A session for one run. To be called on a usable image.
    [[nodiscard]] std::unique_ptr<Session> run(const Inputs& inputs = {}) const;
    /// What such a run is held to.
    [[nodiscard]] check::Setup setup_for(const Session& run) const;

private:
    Request request_;
    std::shared_ptr<const Session> session_;
    check::Setup setup_;
    bool usable_ = false;
};

}  // namespace obrys::driver
