#pragma once
/// Writes a prepared program for another control, or for its own, and runs what was written.

#include "obrys/workspace.hpp"

namespace obrys::api {

enum class Proof : std::uint8_t {
    same,          ///< run again on its control, it does the same
    differs,       ///< something is lost or runs otherwise; messages say what
    not_compared,  ///< one of the two could not be run, or not understood, to its end
};

struct Translated {
    Proof proof = Proof::not_compared;
    std::string text;               ///< in the character set and with the line ends of its control
    std::vector<Message> messages;  ///< what is expanded, lost, or runs otherwise
};

/// `post`: the name of a shipped post or control, "same", or a post file (.toml) of the workspace. `tolerance`: mm
/// within which places are the same. Throws std::invalid_argument where the image is not usable.
[[nodiscard]] Translated translate(const Image& image, const std::string& post, double tolerance = 1e-3,
                                   const Inputs& inputs = {});

}  // namespace obrys::api
