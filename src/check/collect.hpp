#pragma once
/// Gathers findings and notes while a check runs, with the limits on their number.

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "check/result.hpp"
#include "cl/stacks.hpp"

namespace obrys::check {

/// One move on its way through the check.
struct Move {
    const cl::Record& record;
    std::uint64_t index = 0;
    geom::Vec3 from, to;
    bool rapid = false;
    bool turning = false;  ///< rotary axes turn on the way
};

class Collector {
public:
    Collector(const cl::CallStacks& stacks, std::size_t limit_per_code) : stacks_(stacks), limit_(limit_per_code) {}

    /// A finding about a move, placed at its source. At most one for each code and move is kept.
    void finding(const Move& move, Finding f);
    /// A finding about a record that is not a move.
    void finding(const cl::Record& record, Finding f);
    /// Notes are kept once for each text and counted.
    void unchecked(const cl::Record& record, std::string text, std::string remedy = {});
    void unchecked(std::string text, std::string remedy = {});
    void assumption(std::string text, base::Span where = nowhere);

    [[nodiscard]] Result& result() { return result_; }
    [[nodiscard]] const cl::CallStacks& stacks() const { return stacks_; }

private:
    void note_site(const std::string& key, const Finding& f);

    const cl::CallStacks& stacks_;
    std::size_t limit_;
    struct Kept {
        std::size_t last = 0;  ///< index of the last finding kept of a cause
        bool only = true;      ///< there is no other
    };
    struct OfCode {
        std::map<std::string, Kept> causes;
        std::size_t details = 0;  ///< findings kept beside the first ones of their causes
    };

    std::map<std::string_view, OfCode> per_code_;
    std::set<std::string_view> of_last_move_;  ///< codes already said about the last move
    std::uint64_t last_move_ = 0;
    Result result_;
};

}  // namespace obrys::check
