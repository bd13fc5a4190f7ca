/// Text -> stream as a whole: what must not change when the same contour is
/// written another way.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "base/number.hpp"
#include "cl/text.hpp"
#include "driver/bare_run_testing.hpp"
#include "geom/frame.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::driver {
namespace {

using geom::Vec3;

std::vector<cl::Record> run_sinumerik(const std::string &text,
                                      const shop::Machine &machine = {}) {
  testing::BareRun bare;
  bare.machine = machine;
  const bool ends = text.find("M30") != std::string::npos;
  const auto file =
      bare.sources.add("TEST.MPF", ends ? text : text + "\nM30\n");
  const auto units =
      read::sinumerik::read(file, bare.sources, bare.names, bare.diagnostics);
  std::vector<cl::Record> out;
  const auto outcome =
      bare.run(units.at(0), [&](const cl::Record &r) { out.push_back(r); });
  RC_ASSERT(bare.diagnostics.all().empty());
  RC_ASSERT(outcome.ending == interp::Ending::regular);
  return out;
}

std::vector<cl::Step> moves(const std::vector<cl::Record> &records) {
  std::vector<cl::Step> out;
  for (const cl::Record &r : records)
    if (cl::is_move(r.step))
      out.push_back(r.step);
  return out;
}

/// One block of the contour: where it ends, and how it gets there; arcs are
/// half circles.
struct Block {
  enum class Kind {
    rapid,
    line,
    clockwise,
    counter_clockwise
  } kind = Kind::line;
  int x = 0, y = 0, z = 0; ///< um
};

std::vector<Block> any_contour() {
  const auto n = *rc::gen::inRange<std::size_t>(1, 12);
  std::vector<Block> out;
  int x = 0, y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    Block b;
    b.kind = *rc::gen::element(Block::Kind::rapid, Block::Kind::line,
                               Block::Kind::clockwise,
                               Block::Kind::counter_clockwise);
    b.x = *rc::gen::inRange(-500'000, 500'000);
    b.y = *rc::gen::inRange(-500'000, 500'000);
    b.z = *rc::gen::inRange(-100'000, 100'000);
    if (std::hypot(b.x - x, b.y - y) < 100)
      b.kind = Block::Kind::line;
    x = b.x;
    y = b.y;
    out.push_back(b);
  }
  return out;
}

/// How a contour is written down.
struct Writing {
  double unit = 1; ///< millimetres per programmed unit
  bool incremental = false;
  bool lathe = false;    ///< contour x -> Z, y -> X in G18
  double transverse = 1; ///< X words are this many times the radius
};

std::string written(const std::vector<Block> &contour, const Writing &w) {
  const auto number = [&](double um) {
    return base::fixed(um / 1000 / w.unit, 14);
  };
  const std::string first = w.lathe ? "Z" : "X", second = w.lathe ? "X" : "Y",
                    third = w.lathe ? "Y" : "Z";
  const std::string centre_first = w.lathe ? "K" : "I",
                    centre_second = w.lathe ? "I" : "J";
  std::string out;
  Block at;
  for (const Block &b : contour) {
    const bool arc = b.kind == Block::Kind::clockwise ||
                     b.kind == Block::Kind::counter_clockwise;
    out += b.kind == Block::Kind::rapid       ? "G0 "
           : b.kind == Block::Kind::line      ? "G1 "
           : b.kind == Block::Kind::clockwise ? "G2 "
                                              : "G3 ";
    const double from_x = w.incremental ? at.x : 0,
                 from_y = w.incremental ? at.y : 0,
                 from_z = w.incremental ? at.z : 0;
    out += first + number(b.x - from_x) + " " + second +
           number((b.y - from_y) * w.transverse) + " " + third +
           number(b.z - from_z);
    if (arc)
      out += " " + centre_first + number((b.x - at.x) / 2.0) + " " +
             centre_second + number((b.y - at.y) / 2.0);
    out += "\n";
    at = b;
  }
  return out;
}

const std::string start = "G17 G90 G0 X0 Y0 Z0 F100\n";
const std::string lathe_start = "G18 G90 G0 X0 Y0 Z0 F100\n";

void near(const Vec3 &a, const Vec3 &b) {
  RC_ASSERT(geom::length(a - b) < 1e-6);
}

/// The moves `b` are the moves `a` seen through `frame`.
void same(const std::vector<cl::Step> &a, const std::vector<cl::Step> &b,
          const geom::Frame &frame = {}) {
  RC_ASSERT(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    RC_ASSERT(a[i].index() == b[i].index());
    if (const auto *line = std::get_if<cl::Linear>(&a[i])) {
      near(geom::apply(frame, line->to), std::get<cl::Linear>(b[i]).to);
      RC_ASSERT(line->rapid == std::get<cl::Linear>(b[i]).rapid);
    } else {
      const auto &from = std::get<cl::Arc>(a[i]);
      const auto &to = std::get<cl::Arc>(b[i]);
      near(geom::apply(frame, from.to), to.to);
      near(geom::apply(frame, from.centre), to.centre);
      near(geom::apply_direction(frame, from.normal), to.normal);
      RC_ASSERT(std::abs(from.sweep - to.sweep) < 1e-6);
    }
  }
}

RC_GTEST_PROP(Run, TransMovesTheStream, ()) {
  const auto contour = any_contour();
  const auto v = *rc::gen::container<std::vector<int>>(
      3, rc::gen::inRange(-200'000, 200'000));
  const Vec3 by{v[0] / 1000.0, v[1] / 1000.0, v[2] / 1000.0};
  const std::string text = start + written(contour, {});
  const std::string trans = "TRANS X" + base::fixed(by.x, 3) + " Y" +
                            base::fixed(by.y, 3) + " Z" + base::fixed(by.z, 3) +
                            "\n";
  same(moves(run_sinumerik(text)), moves(run_sinumerik(trans + text)),
       geom::Frame::shift(by));
}

RC_GTEST_PROP(Run, RotTurnsTheStream, ()) {
  const auto contour = any_contour();
  const double angle = *rc::gen::inRange(-360'000, 360'000) / 1000.0;
  const std::string text = start + written(contour, {});
  same(moves(run_sinumerik(text)),
       moves(
           run_sinumerik("G17 ROT RPL=" + base::fixed(angle, 3) + "\n" + text)),
       geom::Frame::rotation(2, geom::radians(angle)));
}

RC_GTEST_PROP(Run, DiametersAreDoubledRadii, ()) {
  const auto contour = any_contour();
  const bool incremental = *rc::gen::arbitrary<bool>();
  const std::string relative = incremental ? "G91\n" : "";
  const auto radii = moves(run_sinumerik(
      lathe_start + relative + written(contour, {1, incremental, true, 1})));
  const auto diameters =
      moves(run_sinumerik("DIAMON\n" + lathe_start + relative +
                          written(contour, {1, incremental, true, 2})));
  same(radii, diameters);
  const double factor =
      incremental ? 1 : 2; // DIAM90: only absolute words are diameters
  same(radii,
       moves(run_sinumerik("DIAM90\n" + lathe_start + relative +
                           written(contour, {1, incremental, true, factor}))));
}

RC_GTEST_PROP(Run, IncrementalIsAbsolute, ()) {
  const auto contour = any_contour();
  same(moves(run_sinumerik(start + written(contour, {}))),
       moves(run_sinumerik(start + "G91\n" +
                           written(contour, {1, true, false, 1}))));
}

RC_GTEST_PROP(Run, InchesAreMillimetres, ()) {
  const auto contour = any_contour();
  const std::string inch = *rc::gen::element<std::string>("G70\n", "G700\n");
  same(moves(run_sinumerik(start + written(contour, {}))),
       moves(run_sinumerik(inch + start +
                           written(contour, {25.4, false, false, 1}))));
}

/// Written contour in, end points out, computed here from the numbers alone.
RC_GTEST_PROP(Run, BlocksEndWhereTheySay, ()) {
  const auto contour = any_contour();
  const auto out = moves(run_sinumerik(start + written(contour, {})));
  RC_ASSERT(out.size() == contour.size() + 1);
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Block &b = contour[i];
    const Vec3 to{b.x / 1000.0, b.y / 1000.0, b.z / 1000.0};
    const auto *line = std::get_if<cl::Linear>(&out[i + 1]);
    near(line != nullptr ? line->to : std::get<cl::Arc>(out[i + 1]).to, to);
    RC_ASSERT((line == nullptr) == (b.kind >= Block::Kind::clockwise));
    if (line == nullptr)
      RC_ASSERT(std::abs(std::get<cl::Arc>(out[i + 1]).sweep -
                         (b.kind == Block::Kind::clockwise ? -geom::pi
                                                           : geom::pi)) < 1e-6);
  }
}

/// What stands in the stream before a move takes the programmed numbers to its
/// point, and that to the machine.
RC_GTEST_PROP(Run, ZerosAndFramesTellHowPointsAreProgrammed, ()) {
  shop::Machine machine;
  machine.datums = {
      {54, {100, 20, -300}}, {55, {-40, 7, -250}}, {56, {0, 0, 1}}};
  const std::vector<std::string> frames{"TRANS X10 Y-3 Z2",
                                        "ATRANS X1 Z5",
                                        "ROT RPL=30",
                                        "AROT Z-40",
                                        "AMIRROR X0",
                                        "ASCALE X2 Y2 Z2",
                                        "TRANS",
                                        "G54",
                                        "G55",
                                        "G56",
                                        ""};
  const auto contour = any_contour();
  std::string text = "G54 G17 G90 G94 F100\n";
  std::vector<Vec3> programmed;
  for (const Block &b : contour) {
    text += *rc::gen::elementOf(frames) + "\n";
    programmed.push_back({b.x / 1000.0, b.y / 1000.0, b.z / 1000.0});
    text += "G1 X" + base::shortest(programmed.back().x) + " Y" +
            base::shortest(programmed.back().y) + " Z" +
            base::shortest(programmed.back().z) + "\n";
  }
  cl::Datum datum;
  geom::Frame frame;
  std::size_t n = 0;
  for (const cl::Record &r : run_sinumerik(text, machine)) {
    if (const auto *d = std::get_if<cl::Datum>(&r.step))
      datum = *d;
    if (const auto *f = std::get_if<cl::Frame>(&r.step)) {
      frame = {};
      for (const cl::FramePart &p : f->parts)
        frame = frame * p.frame;
    }
    const auto *line = std::get_if<cl::Linear>(&r.step);
    if (line == nullptr)
      continue;
    RC_ASSERT(n < programmed.size());
    near(line->to, geom::apply(frame, programmed[n++]));
    RC_ASSERT(datum.origin == machine.datums.at(datum.number));
  }
  RC_ASSERT(n == programmed.size());
}

RC_GTEST_PROP(Run, TextFormReadsBack, ()) {
  const auto records =
      run_sinumerik(start + written(any_contour(), {}) + "M30\n");
  base::Sources sources;
  base::Diagnostics diagnostics;
  const auto back = cl::read_text(
      sources, sources.add("a.cl", cl::to_text(records)), diagnostics);
  RC_ASSERT(diagnostics.all().empty());
  RC_ASSERT(back.size() == records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (std::holds_alternative<cl::Datum>(records[i].step))
      continue; // its place is not known: NaN
    RC_ASSERT(back[i].step == records[i].step);
    RC_ASSERT(back[i].from == records[i].from);
    RC_ASSERT(back[i].stack == records[i].stack);
  }
}

} // namespace
} // namespace obrys::driver
