/// How a program leads the tool in five axes: the tip, how the tool stands, and where the rotary axes are, at the end
/// of every move; and from which zero the points count.
///
/// usage: five_axis PROGRAM
#include <cmath>
#include <cstdio>

#include "obrys/run.hpp"

namespace api = obrys::api;

namespace {

void print(double v) { std::isnan(v) ? std::printf(" ?") : std::printf(" %.3f", v); }

void print(const char* what, const api::Point& p) {
    std::printf("%s", what);
    for (const double v : p) print(v);
}

void print(const api::AxisWay& axis) {
    std::printf(" %s", axis.name.c_str());
    print(axis.from), std::printf(" ->"), print(axis.to);
    std::printf(!axis.rotary ? " mm" : axis.counted ? " deg, counted" : " deg");
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) return 2;
    const api::Image image = api::Workspace::over_disk().prepare(words[1]);
    if (!image.usable()) return 2;
    api::run(image, [](const api::Move& m) {
        std::printf("line %u: %s zero %u", m.where.line, m.rapid ? "rapid" : "feed", m.zero.number);
        print(" tip", m.to);
        print(" tool", m.axis_to);
        for (const api::AxisWay& axis : m.axes)
            if (axis.from != axis.to) print(axis);  // also where nobody knows from where it comes
        std::printf("\n");
    });
}
