#pragma once
/// Test side only: intermediate files put together, and their listings read.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/float_chars.hpp"
#include "program/read_text_testing.hpp"
#include "read/fusion/listing.hpp"
#include "read/fusion/read.hpp"

namespace obrys::read::fusion::testing {

/// Bytes of a file, record by record.
class Bytes {
public:
  explicit Bytes(bool header = true) {
    if (!header)
      return;
    text("http://www.example.com/namespace/nc/format/compact-nci");
    out_ += std::string(7, '\1');
  }
  Bytes &whole(std::uint32_t v) {
    for (int k = 0; k < 4; ++k)
      out_ += static_cast<char>(v >> 8 * k & 0xFF);
    return *this;
  }
  Bytes &single(float v) { return whole(base::bit_cast<std::uint32_t>(v)); }
  Bytes &real(double v) {
    const auto bits = base::bit_cast<std::uint64_t>(v);
    return whole(static_cast<std::uint32_t>(bits))
        .whole(static_cast<std::uint32_t>(bits >> 32));
  }
  Bytes &text(std::string_view v) {
    whole(static_cast<std::uint32_t>(v.size()));
    out_ += v;
    return *this;
  }
  Bytes &singles(std::initializer_list<double> values) {
    for (const double v : values)
      single(static_cast<float>(v));
    return *this;
  }
  Bytes &parameter(std::string_view name, double v) {
    return whole(15).text(name).real(v);
  }
  Bytes &rapid(double x, double y, double z) {
    return whole(101).singles({x, y, z}).whole(0);
  }
  Bytes &linear(double x, double y, double z, double feed,
                std::uint32_t flags = 0x20000) {
    return whole(100).singles({x, y, z, feed}).whole(flags);
  }
  /// An operation of a mill, in the coordinates of the setup turned about Y by
  /// `tilt` degrees, with its tool.
  Bytes &operation(double cosine = 1, double sine = 0) {
    whole(1034);
    const std::size_t at = out_.size() - 4;
    out_.resize(at + 192);
    put(at + 28, {cosine, 0, sine, 0, 1, 0, -sine, 0, cosine});
    put(at + 76, {1, 0, 0, 0, 1, 0, 0, 0, 1});
    return tool(2, 6, 5000).whole(30).whole(0).whole(0).whole(0);
  }
  Bytes &tool(std::uint32_t number, double diameter, double speed,
              double pitch = 0) {
    const std::size_t at = out_.size();
    out_.resize(at + 264);
    put_whole(at, 1035);
    put_whole(at + 176, number);
    put_real(at + 112, diameter);
    put_real(at + 184, speed);
    put_real(at + 256, pitch);
    put_whole(at + 192, 1);
    put_whole(at + 224, 1);
    return *this;
  }
  Bytes &end_operation() { return whole(31); }
  [[nodiscard]] const std::string &get() const { return out_; }
  [[nodiscard]] std::string listing() const {
    return listing_of(out_, std::size_t{1} << 24).value_or("too long");
  }

private:
  void put_whole(std::size_t at, std::uint32_t v) {
    out_.replace(at, 4, Bytes(false).whole(v).get());
  }
  void put_real(std::size_t at, double v) {
    out_.replace(at, 8, Bytes(false).real(v).get());
  }
  void put(std::size_t at, std::initializer_list<double> singles) {
    const std::string bytes = Bytes(false).singles(singles).get();
    out_.replace(at, bytes.size(), bytes);
  }

  std::string out_;
};

struct Reading : program::testing::ReadText {
  explicit Reading(std::string text) {
    file = sources.add("test.cnc", std::move(text));
    unit = read(file, sources, names, diagnostics);
  }
  explicit Reading(const Bytes &bytes) : Reading(bytes.listing()) {}
  [[nodiscard]] std::string tree() const { return tree_of(unit); }
  [[nodiscard]] std::string messages() const { return all_placed(); }
  [[nodiscard]] std::string problems() const {
    return program::testing::problems_of(unit);
  }

  program::Unit unit;
};

} // namespace obrys::read::fusion::testing
