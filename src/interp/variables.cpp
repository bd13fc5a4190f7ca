#include "interp/variables.hpp"

#include "base/whole.hpp"

namespace obrys::interp {

const Binding* Scope::find(program::NameId name) const {
    constexpr std::size_t few = 16;
    if (bindings_.size() <= few) {
        for (const Binding& b : bindings_)
            if (b.name == name) return &b;
        return nullptr;
    }
    for (; indexed_ < bindings_.size(); ++indexed_) first_.try_emplace(bindings_[indexed_].name, indexed_);
    const auto found = first_.find(name);
    return found == first_.end() ? nullptr : &bindings_[found->second];
}

void Scope::truncate(std::size_t n) {
    bindings_.resize(n);
    if (n >= indexed_) return;
    first_.clear();
    indexed_ = 0;
}

void Scope::have_own(Copies& copies) {
    for (Binding& b : bindings_) {
        std::shared_ptr<Array>& copy = copies[b.array.get()];
        if (copy == nullptr) copy = std::make_shared<Array>(*b.array);
        b.array = copy;
    }
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
