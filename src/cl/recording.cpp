#include "cl/recording.hpp"

#include <cstring>
#include <type_traits>
#include <utility>

namespace obrys::cl {

namespace {

/// Before the step of a record: its place, its stack and its kind, which is the alternative of Step or one of these
/// two.
constexpr std::size_t head_size = sizeof(base::Span) + sizeof(StackId) + 1;
constexpr std::uint8_t leads_elsewhere = 0xFF;  // a Linear as the last one, but for `to`
constexpr std::uint8_t stands_whole = 0xFE;     // among the whole records
static_assert(std::variant_size_v<Step> < stands_whole);

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
    return put(put(put(at, record.from), record.stack), kind);
}

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
inline constexpr bool is_kept_small =
    is_line<T> || is_arc<T> || is_thread<T> || (std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(Arc));

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
    if (const auto* line = std::get_if<Linear>(&record.step)) {
        const bool as_last = is_as(*line, line_);
        if (line->ends.empty()) line_ = *line;
        if (as_last) {
            put(put_head(room(head_size + sizeof line->to), record, leads_elsewhere), line->to);
            return;
        }
    }
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

bool Recording::Playback::step(Sink sink) {
    if (next_ == of_.size_) return false;
    ++next_;
    if (at_ == of_.ends_[block_]) ++block_, at_ = 0;
    const std::byte* const begin = of_.blocks_[block_].get() + at_;
    Record record;
    std::uint8_t kind = 0;
    const std::byte* at = get(get(get(begin, record.from), record.stack), kind);
    if (kind == leads_elsewhere) {
        at = get(at, line_.to);
        record.step = line_;
    } else if (kind == stands_whole) {
        sink(of_.whole_[whole_++]);
    } else {
        at = get_step(at, kind, record.step);
        if (const auto* line = std::get_if<Linear>(&record.step)) line_ = *line;
    }
    at_ += static_cast<std::size_t>(at - begin);
    if (kind != stands_whole) sink(record);
    return true;
}

}  // namespace obrys::cl
