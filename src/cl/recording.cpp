#include "cl/recording.hpp"

#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/whole.hpp"

namespace obrys::cl {

namespace {

/// Before the step of a record: its kind, which is the alternative of Step or that of whole records; its place and its
/// stack.
constexpr std::size_t head_size = sizeof(base::Span) + sizeof(StackId) + 1;
constexpr std::uint8_t stands_whole = 0x7F;  // among the whole records
static_assert(std::variant_size_v<Step> < stands_whole);
/// A Linear as the last one, but for `to`; its other bits say how it is kept.
constexpr std::uint8_t leads_elsewhere = 0x80;
constexpr std::uint8_t follows = 0x40;  // the text of the last record closely, in the same file and stack
/// Bits of a coordinate: it is another one, and is kept as it is, not as millionths.
constexpr std::uint8_t changes(std::size_t axis) { return static_cast<std::uint8_t>(1U << axis); }
constexpr std::uint8_t by_bits(std::size_t axis) { return static_cast<std::uint8_t>(8U << axis); }
constexpr double per_mm = 1e6;
constexpr std::size_t most_of_number = 10;  // bytes of 64 bits, seven in each
constexpr std::size_t most_of_lead = head_size + 3 * most_of_number;

template <class T>
std::byte* put(std::byte* at, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(at, &value, sizeof value);
    return at + sizeof value;
}

template <class T>
const std::byte* get(const std::byte* at, T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(&value, at, sizeof value);
    return at + sizeof value;
}

std::byte* put_head(std::byte* at, const Record& record, std::uint8_t kind) {
    return put(put(put(at, kind), record.from), record.stack);
}

/// Seven bits a byte, the lowest first; the sign is the lowest of all.
std::byte* put_number(std::byte* at, std::int64_t n) {
    auto left = static_cast<std::uint64_t>(n) << 1U ^ static_cast<std::uint64_t>(n >> 63);
    for (; left > 0x7F; left >>= 7U) *at++ = static_cast<std::byte>(left | 0x80U);
    *at++ = static_cast<std::byte>(left);
    return at;
}

const std::byte* get_number(const std::byte* at, std::int64_t& n) {
    std::uint64_t all = 0;
    unsigned shift = 0;
    for (; (*at & std::byte{0x80}) != std::byte{0}; shift += 7)
        all |= static_cast<std::uint64_t>(*at++ & std::byte{0x7F}) << shift;
    all |= static_cast<std::uint64_t>(*at++) << shift;
    n = static_cast<std::int64_t>(all >> 1U ^ (0 - (all & 1U)));
    return at;
}

/// The number of millionths of which the value is made bit by bit; nothing where it is not.
std::optional<std::int64_t> millionths_of(double v) {
    constexpr std::int64_t most = std::int64_t{1} << 52U;
    const auto n = base::cut<std::int64_t>(v * per_mm + (v < 0 ? -0.5 : 0.5), -most, most);
    const bool same = n && static_cast<double>(*n) / per_mm == v && !(v == 0 && std::signbit(v));
    return same ? n : std::nullopt;
}

bool is_same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

std::array<double*, 3> coordinates(geom::Vec3& v) { return {&v.x, &v.y, &v.z}; }

bool is_as(const Linear& line, const Linear& last) {
    const bool as_turned = std::memcmp(&line.axis, &last.axis, sizeof line.axis) == 0;  // NaN and -0 as they are
    return as_turned && line.rapid == last.rapid && line.seek == last.seek && line.ends.empty();
}

template <class T>
inline constexpr bool is_line = std::is_same_v<std::remove_const_t<T>, Linear>;
template <class T>
inline constexpr bool is_arc = std::is_same_v<std::remove_const_t<T>, Arc>;
template <class T>
inline constexpr bool is_thread = std::is_same_v<std::remove_const_t<T>, Thread>;

/// Records that are kept by their bytes: plain memory, and moves that take no axis along.
template <class T>
inline constexpr bool is_kept_small = is_line<T> || is_arc<T> || is_thread<T> ||
                                      (std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(Arc));

/// Calls `f` with what is kept of a record.
template <class T, class F>
void each_kept(T& of, F f) {
    if constexpr (is_line<T>)
        f(of.to), f(of.axis), f(of.rapid), f(of.seek);
    else if constexpr (is_arc<T>)
        f(of.to), f(of.centre), f(of.normal), f(of.sweep), f(of.rapid), f(of.axis);
    else if constexpr (is_thread<T>)
        f(of.to), f(of.pitch), f(of.rigid_tap), f(of.start), f(of.change), f(of.axis);
    else
        f(of);
}

bool takes_none_along(const Step& step) {
    const AxisEnds* ends = ends_of(step);
    return ends == nullptr || ends->empty();
}

/// The alternative `kind` of a step, from its bytes.
template <std::size_t I = 0>
const std::byte* get_step(const std::byte* at, std::uint8_t kind, Step& step) {
    if constexpr (I == std::variant_size_v<Step>) {
        return at;
    } else {
        using T = std::variant_alternative_t<I, Step>;
        if (kind != I) return get_step<I + 1>(at, kind, step);
        if constexpr (is_kept_small<T>) {
            T value{};
            each_kept(value, [&at](auto& field) { at = get(at, field); });
            step = std::move(value);
        }
        return at;
    }
}

}  // namespace

std::byte* Recording::room(std::size_t bytes) {
    if (blocks_.empty() || ends_.back() + bytes > block_size) {
        blocks_.push_back(std::make_unique<std::byte[]>(block_size));
        ends_.push_back(0);
    }
    std::byte* at = blocks_.back().get() + ends_.back();
    ends_.back() += bytes;
    return at;
}

void Recording::take(const Record& record) {
    ++size_;
    const auto* line = std::get_if<Linear>(&record.step);
    Linear& last = std::get<Linear>(last_.line.step);
    if (line != nullptr && is_as(*line, last)) {
        take_line(record);
    } else {
        take_other(record);
        if (line != nullptr && line->ends.empty()) last = *line;
    }
    last_.line.from = record.from, last_.line.stack = record.stack;
}

/// As the last one, but for its place and for where it leads.
void Recording::take_line(const Record& record) {
    constexpr std::uint32_t near = 0x100;
    std::byte* const begin = room(most_of_lead);
    const base::Span &from = record.from, &before = last_.line.from;
    std::uint8_t kind = leads_elsewhere;
    std::byte* at = begin + 1;
    if (from.file == before.file && record.stack == last_.line.stack && from.begin - before.end < near &&
        from.end - from.begin < near) {
        kind |= follows;
        at = put(at, static_cast<std::uint8_t>(from.begin - before.end));
        at = put(at, static_cast<std::uint8_t>(from.end - from.begin));
    } else {
        at = put(put(at, from), record.stack);
    }
    geom::Vec3 to = std::get<Linear>(record.step).to;
    const auto now = coordinates(to), was = coordinates(std::get<Linear>(last_.line.step).to);
    for (std::size_t k = 0; k < now.size(); ++k) {
        if (is_same_bits(*now[k], *was[k])) continue;
        kind |= changes(k);
        *was[k] = *now[k];
        if (const auto n = millionths_of(*now[k])) {
            at = put_number(at, *n - std::exchange(last_.millionths[k], *n));
        } else {
            kind |= by_bits(k);
            at = put(at, *now[k]);
        }
    }
    put(begin, kind);
    ends_.back() -= most_of_lead - static_cast<std::size_t>(at - begin);
}

void Recording::take_other(const Record& record) {
    std::visit(
        [&](const auto& step) {
            using T = std::decay_t<decltype(step)>;
            if constexpr (is_kept_small<T>) {
                if (takes_none_along(record.step)) {
                    std::size_t size = head_size;
                    each_kept(step, [&size](const auto& field) { size += sizeof field; });
                    std::byte* at = put_head(room(size), record, static_cast<std::uint8_t>(record.step.index()));
                    return each_kept(step, [&at](const auto& field) { at = put(at, field); });
                }
            }
            put_head(room(head_size), record, stands_whole);
            whole_.push_back(record);
        },
        record.step);
}

/// The straight move whose kind has been read, from its place on.
const std::byte* Recording::Playback::get_line(const std::byte* at, std::uint8_t kind) {
    Record& line = last_.line;
    if ((kind & follows) != 0) {
        std::uint8_t gap = 0, size = 0;
        at = get(get(at, gap), size);
        line.from.begin = line.from.end + gap;
        line.from.end = line.from.begin + size;
    } else {
        at = get(get(at, line.from), line.stack);
    }
    const auto to = coordinates(std::get<Linear>(line.step).to);
    for (std::size_t k = 0; k < to.size(); ++k) {
        if ((kind & changes(k)) == 0) continue;
        if ((kind & by_bits(k)) != 0) {
            at = get(at, *to[k]);
            continue;
        }
        std::int64_t more = 0;
        at = get_number(at, more);
        last_.millionths[k] += more;
        *to[k] = static_cast<double>(last_.millionths[k]) / per_mm;
    }
    return at;
}

bool Recording::Playback::step(Sink sink) {
    if (next_ == of_.size_) return false;
    ++next_;
    if (at_ == of_.ends_[block_]) ++block_, at_ = 0;
    const std::byte* const begin = of_.blocks_[block_].get() + at_;
    std::uint8_t kind = 0;
    const std::byte* at = get(begin, kind);
    if ((kind & leads_elsewhere) != 0) {
        at = get_line(at, kind);
        at_ += static_cast<std::size_t>(at - begin);
        sink(last_.line);
        return true;
    }
    Record record;
    at = get(get(at, record.from), record.stack);
    last_.line.from = record.from, last_.line.stack = record.stack;
    if (kind != stands_whole) at = get_step(at, kind, record.step);
    at_ += static_cast<std::size_t>(at - begin);
    if (kind == stands_whole) {
        sink(of_.whole_[whole_++]);
        return true;
    }
    if (std::holds_alternative<Linear>(record.step)) last_.line.step = record.step;
    sink(record);
    return true;
}

}  // namespace obrys::cl
