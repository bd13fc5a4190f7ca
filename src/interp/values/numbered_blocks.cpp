/// Statements by their block numbers.

#include "base/whole.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

std::vector<std::uint32_t> numbered_blocks(const Saying& run, std::int64_t n) {
    const auto [unit, added] = run.block_numbers.try_emplace(&run.unit());
    auto& index = unit->second;
    const auto& statements = run.unit().statements;
    for (std::uint32_t i = 0; added && i < statements.size(); ++i) {
        if ((statements[i].flags & program::line_start) == 0) continue;
        if (const auto number = run.env.sources.block_number(run.unit().file, statements[i].begin))
            index[*number].push_back(i);
    }
    const auto found = index.find(n);
    return found == index.end() ? std::vector<std::uint32_t>{} : found->second;
}

std::vector<std::uint32_t> numbered_statements(const Saying& run, double n) {
    const auto whole = base::whole<std::int64_t>(n, 0, 1'000'000'000);
    if (!whole) return {};
    const auto found = run.unit().labels.find(run.env.names.id("N" + std::to_string(*whole)));
    return found != run.unit().labels.end() ? found->second : numbered_blocks(run, *whole);
}

}  // namespace obrys::interp
