#include "interp/variables.hpp"

#include "base/whole.hpp"

namespace obrys::interp {

const Binding* Scope::find(program::NameId name) const {
    for (const Binding& b : bindings_)
        if (b.name == name) return &b;
    return nullptr;
}

bool element_index(const Array& a, const double* indices, std::size_t count, std::size_t& result) {
    result = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double index = k < count ? indices[k] : 0;
        if (!(index >= 0) || index >= a.dimensions[k]) return false;
        result = result * a.dimensions[k] + base::clipped<std::size_t>(index, 0, a.dimensions[k] - 1);
    }
    return count <= 3;
}

namespace {
std::uint64_t key_of(program::NameId name, std::size_t key) { return (std::uint64_t{name} << 32) ^ key; }
}  // namespace

Value Undefined::get(program::NameId name, std::size_t key) const {
    const auto found = values_.find(key_of(name, key));
    return found == values_.end() ? Value::unknown() : found->second;
}

void Undefined::set(program::NameId name, std::size_t key, const Value& v) { values_[key_of(name, key)] = v; }

}  // namespace obrys::interp
