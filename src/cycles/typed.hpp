#pragma once
/// Cycles as values of C++: a struct for each, and one table that binds its members to roles. Whatever speaks of a
/// cycle by roles (a control's words, the stream's text, a post) reads and writes the struct by this table; what makes
/// cycles itself fills the struct. A role that is bound twice or a member that is not bound does not compile.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "cycles/course.hpp"

namespace obrys::cycles {

/// One row of the table: the member that holds what the role says.
template <class Cycle>
struct Member {
    Role role = Role::depth;
    double Cycle::*needed = nullptr;  ///< the call must say it
    Said Cycle::*said = nullptr;      ///< it may
    Must must = Must::be_known;

    constexpr Member() = default;
    template <class Part>
    constexpr Member(Role r, double Part::*member, Must m = Must::be_known) : role(r), needed(member), must(m) {}
    template <class Part>
    constexpr Member(Role r, Said Part::*member, Must m = Must::be_known) : role(r), said(member), must(m) {}
    /// Of a part of the cycle.
    template <class Part>
    constexpr explicit Member(const Member<Part>& m) : role(m.role), needed(m.needed), said(m.said), must(m.must) {}
};

template <class Cycle, std::size_t N>
using Members = std::array<Member<Cycle>, N>;

/// The table of a cycle, or of a part that cycles share.
template <class Cycle>
inline constexpr Members<Cycle, 0> members_of{};

namespace detail {

template <class Cycle, std::size_t N>
constexpr std::size_t bytes_of(const Members<Cycle, N>& rows) {
    std::size_t bytes = 0;
    for (const Member<Cycle>& m : rows) bytes += m.said != nullptr ? sizeof(Said) : sizeof(double);
    return bytes;
}

template <class Cycle, std::size_t N>
constexpr bool are_apart(const Members<Cycle, N>& rows) {
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const bool same_needed = rows[i].needed != nullptr && rows[i].needed == rows[k].needed;
            const bool same_said = rows[i].said != nullptr && rows[i].said == rows[k].said;
            if (rows[i].role == rows[k].role || same_needed || same_said) return false;
        }
    return true;
}

}  // namespace detail

/// Rows of the cycle itself.
template <class Cycle, std::size_t N>
constexpr Members<Cycle, N> rows(const Member<Cycle> (&own)[N]) {
    Members<Cycle, N> out;
    std::copy(std::begin(own), std::end(own), out.begin());
    return out;
}

/// Tables of its parts and rows of its own, one behind the other: the order in which a call says its values.
template <class Cycle, class... Part, std::size_t... N>
constexpr auto joined(const Members<Part, N>&... parts) {
    Members<Cycle, (N + ...)> out;
    std::size_t at = 0;
    const auto append = [&](const auto& rows_of_part) {
        for (const auto& m : rows_of_part) out[at++] = Member<Cycle>(m);
    };
    (append(parts), ...);
    return out;
}

/// Members are numbers and nothing else: what the table binds fills the struct where it forgets none.
template <class Cycle>
inline constexpr bool is_bound = detail::bytes_of(members_of<Cycle>) == (std::is_empty_v<Cycle> ? 0 : sizeof(Cycle)) &&
                                 detail::are_apart(members_of<Cycle>);

template <class Cycle>
constexpr auto roles_in_table() {
    std::array<Role, members_of<Cycle>.size()> out{};
    std::transform(members_of<Cycle>.begin(), members_of<Cycle>.end(), out.begin(),
                   [](const Member<Cycle>& m) { return m.role; });
    return out;
}
/// What a call of the cycle can say.
template <class Cycle>
inline constexpr auto roles_of_cycle = roles_in_table<Cycle>();

/// The row of a role, by its number; the number of rows: none has it.
template <class Cycle>
constexpr auto row_numbers() {
    std::array<std::uint8_t, static_cast<std::size_t>(Role::turned_axes) + 1> out{};
    out.fill(static_cast<std::uint8_t>(members_of<Cycle>.size()));
    for (std::size_t i = 0; i < members_of<Cycle>.size(); ++i)
        out[static_cast<std::size_t>(members_of<Cycle>[i].role)] = static_cast<std::uint8_t>(i);
    return out;
}
template <class Cycle>
inline constexpr auto row_number_of = row_numbers<Cycle>();

/// The call as a value; what is missing or out of its range is complained of. What the cycle has no member for it does
/// not look at.
template <class Cycle>
[[nodiscard]] Cycle read(Course& course, const Demand& demand) {
    static_assert(is_bound<Cycle>, "a member without a role, or a role or member that stands twice");
    constexpr auto& table = members_of<Cycle>;
    std::array<Said, table.size() + 1> written;  // the last one: of no member
    for (const cl::CycleValue& v : demand.values)
        written[row_number_of<Cycle>[static_cast<std::size_t>(v.role)]] = v.value;
    Cycle cycle;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Member<Cycle>& m = table[i];
        if (m.needed != nullptr)
            cycle.*m.needed = course.taken(m.role, written[i], m.must);
        else if (written[i])
            cycle.*m.said = course.taken(m.role, written[i], m.must);
    }
    return cycle;
}

/// A value that only another one makes matter (Must::be_asked_for), now that it does.
template <class Cycle, class Part>
double asked(Course& course, const Cycle& cycle, Said Part::*member, Must must) {
    const Said Cycle::*const wanted = member;
    for (const Member<Cycle>& m : members_of<Cycle>)
        if (m.said == wanted) return course.taken(m.role, cycle.*member, must);
    return unknown;
}
/// As above; not written: `otherwise`.
template <class Cycle, class Part>
double asked_or(Course& course, const Cycle& cycle, Said Part::*member, Must must, double otherwise) {
    return cycle.*member ? asked(course, cycle, member, must) : otherwise;
}

/// The values that the call says, in the order of its table.
template <class Cycle>
[[nodiscard]] Demand demand_of(const Cycle& cycle) {
    static_assert(is_bound<Cycle>, "a member without a role, or a role or member that stands twice");
    Demand d{Cycle::kind, {}};
    d.values.reserve(members_of<Cycle>.size());
    for (const Member<Cycle>& m : members_of<Cycle>)
        if (m.needed != nullptr)
            d.values.push_back({m.role, cycle.*m.needed});
        else if (const Said& value = cycle.*m.said)
            d.values.push_back({m.role, *value});
    return d;
}

/// A kind of a room: what its calls can say and what makes the steps.
struct KindRow {
    Kind kind = Kind::probe;
    std::span<const Role> roles{};
    Family family = nullptr;
    bool anywhere = false;  ///< as of Course
};

/// The steps of one cycle; every room has an overload for each of its own.
template <class Cycle>
void expand_typed(Course& course, const Demand& demand, const Situation& situation) {
    write_steps(course, read<Cycle>(course, demand), situation);
}

template <class Cycle>
constexpr KindRow kind_row() {
    return {Cycle::kind, roles_of_cycle<Cycle>, &expand_typed<Cycle>, Cycle::anywhere};
}

/// The row of a kind by its number; a kind that is not of the room has an empty one.
template <class... Cycle>
constexpr auto kind_table() {
    std::array<KindRow, static_cast<std::size_t>(Kind::probe) + 1> out{};
    ((out[static_cast<std::size_t>(Cycle::kind)] = kind_row<Cycle>()), ...);
    return out;
}

}  // namespace obrys::cycles
