#pragma once
/// Shared by the tests that hold radius compensation against LinuxCNC's rs274: a program of plain words is run through
/// ContourPath, and the same text by rs274; both give canonical calls and refusals.

#include <string>
#include <vector>

#include "path/compensation/contour_path.hpp"

namespace obrys::path::test {

/// traverse, feed: x y z. arc: end and centre in the plane's axes, turns, end along the normal. flood: 1 on, 0 off.
/// marker: the number of a (MSG,c…) comment.
struct Call {
    enum class Kind { traverse, feed, arc, flood, marker } kind = Kind::feed;
    std::vector<double> values;
    int block = 0;  ///< rs274: the number of the block that made it come out
};
[[nodiscard]] std::string text_of(const Call& c);
/// True where kinds are the same and no value differs by more than the tolerance.
[[nodiscard]] bool same(const Call& a, const Call& b, double tolerance);

/// One stretch of a program from marker to marker, up to its first refusal.
struct Stretch {
    std::vector<Call> calls;
    std::string refusal, block;  ///< the control's words, and the text of the block
};

/// What a program of plain words does here: G0-3 X Y Z I J K R P, G17 G18 G20 G21 G40 G41 G42 G41.1 G42.1 with D and L,
/// G90 G91 G92 G92.1, M0 M2 M6 M8 M9, T, (MSG,c…), subs without parameters called by `o… call` and the parameter #100;
/// everything else is passed over. G41 and G42 take the table's tool.
struct TableTool {
    int number = 0, orientation = 0;
    double diameter = 0;  ///< units of the program
};
[[nodiscard]] std::vector<Stretch> run_here(const std::string& program, const std::vector<TableTool>& table = {});

[[nodiscard]] bool have_rs274();
/// From rs274's output.
[[nodiscard]] std::vector<Stretch> calls_of(const std::string& output);
[[nodiscard]] std::string whole_file(const std::string& path);
[[nodiscard]] std::vector<Stretch> run_rs274(const std::string& program, const std::vector<TableTool>& table = {});

/// The number at `at`, which goes on behind it.
[[nodiscard]] double number(const std::string& text, std::size_t& at);

/// Empty where both agree, else a sentence.
[[nodiscard]] std::string difference(const Stretch& here, const Stretch& there);

}  // namespace obrys::path::test
