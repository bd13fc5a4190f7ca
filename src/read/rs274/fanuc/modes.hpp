#pragma once
/// What the reader knows of the control's state. The run may come to a block by another way than the text (M98, GOTO,
/// block skip), so whatever is asked here is noted with the block that asks: where the run's state is another one the
/// block is read anew (program/modes.hpp). There is no other way to ask.

#include <map>
#include <optional>

#include "base/float_chars.hpp"
#include "program/modes.hpp"
#include "program/word.hpp"

namespace obrys::read::rs274 {

enum class Mode : std::uint8_t {
    inch,  ///< -1: not said, 0, 1
    per_rev,
    incremental,
    polar,  ///< G16
    plane,
    hole,         ///< G number * 10 of the hole cycle in force; 0: none
    back_bore,    ///< … is G87
    rigid,        ///< M29 stood before: the next taps are rigid
    turning,      ///< of the turning cycle in force
    lost,         ///< within polar or cylindrical interpolation, which are not run
    lost_motion,  ///< a motion or hole cycle is in force that is not run
    surface,
    surface_plane,  ///< G17 … G19 when it was switched on
    cylinder_low,
    cylinder_high,  ///< its radius, in the program's unit, as the halves of a double
    to_clearance,   ///< G99 of hole cycles in systems B and C
    cleared_cycle,  ///< a turning cycle is in force, but a code that acts once has cleared its data
    new_cycle,      ///< nothing of the turning cycle has been run yet
    motion,
    threading,     ///< … is a thread
    corner_waits,  ///< a chamfer or corner R stood in the last block, as what it asks of this one
    transformed,   ///< bits of Transformed
    count
};
static_assert(static_cast<std::size_t>(Mode::count) <= program::mode_count);

/// Transformations in force.
enum Transformed : std::uint8_t {
    rotated = 1,
    enlarged = 2,
    mirrored = 4,  ///< << 1, << 2: in X, Y, Z
    tilted = 32
};

[[nodiscard]] constexpr program::ModeSet mode_bit(Mode m) { return program::ModeSet{1} << static_cast<unsigned>(m); }

/// Statements [first, last) of one piece.
struct Piece {
    std::uint32_t first = 0, last = 0;
};

class FanucModes {
public:
    FanucModes() = default;
    FanucModes(const FanucModes&) = delete;
    FanucModes& operator=(const FanucModes&) = delete;

    /// Another program begins: what was noted belongs to the one before.
    void begin_program(const program::Modes& values);
    void begin_block();
    void begin_piece();
    /// The piece's statements. `good`: what it asked counts, too; else a complaint stands in its place.
    void end_piece(program::ModeTable& table, Piece piece, bool good);
    /// Statements that depend on modes as `use` says, behind all others.
    static void add_span(program::ModeTable& table, Piece piece, std::uint32_t use);
    [[nodiscard]] bool has_written() const { return written_ != 0; }
    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }  ///< of the block
    /// All of them at a time: what is laid aside to be put back asks for nothing.
    [[nodiscard]] const program::Modes& all() const { return values_; }
    void put_all(const program::Modes& values) { values_ = values; }

private:
    template <class T, Mode M>
    friend class ModeField;
    friend class UnitMode;
    friend class HoleMode;
    friend class MotionMode;
    friend class RadiusMode;

    [[nodiscard]] std::int32_t get(Mode m) const {
        relied_ |= mode_bit(m) & ~written_;
        return values_[static_cast<std::size_t>(m)];
    }
    /// Whoever looks and does the same for every value relies on nothing.
    [[nodiscard]] std::int32_t peek(Mode m) const { return values_[static_cast<std::size_t>(m)]; }
    void set(Mode m, std::int32_t v) {
        written_ |= mode_bit(m);
        values_[static_cast<std::size_t>(m)] = v;
    }
    std::uint32_t state(program::ModeTable& table, const program::Modes& m);
    std::uint32_t use(program::ModeTable& table, const program::ModeUse& u);

    program::Modes values_{}, before_{};
    mutable program::ModeSet relied_ = 0;  ///< of the block
    program::ModeSet written_ = 0;         ///< of the piece
    std::vector<Piece> pieces_;
    std::map<program::Modes, std::uint32_t> states_;
    std::map<std::array<std::uint32_t, 6>, std::uint32_t> uses_;
    std::uint32_t last_state_ = 0, last_use_ = 0;
};

template <class T, Mode M>
class ModeField {
public:
    explicit ModeField(FanucModes& all) : all_(all) {}
    ModeField(const ModeField&) = delete;
    operator T() const { return static_cast<T>(all_.get(M)); }  // NOLINT(google-explicit-constructor)
    ModeField& operator=(T v) {
        all_.set(M, static_cast<std::int32_t>(v));
        return *this;
    }
    ModeField& operator=(const ModeField&) = delete;

private:
    FanucModes& all_;
};

/// Inch or metric. Where the text has not said it nothing is decided: the run is asked.
class UnitMode {
public:
    explicit UnitMode(FanucModes& all) : all_(all) {}
    [[nodiscard]] std::optional<bool> said() const {
        if (all_.peek(Mode::inch) < 0) return std::nullopt;
        return all_.get(Mode::inch) != 0;
    }
    /// What is refused because nobody has said it depends on that.
    void rely() const { static_cast<void>(all_.get(Mode::inch)); }
    void say(bool inch) { all_.set(Mode::inch, inch ? 1 : 0); }

private:
    FanucModes& all_;
};

/// Most blocks ask for no more than whether the cycle in force is G87, or the motion a thread: that has a mode of its
/// own, so that they do not depend on the rest.
class HoleMode {
public:
    explicit HoleMode(FanucModes& all) : all_(all) {}
    HoleMode(const HoleMode&) = delete;
    operator int() const { return all_.get(Mode::hole); }  // NOLINT(google-explicit-constructor)
    HoleMode& operator=(int v) {
        constexpr int g87 = 870;
        all_.set(Mode::hole, v);
        all_.set(Mode::back_bore, v == g87 ? 1 : 0);
        return *this;
    }
    HoleMode& operator=(const HoleMode&) = delete;
    [[nodiscard]] bool is_back_bore() const { return all_.get(Mode::back_bore) != 0; }

private:
    FanucModes& all_;
};

class MotionMode {
public:
    explicit MotionMode(FanucModes& all) : all_(all) {}
    MotionMode(const MotionMode&) = delete;
    operator program::Modal() const {  // NOLINT(google-explicit-constructor)
        return static_cast<program::Modal>(all_.get(Mode::motion));
    }
    MotionMode& operator=(program::Modal m) {
        all_.set(Mode::motion, static_cast<std::int32_t>(m));
        all_.set(Mode::threading, m == program::Modal::thread ? 1 : 0);
        return *this;
    }
    MotionMode& operator=(const MotionMode&) = delete;
    [[nodiscard]] bool is_thread() const { return all_.get(Mode::threading) != 0; }

private:
    FanucModes& all_;
};

class RadiusMode {
public:
    explicit RadiusMode(FanucModes& all) : all_(all) {}
    [[nodiscard]] double get() const {
        const auto low = static_cast<std::uint32_t>(all_.get(Mode::cylinder_low));
        const auto high = static_cast<std::uint32_t>(all_.get(Mode::cylinder_high));
        return base::bit_cast<double>(std::uint64_t{high} << 32 | low);
    }
    void set(double r) {
        const auto bits = base::bit_cast<std::uint64_t>(r);
        all_.set(Mode::cylinder_low, static_cast<std::int32_t>(bits & 0xFFFFFFFF));
        all_.set(Mode::cylinder_high, static_cast<std::int32_t>(bits >> 32));
    }

private:
    FanucModes& all_;
};

}  // namespace obrys::read::rs274
