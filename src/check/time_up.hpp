#pragma once
/// The time that a check may take: it ends with what it has, and says how far it came.

#include <cstdint>
#include <functional>
#include <string>

namespace obrys::check {

class TimeUp {
public:
    /// May be empty: then there is no end. It outlives this.
    explicit TimeUp(const std::function<bool()>& out_of_time) : out_of_time_(out_of_time) {}
    /// Asks the clock; stays up.
    [[nodiscard]] bool now() { return up_ = up_ || (out_of_time_ && out_of_time_()); }
    /// Whether a move and all behind it are left out. Asks the clock at every few moves.
    [[nodiscard]] bool before(std::uint64_t move) {
        constexpr std::uint32_t few = 16;
        if (!up_ && ++asked_ % few == 0) static_cast<void>(now());
        if (up_ && text_.empty())
            text_ = "the time for the check is up: from move " + std::to_string(move) + " on nothing is simulated";
        return up_;
    }
    [[nodiscard]] bool up() const { return up_; }
    /// What is said of the moves that were left out; empty: none was.
    [[nodiscard]] const std::string& text() const { return text_; }
    static constexpr const char* remedy = "give it more with seconds in [budget] of the job";

private:
    const std::function<bool()>& out_of_time_;
    std::uint32_t asked_ = 0;
    bool up_ = false;
    std::string text_;
};

}  // namespace obrys::check
