/// Nose radius compensation of LinuxCNC with a turning insert of the job: the
/// path is that of the tool table's tool.

#include <gtest/gtest.h>

#include <array>

#include "driver/fanuc_testing.hpp"
#include "read/rs274/read.hpp"
#include "shop/files/linuxcnc/table.hpp"

namespace obrys::driver {
namespace {

struct NoseRun {
  std::string moves, messages;
};

/// The moves and messages of a program that compensates with T1.
NoseRun turn_nose(const std::vector<shop::Tool> &tools,
                  const std::string &before = {},
                  const std::string &word = "G42") {
  testing::BareRun bare;
  bare.tools = tools;
  bare.machine.kind = shop::MachineKind::lathe;
  const std::string text = "G21 G18 G7 G90 G40 G49 G95 G97\n" + before +
                           "T1 M6\nG43\nS800 M3\nG0 X30 Z5\nG0 " + word +
                           " X20\nG1 Z-20 F0.1\nX40\nG0 G40 X60\nM2\n";
  const auto file = bare.sources.add("A.NGC", text);
  const auto units = read::rs274::read_linuxcnc(file, bare.sources, bare.names,
                                                bare.diagnostics);
  NoseRun out;
  const auto take = [&](const cl::Record &r) {
    if (const auto *l = std::get_if<cl::Linear>(&r.step))
      out.moves += (l->rapid ? "rapid " : "feed ") + base::fixed(l->to.x, 3) +
                   " " + base::fixed(l->to.z, 3) + "\n";
  };
  bare.run(units.at(0), take);
  out.messages = bare.messages();
  return out;
}

std::vector<shop::Tool> table_tools(const std::string &lines) {
  base::Sources sources;
  base::Diagnostics diagnostics;
  return shop::read_tbl(sources.add("t.tbl", lines), sources, 1, diagnostics);
}

shop::Tool nose_insert(int orientation, std::uint32_t number = 1,
                       double nose = 0.4) {
  shop::Tool t;
  t.number = number;
  t.kind = shop::ToolKind::turning;
  t.nose_radius = nose;
  t.orientation = orientation;
  return t;
}

/// Each orientation of the job, the table's Q that is the same picture, and
/// where rs274 2.9 with that Q stands at the corner of the contour (X as a
/// radius).
struct NoseTwin {
  int orientation, q;
  const char *corner;
};
constexpr std::array<NoseTwin, 9> nose_twins{{{1, 4, "feed 10.800 -19.200"},
                                              {2, 3, "feed 10.800 -20.000"},
                                              {3, 2, "feed 10.000 -20.000"},
                                              {4, 1, "feed 10.000 -19.200"},
                                              {5, 5, "feed 10.400 -19.200"},
                                              {6, 8, "feed 10.800 -19.600"},
                                              {7, 7, "feed 10.400 -20.000"},
                                              {8, 6, "feed 10.000 -19.600"},
                                              {9, 9, "feed 10.400 -19.600"}}};

std::string twin_line(const NoseTwin &twin, const char *number = "1",
                      const char *diameter = "0.8") {
  return std::string("T") + number + " P" + number + " D" + diameter +
         " I95 J15 Q" + std::to_string(twin.q) + "\n";
}

TEST(NoseOrientation, AnInsertOfTheJobRunsAsItsTwinOfTheToolTable) {
  for (const NoseTwin &twin : nose_twins)
    for (const char *word : {"G42", "G41", "G42 D1", "G42.1 D0.8 L7"}) {
      const NoseRun job = turn_nose({nose_insert(twin.orientation)}, "", word);
      EXPECT_EQ(job.moves,
                turn_nose(table_tools(twin_line(twin)), "", word).moves)
          << twin.orientation << " " << word;
      EXPECT_FALSE(job.moves.empty());
      if (std::string(word) == "G42") {
        EXPECT_NE(job.moves.find(std::string(twin.corner) + "\n"),
                  std::string::npos)
            << job.moves;
      }
    }
}

TEST(NoseOrientation, DTakesItFromTheToolThatItNames) {
  for (const NoseTwin &twin : nose_twins) {
    const std::string table = "T1 P1 D0.8 Q2\n" + twin_line(twin, "2", "1.6");
    const NoseRun job = turn_nose(
        {nose_insert(3), nose_insert(twin.orientation, 2, 0.8)}, "", "G42 D2");
    EXPECT_EQ(job.moves, turn_nose(table_tools(table), "", "G42 D2").moves)
        << twin.orientation;
  }
  // rs274 with T1 of Q2 and D0.8, T2 of Q3 and D1.6.
  const NoseRun second =
      turn_nose({nose_insert(3), nose_insert(2, 2, 0.8)}, "", "G42 D2");
  EXPECT_NE(second.moves.find("feed 11.600 -20.000\n"), std::string::npos)
      << second.moves;
}

TEST(NoseOrientation, G10WritesTheNoseAndSaysWhereTheJobHasAnother) {
  for (const NoseTwin &twin : nose_twins) {
    const std::string g10 = "G10 L1 P1 R0.8 Q" + std::to_string(twin.q) + "\n";
    const NoseRun job = turn_nose({nose_insert(3)}, g10);
    EXPECT_EQ(job.moves,
              turn_nose({nose_insert(twin.orientation, 1, 0.8)}).moves)
        << twin.orientation;
    EXPECT_NE(job.messages.find("another radius R or orientation Q"),
              std::string::npos)
        << job.messages;
  }
  // Without Q the orientation stays.
  EXPECT_EQ(turn_nose({nose_insert(2)}, "G10 L1 P1 R0.8\n").moves,
            turn_nose({nose_insert(2, 1, 0.8)}).moves);
  EXPECT_EQ(turn_nose({nose_insert(2)}, "G10 L1 P1 R0.4 Q3\n")
                .messages.find("another radius"),
            std::string::npos);
}

TEST(NoseOrientation, ABladeHasItsNoseAtTheCornerThatItMoves) {
  using shop::BladeDirection;
  using shop::ReferenceCorner;
  const auto blade = [](BladeDirection direction, ReferenceCorner corner) {
    shop::Tool t = nose_insert(3);
    t.kind = shop::ToolKind::groove;
    t.width = 3;
    t.corner_radius = 0.4;
    t.direction = direction;
    t.reference = corner;
    return t;
  };
  const auto as = [](int orientation) {
    return turn_nose({nose_insert(orientation)}).moves;
  };
  EXPECT_EQ(
      turn_nose({blade(BladeDirection::out, ReferenceCorner::left)}).moves,
      as(3));
  EXPECT_EQ(
      turn_nose({blade(BladeDirection::out, ReferenceCorner::right)}).moves,
      as(4));
  EXPECT_EQ(turn_nose({blade(BladeDirection::in, ReferenceCorner::left)}).moves,
            as(2));
  EXPECT_EQ(
      turn_nose({blade(BladeDirection::in, ReferenceCorner::right)}).moves,
      as(1));
  EXPECT_EQ(
      turn_nose({blade(BladeDirection::face, ReferenceCorner::left)}).moves,
      as(3));
  EXPECT_EQ(
      turn_nose({blade(BladeDirection::face, ReferenceCorner::right)}).moves,
      as(2));
}

TEST(NoseOrientation, OfAToolOfNoKindItIsSaidToBeUnknown) {
  shop::Tool t = nose_insert(3);
  t.kind = shop::ToolKind::other;
  t.nose_radius = 0;
  t.radius = 0.4;
  const NoseRun job = turn_nose({t});
  EXPECT_NE(job.messages.find("orientation 3 is taken"), std::string::npos)
      << job.messages;
  EXPECT_EQ(job.moves, turn_nose({nose_insert(3)}).moves);
  // The tool table says Q0, none: the control then moves the centre.
  const NoseRun table = turn_nose(table_tools("T1 P1 D0.8\n"));
  EXPECT_EQ(table.messages.find("orientation"), std::string::npos)
      << table.messages;
  EXPECT_EQ(table.moves, turn_nose({nose_insert(9)}).moves);
}

} // namespace
} // namespace obrys::driver
