#pragma once
/// What lies below the doors, in their types. Private to obrys.

#include <memory>

#include "base/diagnostic.hpp"
#include "driver/image.hpp"
#include "obrys/workspace.hpp"

namespace obrys::api {

[[nodiscard]] Place shown(const base::Sources& sources, const base::Span& where);
[[nodiscard]] std::vector<Place> shown(const base::Sources& sources, const std::vector<base::Span>& sites);
/// In the words of the session's control.
[[nodiscard]] std::vector<Message> shown(const driver::Session& session);

[[nodiscard]] driver::Inputs inside(const Inputs& inputs);
/// A session for a run; throws std::invalid_argument where the image is not usable.
[[nodiscard]] std::unique_ptr<driver::Session> session_of(const Image& image, const Inputs& inputs);

}  // namespace obrys::api
