#pragma once
/// Where the values of a run live: numbered parameters, variables of each call, global data.

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "interp/value.hpp"
#include "program/names.hpp"

namespace obrys::interp {

/// Numbered parameters (R0 …). One that nobody set shows 0; what it really holds is for the reader to ask.
class Parameters {
public:
    explicit Parameters(std::uint32_t count) : values_(count, 0.0), set_(count, 0) {}
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(values_.size()); }
    [[nodiscard]] double get(std::uint32_t n) const { return values_[n]; }
    [[nodiscard]] bool is_set(std::uint32_t n) const { return set_[n] != 0 && set_[n] != known_empty; }
    /// Nobody set it, and it is known that it holds nothing.
    [[nodiscard]] bool is_known_empty(std::uint32_t n) const { return set_[n] == known_empty; }
    void set(std::uint32_t n, double v) {
        values_[n] = v;
        set_[n] = 1;
    }
    /// It holds so much more than before: known or not, it stays that.
    void add(std::uint32_t n, double by) { values_[n] += by; }
    void mark_set(std::uint32_t n) { set_[n] = 1; }
    /// It goes on holding so much more or less than before, and nobody knows how much that is.
    void doubt(std::uint32_t n) { set_[n] = 0; }
    /// As `set`, by the control itself: the program has not assigned it.
    void set_by_control(std::uint32_t n, double v) {
        values_[n] = v;
        set_[n] = 2;
    }
    void set_empty_by_control(std::uint32_t n) {
        values_[n] = 0;
        set_[n] = known_empty;
    }
    [[nodiscard]] bool is_assigned(std::uint32_t n) const { return set_[n] == 1; }
    void forget(std::uint32_t n) {
        values_[n] = 0;
        set_[n] = 0;
    }

private:
    static constexpr std::uint8_t known_empty = 3;
    std::vector<double> values_;
    std::vector<std::uint8_t> set_;
};

/// A name bound to an array, or to one element of it (VAR argument).
struct Binding {
    program::NameId name = 0;
    std::shared_ptr<Array> array;
    std::size_t offset = 0;
    bool element = false;                           ///< only element `offset`
    const program::Variable* definition = nullptr;  ///< the DEF that made it
};

/// Names of one call, or the global ones. Few names are looked through in order, many by an index.
class Scope {
public:
    [[nodiscard]] const Binding* find(program::NameId name) const;
    void bind(Binding b) { bindings_.push_back(std::move(b)); }
    [[nodiscard]] std::size_t size() const { return bindings_.size(); }
    [[nodiscard]] const std::vector<Binding>& bindings() const { return bindings_; }
    void truncate(std::size_t n);
    /// Variables by those that they are copies of.
    using Copies = std::unordered_map<const Array*, std::shared_ptr<Array>>;
    /// Takes copies of the variables in their place; one that `copies` has already is taken from there.
    void have_own(Copies& copies);

private:
    std::vector<Binding> bindings_;
    mutable std::unordered_map<program::NameId, std::size_t> first_;  ///< of the first `indexed_` bindings
    mutable std::size_t indexed_ = 0;
};

/// Index of an element in its array; `indices` has `count` entries. False where an index lies outside.
[[nodiscard]] bool element_index(const Array& a, const double* indices, std::size_t count, std::size_t& result);

/// Variables nobody defined (global data of a control whose definition files are not at hand): what is written is read
/// back, what was never written is unknown.
class Undefined {
public:
    [[nodiscard]] Value get(program::NameId name, std::size_t key) const;
    void set(program::NameId name, std::size_t key, const Value& v);

private:
    std::unordered_map<std::uint64_t, Value> values_;
};

}  // namespace obrys::interp
