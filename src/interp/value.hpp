#pragma once
/// Values of an NC program while it runs, and the variables that hold them.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/whole.hpp"
#include "geom/frame.hpp"
#include "program/unit.hpp"

namespace obrys::interp {

using program::Type;

inline constexpr double unknown_number = std::numeric_limits<double>::quiet_NaN();

/// One value. `number` holds booleans (0, 1), characters, integers and reals; strings and axis names are text.
struct Value {
    Type type = Type::real;
    double number = 0;
    std::shared_ptr<const std::string> text;
    std::shared_ptr<const geom::Frame> frame;

    /// A value that the run cannot know, of any type: its `number` is not a number. It spreads through every
    /// computation, so that nothing made from it is ever taken for true. The text of an unknown text is what can be
    /// shown of it ("?"); an unknown frame leads to positions that are not known.
    [[nodiscard]] static Value unknown(Type type = Type::real);
    /// A text of which `shown` can be shown, with "?" where it is not known.
    [[nodiscard]] static Value unknown_text(std::string shown);
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
/// The character of a code; what lies beyond 0 to 255 is taken for the nearest of these.
[[nodiscard]] inline char character(double code) {
    return static_cast<char>(base::clipped<unsigned char>(code, 0, 255));
}
/// How often something is done that is done at least once (P, REP). No run lasts long enough for more.
[[nodiscard]] inline std::uint64_t times_of(double n) {
    return base::clipped<std::uint64_t>(n, 1, 1'000'000'000'000'000);
}
/// A number as the control writes it with <<: integers without point, reals with at most seven decimals; unknown: "?".
[[nodiscard]] std::string printed(const Value& v);

/// Where the value of a global variable comes from, until the program sets it.
enum class Held : std::uint8_t {
    own,         ///< the program, or the job
    machine,     ///< what the control has kept: not known
    definition,  ///< what its definition says at first, which the control may have overwritten since
    argument,    ///< of the main program, which nobody calls here: not known
};

/// Elements of one type, up to three dimensions; a single variable has the dimensions 1, 1, 1.
struct Array {
    Type type = Type::real;
    std::array<std::uint32_t, 3> dimensions{1, 1, 1};
    int rank = 0;                     ///< number of written dimensions
    std::size_t string_length = 200;  ///< longest text an element may hold
    program::NameId name = 0;         ///< of what is `held`: as it is defined
    std::vector<double> numbers;      ///< of number types
    std::vector<Value> others;        ///< of texts, axes, frames
    std::vector<Held> held;           ///< by element; empty: all are the program's own

    [[nodiscard]] std::size_t size() const { return std::size_t{dimensions[0]} * dimensions[1] * dimensions[2]; }
    /// Elements with what a variable of a program holds at first: 0, FALSE, an empty text, no frame.
    void allocate();
    /// Elements that are not known, for the reason that `why` is.
    void allocate_unknown(Held why);
    [[nodiscard]] Held held_by(std::size_t i) const { return held.empty() ? Held::own : held[i]; }
    [[nodiscard]] Value get(std::size_t i) const;
    void set(std::size_t i, const Value& v);  ///< `v` must be of the array's type already
};

enum class Conversion : std::uint8_t { ok, wrong_type, out_of_range, too_long };
/// Converts for an assignment: reals round to integers, numbers to BOOL by "not zero", texts keep their length limit.
[[nodiscard]] Conversion convert(Value& v, Type to, std::size_t string_length = 200);

}  // namespace obrys::interp
