#pragma once
/// Values of an NC program while it runs, and the variables that hold them.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geom/frame.hpp"
#include "program/unit.hpp"

namespace obrys::interp {

using program::Type;

/// One value. `number` holds booleans (0, 1), characters, integers and reals; strings and axis names are text.
struct Value {
    Type type = Type::real;
    double number = 0;
    std::shared_ptr<const std::string> text;
    std::shared_ptr<const geom::Frame> frame;

    /// A value that the run cannot know: a number that is not a number. It spreads through every computation, so that
    /// nothing made from it is ever taken for true.
    [[nodiscard]] static Value unknown();
    [[nodiscard]] bool is_unknown() const;
    [[nodiscard]] static Value real(double v) { return {Type::real, v, nullptr, nullptr}; }
    [[nodiscard]] static Value integer(double v) { return {Type::integer, v, nullptr, nullptr}; }
    [[nodiscard]] static Value boolean(bool v) { return {Type::boolean, v ? 1.0 : 0.0, nullptr, nullptr}; }
    [[nodiscard]] static Value string(std::string s);
    [[nodiscard]] static Value axis(std::string name);
    [[nodiscard]] static Value of_frame(const geom::Frame& f);

    [[nodiscard]] bool is_number() const { return type <= Type::real; }
    [[nodiscard]] bool is_text() const { return type == Type::string || type == Type::axis; }
    [[nodiscard]] const std::string& as_text() const;
    [[nodiscard]] const geom::Frame& as_frame() const;
};

[[nodiscard]] std::string_view name(Type t);
/// A number as the control writes it with <<: integers without point, reals with at most seven decimals; unknown: "?".
[[nodiscard]] std::string printed(const Value& v);

/// Elements of one type, up to three dimensions; a single variable has the dimensions 1, 1, 1.
struct Array {
    Type type = Type::real;
    std::array<std::uint32_t, 3> dimensions{1, 1, 1};
    int rank = 0;                     ///< number of written dimensions
    std::size_t string_length = 200;  ///< longest text an element may hold
    std::vector<double> numbers;
    std::vector<std::string> texts;
    std::vector<geom::Frame> frames;

    [[nodiscard]] std::size_t size() const { return std::size_t{dimensions[0]} * dimensions[1] * dimensions[2]; }
    void allocate();
    [[nodiscard]] Value get(std::size_t i) const;
    void set(std::size_t i, const Value& v);  ///< `v` must be of the array's type already
};

enum class Conversion : std::uint8_t { ok, wrong_type, out_of_range, too_long };
/// Converts for an assignment: reals round to integers, numbers to BOOL by "not zero", texts keep their length limit.
[[nodiscard]] Conversion convert(Value& v, Type to, std::size_t string_length = 200);

}  // namespace obrys::interp
