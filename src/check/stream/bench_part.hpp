#pragma once
/// A small part for tests: bar of radius 20 from Z 0 to Z 100, a groove from Z 30 to Z 40 down to radius 15, and
/// 0.5 mm of allowance in it. Every record stands on a line of its own, so that its place says which one it was.

#include <string>
#include <vector>

#include "check/result_testing.hpp"
#include "check/stream/check.hpp"

namespace obrys::check::bench_part {

inline geom::Region polygon(std::vector<geom::Vec2> points) {
    geom::Contour c;
    for (const geom::Vec2 p : points) c.vertices.push_back({p, 0});
    return {{c}};
}

/// A bar of radius 20 with a groove of this half-width round Z 35, down to `bottom`.
inline geom::Region grooved(double half_width, double bottom) {
    return polygon({{0, 0},
                    {100, 0},
                    {100, 20},
                    {35 + half_width, 20},
                    {35 + half_width, bottom},
                    {35 - half_width, bottom},
                    {35 - half_width, 20},
                    {0, 20}});
}

inline Setup setup() {
    Setup s;
    s.machine.kind = shop::MachineKind::lathe;
    shop::Tool tool;
    tool.number = 5;
    tool.kind = shop::ToolKind::groove;
    tool.width = 3;
    s.tools = {tool};
    s.tools_given = true;
    s.stock = polygon({{0, 0}, {100, 0}, {100, 20}, {0, 20}});
    s.part = grooved(5, 15);
    s.allowance = grooved(4.5, 15.5);
    return s;
}

/// Feeds steps to a check. Record i comes from bytes [10 i, 10 i + 9), which is line i + 1 of `text()`.
class Script {
public:
    explicit Script(Setup s) : check_(std::move(s), stacks) {}

    Script& step(cl::Step s, cl::StackId stack = 0) {
        check_.take({std::move(s), {0, 10 * count_, 10 * count_ + 9}, stack});
        ++count_;
        return *this;
    }
    Script& rapid(double z, double x) { return step(cl::Linear{{x, 0, z}, {0, 0, 1}, true}); }
    Script& feed(double z, double x) { return step(cl::Linear{{x, 0, z}, {0, 0, 1}, false}); }
    /// Spindle, feed and tool 5, and the way above the groove.
    Script& ready() {
        step(cl::Spindle{1000, cl::SpindleMode::rpm, 1, 0});
        step(cl::Feed{0.2, cl::FeedMode::per_rev});
        step(cl::ToolChange{5, 1, ""});
        return rapid(33, 25);
    }
    /// Everything that has to go, in three plunges: 30.5 … 39.5 down to 15.5.
    Script& whole_groove() {
        for (const double z : {33.5, 30.5, 36.5}) {
            rapid(z, 25);
            feed(z, 15.5);
            rapid(z, 25);
        }
        return *this;
    }
    Result finish() { return check_.finish(); }
    [[nodiscard]] std::uint32_t records() const { return count_; }

    cl::CallStacks stacks;

private:
    Check check_;
    std::uint32_t count_ = 0;
};

/// The line of the record that a span stands for.
inline int line(const base::Span& s) { return s.file == 0 ? static_cast<int>(s.begin / 10) + 1 : 0; }

/// "code@move" of all findings.
inline std::vector<std::string> codes(const Result& r) {
    std::vector<std::string> out;
    for (const Finding& f : r.findings)
        out.push_back(std::string(f.code) + (f.move ? "@" + std::to_string(*f.move) : ""));
    return out;
}

using testing::amount;

}  // namespace obrys::check::bench_part
