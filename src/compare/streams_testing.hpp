#pragma once
/// Streams for the tests: in words of the text form, at random, and the same way written otherwise.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "cl/text.hpp"
#include "compare/compare.hpp"

namespace obrys::compare {

using Steps = std::vector<cl::Step>;

inline cl::Linear line(double x, double y = 0, bool rapid = false) {
    return {{x, y, 0}, {0, 0, 1}, rapid, cl::Seek::nothing};
}

/// A line of the text form without its place, ` | ` between those of axes and their move; nothing where it is none.
inline std::optional<cl::Step> step_of(const std::string& line) {
    base::Sources sources;
    base::Diagnostics diagnostics;
    std::string text = std::string(cl::text_header) + "\n" + line + " @0:0-0\n";
    for (std::size_t at = text.find(" | "); at != std::string::npos; at = text.find(" | "))
        text.replace(at, 3, " @0:0-0\n");
    const auto records = cl::read_text(sources, sources.add("a.cl", text), diagnostics);
    if (!diagnostics.all().empty() || records.size() != 1) return std::nullopt;
    return records[0].step;
}

inline std::string line_of(const cl::Step& step) {
    const std::string text = cl::to_text({step, {}, 0});
    return text.substr(0, text.rfind(" @"));
}

inline Steps steps_of(const std::vector<std::string>& lines) {
    Steps out;
    for (const std::string& line : lines) {
        const auto step = step_of(line);
        EXPECT_TRUE(step) << line;
        if (step) out.push_back(*step);
    }
    return out;
}

inline std::vector<cl::Record> records_of(const Steps& steps) {
    std::vector<cl::Record> out;
    for (std::uint32_t i = 0; i < steps.size(); ++i) out.push_back({steps[i], {0, i, i + 1}, 0});
    return out;
}

inline Path path_of(const Steps& steps) {
    Path path(1e-4);
    for (const cl::Record& r : records_of(steps)) path.take(r);
    return path;
}

inline Result compared(const Steps& a, const Steps& b, const Tolerance& tolerance = {}) {
    return compare(path_of(a), path_of(b), tolerance);
}

/// Names of the aspects in which the two differ.
inline std::string differences(const Steps& a, const Steps& b) {
    std::string out;
    for (const Difference& d : compared(a, b).first) out += (out.empty() ? "" : " ") + std::string(name_of(d.aspect));
    return out;
}

/// All lines, for whoever has to find out what went wrong.
inline std::string text_of(const Steps& steps) {
    std::string out;
    for (const cl::Step& step : steps) out += line_of(step) + "\n";
    return out;
}

class AnyStream {
public:
    explicit AnyStream(std::uint32_t seed) : random_(seed) {}

    double number(double low, double high) {
        const auto thousandths = static_cast<int>((high - low) * 1000);
        return low + std::uniform_int_distribution<int>(0, thousandths)(random_) / 1000.0;
    }
    std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
    bool one_in(std::size_t n) { return below(n) == 0; }
    geom::Vec3 place() { return {number(-50, 50), number(-50, 50), number(-20, 20)}; }

    /// Lines, arcs, helices and what holds on the way.
    Steps any(std::size_t n) {
        Steps out;
        for (std::size_t i = 0; i < n; ++i) add_any(out);
        return out;
    }
    /// The same way with more points on it, said again and again, with remarks.
    Steps cut(const Steps& steps, std::size_t one_of = 2);

private:
    void add_any(Steps& out);
    void add_arc(Steps& out);
    void cut_arc(Steps& out, const cl::Arc& arc, const geom::Vec3& from);

    std::mt19937 random_;
    geom::Vec3 at_;
};

inline void AnyStream::add_arc(Steps& out) {
    const double radius = number(1, 30), begin = number(-3, 3), sweep = number(-6, 6);
    if (std::abs(sweep) < 0.05) return;
    const geom::Vec3 out_there{radius * std::cos(begin), radius * std::sin(begin), 0};
    cl::Arc arc;
    arc.centre = at_ - out_there;
    arc.sweep = sweep;
    arc.to = arc.centre + geom::Vec3{radius * std::cos(begin + sweep), radius * std::sin(begin + sweep), 0};
    if (one_in(2)) arc.to.z += number(-5, 5);
    at_ = arc.to;
    out.emplace_back(arc);
}

inline void AnyStream::add_any(Steps& out) {
    static const Steps between =
        steps_of({"feed 100 mm/min", "feed 250 mm/min", "feed 0.2 mm/rev", "spindle 1000 1/min cw limit 0",
                  "spindle 1500 1/min ccw limit 0", "coolant flood", "coolant off", "dwell 0.5 0", "stop optional",
                  "aux \"M\" 25", "tool 2 edge 1 \"\"", "tool 3 edge 1 \"\"", "comment \"here\"",
                  "tolerance 0.05 rotary 0 finishing", "path exact", "path free", "frame shift 1 2 3"});
    const std::size_t kind = out.empty() ? 0 : below(10);  // the first is a line: from there all is known
    if (kind < 5) {
        at_ = place();
        out.emplace_back(cl::Linear{at_, {0, 0, 1}, one_in(4), cl::Seek::nothing});
    } else if (kind < 7) {
        add_arc(out);
    } else {
        out.push_back(between[below(between.size())]);
    }
}

inline void AnyStream::cut_arc(Steps& out, const cl::Arc& arc, const geom::Vec3& from) {
    const double share = number(0.1, 0.9);
    const geom::Vec3 r = from - arc.centre;
    const double a = share * arc.sweep;
    cl::Arc head = arc, rest = arc;
    head.to = arc.centre + geom::Vec3{r.x * std::cos(a) - r.y * std::sin(a), r.x * std::sin(a) + r.y * std::cos(a), 0};
    head.to.z = from.z + share * (arc.to.z - from.z);
    head.sweep = a;
    rest.sweep = arc.sweep - a;
    out.emplace_back(head);
    out.emplace_back(rest);
}

inline Steps AnyStream::cut(const Steps& steps, std::size_t one_of) {
    static const Steps remarks = steps_of({"comment \"x\"", "comment \"another\""});
    Steps out;
    std::optional<geom::Vec3> at;
    std::optional<cl::Step> modal;
    for (const cl::Step& step : steps) {
        const auto* line = std::get_if<cl::Linear>(&step);
        const auto* arc = std::get_if<cl::Arc>(&step);
        if (one_in(one_of)) out.push_back(remarks[below(remarks.size())]);
        if (modal && one_in(one_of)) out.push_back(*modal);
        if (line != nullptr && at && !line->rapid && one_in(one_of)) {
            cl::Linear head = *line;
            head.to = *at + number(0.1, 0.9) * (line->to - *at);
            out.emplace_back(head);
        }
        if (arc != nullptr && at && one_in(one_of))
            cut_arc(out, *arc, *at);
        else
            out.push_back(step);
        if (line != nullptr && one_in(one_of)) out.push_back(step);  // it stands there
        if (line != nullptr) at = line->to;
        if (arc != nullptr) at = arc->to;
        if (std::holds_alternative<cl::Feed>(step) || std::holds_alternative<cl::Spindle>(step)) modal = step;
        if (std::holds_alternative<cl::Stop>(step)) modal.reset();
        if (std::holds_alternative<cl::ToolChange>(step)) at.reset();  // its tip is elsewhere
    }
    return out;
}

}  // namespace obrys::compare
