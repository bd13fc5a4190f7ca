#pragma once
/// Machine functions that a post names by their numbers: "M29", "M89-150".

#include <algorithm>
#include <cstdint>
#include <vector>

namespace obrys::write {

struct FunctionNumbers {
    char letter = 'M';
    std::int64_t first = 0, last = 0;
};

[[nodiscard]] inline bool is_among(const std::vector<FunctionNumbers>& list, char letter, std::int64_t number) {
    return std::any_of(list.begin(), list.end(), [&](const FunctionNumbers& f) {
        return f.letter == letter && f.first <= number && number <= f.last;
    });
}

}  // namespace obrys::write
