#pragma once
/// Identifiers of a run, interned: equal names (case ignored) have equal numbers in every program of the run.

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace obrys::program {

using NameId = std::uint32_t;

class Names {
public:
    Names() = default;
    /// Begins with those of `below`, which must outlive it and must not change any more: many may stand on the same.
    explicit Names(const Names* below) : below_(below), first_(below->size()) {}
    Names(const Names&) = delete;
    Names& operator=(const Names&) = delete;

    /// Number of a name; `upper` must be upper case already.
    NameId id(std::string_view upper);
    [[nodiscard]] std::optional<NameId> find(std::string_view upper) const;
    [[nodiscard]] const std::string& text(NameId id) const {
        return id < first_ ? below_->text(id) : names_[id - first_];
    }
    [[nodiscard]] NameId size() const { return first_ + static_cast<NameId>(names_.size()); }

private:
    const Names* below_ = nullptr;
    NameId first_ = 0;  ///< of the names here
    std::deque<std::string> names_;
    std::unordered_map<std::string_view, NameId> index_;
};

}  // namespace obrys::program
