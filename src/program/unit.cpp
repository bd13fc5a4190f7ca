#include "program/unit.hpp"

#include <algorithm>

#include "base/memory.hpp"

namespace obrys::program {

std::optional<NameId> Names::find(std::string_view upper) const {
    if (const auto found = index_.find(upper); found != index_.end()) return found->second;
    return below_ == nullptr ? std::nullopt : below_->find(upper);
}

NameId Names::id(std::string_view upper) {
    if (const auto known = find(upper)) return *known;
    const NameId id = size();
    names_.emplace_back(upper);
    index_.emplace(names_.back(), id);
    return id;
}

base::Span Unit::span(const Statement& s, const Word& w) const {
    const std::uint32_t from = s.begin + w.offset;
    return {file, from, from + w.length};
}

std::span<const Remark> Unit::remarks_of(std::uint32_t statement) const {
    const auto [first, last] =
        std::equal_range(remarks.begin(), remarks.end(), Remark{statement, {}},
                         [](const Remark& a, const Remark& b) { return a.statement < b.statement; });
    return std::span(remarks).subspan(static_cast<std::size_t>(first - remarks.begin()),
                                      static_cast<std::size_t>(last - first));
}

void Unit::reserve(std::size_t bytes) {
    statements.reserve(bytes / 8 + 1);  // lines are seldom shorter on the mean, words never but for a lone M1 or X0
    words.reserve(bytes / 3 + 1);
    base::prefer_large_pages(statements.data(), statements.capacity() * sizeof(Statement));
    base::prefer_large_pages(words.data(), words.capacity() * sizeof(Word));
}

}  // namespace obrys::program
