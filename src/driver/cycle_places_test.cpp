/// Cycles at patterns and contours of formulas, against the same program
/// written out and against sampled areas.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "base/number.hpp"
#include "driver/bare_run_testing.hpp"
#include "read/heidenhain/read.hpp"

namespace obrys::driver {

namespace {

struct Text {
  std::string name, text;
};

/// Steps of the first program; complaints of the run fail the test.
std::vector<cl::Step> run_texts(const std::vector<Text> &texts,
                                const std::string &about) {
  testing::BareRun bare;
  std::map<std::string, program::Unit, std::less<>> units;
  for (const Text &t : texts) {
    const auto file =
        bare.sources.add(t.name + ".H", t.text, base::BlockNumbers::leading);
    units.emplace(t.name, read::heidenhain::read(file, bare.sources, bare.names,
                                                 bare.diagnostics));
  }
  const auto find = [&](std::string_view name) -> const program::Unit * {
    const auto found = units.find(name);
    return found == units.end() ? nullptr : &found->second;
  };
  std::vector<cl::Step> steps;
  bare.run(
      units.at(texts.front().name),
      [&](const cl::Record &r) { steps.push_back(r.step); }, find);
  for (const base::Diagnostic &d : bare.diagnostics.all())
    EXPECT_TRUE(d.severity != base::Severity::error ||
                d.text.find("too large") != std::string::npos)
        << about << "\n"
        << base::render(d, bare.sources);
  return steps;
}

std::string word(char axis, double v) {
  return std::string(1, axis) + (v < 0 ? "" : "+") + base::fixed(v, 3) + " ";
}

/// Ends of the feed moves that go down.
std::vector<geom::Vec3> holes(const std::vector<cl::Step> &steps) {
  std::vector<geom::Vec3> out;
  for (const cl::Step &s : steps)
    if (const auto *l = std::get_if<cl::Linear>(&s); l != nullptr && !l->rapid)
      out.push_back(l->to);
  return out;
}

constexpr const char *begin = "BEGIN PGM A MM\nTOOL DEF 1 L+0 R+2\nTOOL CALL 1 "
                              "Z S1000\nL X+0 Y+0 Z+100 R0 FMAX M3\n";
constexpr const char *drill = "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 "
                              "Q202=10 Q210=0 Q203=+0 Q204=20 Q211=0\n";
constexpr const char *rough = "CYCL DEF 20 CONTOUR DATA Q1=-5 Q2=1 Q3=+0 Q4=+0 "
                              "Q5=+0 Q6=2 Q7=+50 Q8=0 Q9=+1\n"
                              "CYCL DEF 22 ROUGH-OUT Q10=5 Q11=100 Q12=500 "
                              "Q18=0 Q19=150\nCYCL CALL\nEND PGM A MM\n";

struct Box {
  double x0, y0, x1, y1;
  [[nodiscard]] bool holds(double x, double y) const {
    return x > x0 && x < x1 && y > y0 && y < y1;
  }
  [[nodiscard]] std::string text() const {
    return "BEGIN PGM B MM\nL " + word('X', x0) + word('Y', y0) + "\nL " +
           word('X', x1) + "\nL " + word('Y', y1) + "\nL " + word('X', x0) +
           "\nL " + word('Y', y0) + "\nEND PGM B MM\n";
  }
};

bool holds(char op, bool a, bool b) {
  return op == '|' ? a || b : op == '&' ? a && b : op == '^' ? a != b : a && !b;
}

/// All that the tool cuts at the floor lies in the area; true where it cuts
/// something.
template <class In>
bool cuts_inside(const std::vector<cl::Step> &steps, double radius,
                 const In &in, const std::string &about) {
  geom::Vec3 at;
  bool cuts = false;
  for (const cl::Step &s : steps) {
    const auto *l = std::get_if<cl::Linear>(&s);
    if (l != nullptr && !l->rapid && l->to.z < -4.9)
      for (double t = 0; t <= 1; t += 0.125)
        for (double a = 0.1234; a < 6.4; a += 0.25) {
          const double r = radius - 0.002, x = at.x + t * (l->to.x - at.x),
                       y = at.y + t * (l->to.y - at.y);
          cuts = true;
          EXPECT_TRUE(in(x + r * std::cos(a), y + r * std::sin(a)))
              << about << " at " << x << " " << y;
        }
    if (l != nullptr)
      at = l->to;
    if (const auto *arc = std::get_if<cl::Arc>(&s))
      at = arc->to;
  }
  return cuts;
}

} // namespace

TEST(CyclePlaces, APatternIsItsPointsOneByOne) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-100, 100);
    std::string figures, positions, single;
    for (int i = 0; i < 5; ++i) {
      const double x = std::round(place(random) * 8) / 8,
                   y = std::round(place(random) * 8) / 8;
      const std::string at = word('X', x) + word('Y', y);
      const std::string z = word('Z', std::round(place(random) / 50));
      figures += "POS" + std::to_string(i + 1) + " (" + at + z + ") ";
      positions += "CYCL CALL POS " + at + z + "FMAX\n";
      single += "L " + at + "FMAX M99\n";
    }
    const auto head = std::string(begin) + drill;
    const auto about = "seed " + std::to_string(seed);
    const auto pattern =
        holes(run_texts({{"A", head + "PATTERN DEF " + figures +
                                   "\nCYCL CALL PAT FMAX\nEND PGM A MM\n"}},
                        about));
    EXPECT_EQ(
        pattern,
        holes(run_texts({{"A", head + positions + "END PGM A MM\n"}}, about)))
        << about;
    const auto written =
        holes(run_texts({{"A", head + single + "END PGM A MM\n"}}, about));
    ASSERT_EQ(pattern.size(), written.size()) << about;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      EXPECT_EQ(pattern[i].x, written[i].x) << about;
      EXPECT_EQ(pattern[i].y, written[i].y) << about;
    }
  }
}

TEST(CyclePlaces, AFormulaKeepsTheToolInItsArea) {
  int cut = 0;
  for (unsigned seed = 1; seed <= 120; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> low(0, 30), size(10, 40);
    const auto box = [&] {
      const double x = low(random), y = low(random);
      return Box{x, y, x + size(random), y + size(random)};
    };
    const Box a = box(), b = box(), c = box();
    const char first = "|&\\^"[seed % 4], second = "|&\\^"[seed / 4 % 4];
    const std::string model =
        std::string("BEGIN PGM M MM\nDECLARE CONTOUR QC1 = \"B1\"\nDECLARE "
                    "CONTOUR QC2 = ") +
        "\"B2.H\"\nDECLARE CONTOUR QC3 = \"TNC:\\X\\B3.H\"\nQC9 = ( QC1 " +
        first + " QC2 ) " + second + " QC3\nEND PGM M MM\n";
    const std::string main = std::string(begin) + "SEL CONTOUR \"M\"\n" + rough;
    const auto about =
        "seed " + std::to_string(seed) + " " + first + " " + second;
    const auto steps = run_texts({{"A", main},
                                  {"M", model},
                                  {"B1", a.text()},
                                  {"B2", b.text()},
                                  {"B3", c.text()}},
                                 about);
    cut += cuts_inside(
        steps, 2,
        [&](double x, double y) {
          return holds(second, holds(first, a.holds(x, y), b.holds(x, y)),
                       c.holds(x, y));
        },
        about);
    if (HasFailure())
      return;
  }
  EXPECT_GT(cut, 80);
}

TEST(CyclePlaces, IslandsAreLeftOut) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> low(0, 30), size(10, 40);
    const auto box = [&] {
      const double x = low(random), y = low(random);
      return Box{x, y, x + size(random), y + size(random)};
    };
    const Box a = box(), b = box(), island = box();
    const std::string main =
        std::string(begin) +
        "CONTOUR DEF P1 = \"B1\" P2 = \"B2\" DEPTH5 I3 = \"B3\" DEPTH0\n" +
        rough;
    const auto about = "seed " + std::to_string(seed);
    const auto steps = run_texts({{"A", main},
                                  {"B1", a.text()},
                                  {"B2", b.text()},
                                  {"B3", island.text()}},
                                 about);
    cuts_inside(
        steps, 2,
        [&](double x, double y) {
          return (a.holds(x, y) || b.holds(x, y)) && !island.holds(x, y);
        },
        about);
    if (HasFailure())
      return;
  }
}

} // namespace obrys::driver
