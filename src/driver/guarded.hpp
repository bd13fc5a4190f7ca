#pragma once
/// Runs other people's code in a process of its own, so that on a damaged file it can neither crash obrys nor take all
/// its memory, nor hold it for ever. What it has to say comes back as bytes.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace obrys::driver {

struct Guard {
    double seconds = 300;       ///< of the clock
    double memory_bytes = 2e9;  ///< that it may take beside what it begins with, and that its answer may have
};

struct Guarded {
    enum class End : std::uint8_t {
        done,     ///< the work returned
        crashed,  ///< it was ended by a signal, or ended itself
        late,     ///< it was stopped after `seconds`
        too_much  ///< it was stopped because its answer was too large
    };
    End end = End::crashed;
    int signal = 0;      ///< of a crash; 0 where there was none
    std::string answer;  ///< whole where the work is done
};

/// Takes bytes of the answer.
using Answer = std::function<void(std::string_view)>;

/// Runs `work` in a copy of this process, which ends with it; what it changes is lost, what it prints is not shown. An
/// exception out of `work` is a crash. Where the system knows no such copies (Windows) nothing is run: crashed. Throws
/// std::system_error where the system refuses a further process.
[[nodiscard]] Guarded guarded(const Guard& guard, const std::function<void(const Answer&)>& work);

}  // namespace obrys::driver
