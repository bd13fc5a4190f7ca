#pragma once
/// A value that copies share: a copy costs a pointer, whatever stands behind it. It cannot be changed, only replaced.

#include <memory>
#include <utility>

namespace obrys::base {

template <class T>
class SharedValue {
public:
    SharedValue() : value_(none()) {}
    SharedValue(T value) : value_(std::make_shared<const T>(std::move(value))) {}

    [[nodiscard]] const T& operator*() const { return *value_; }
    [[nodiscard]] const T* operator->() const { return value_.get(); }
    /// Copies of one.
    [[nodiscard]] bool is_same(const SharedValue& other) const { return value_ == other.value_; }
    /// Equal values, wherever they stand.
    bool operator==(const SharedValue& other) const { return value_ == other.value_ || *value_ == *other.value_; }

private:
    static const std::shared_ptr<const T>& none() {
        static const std::shared_ptr<const T> value = std::make_shared<const T>();
        return value;
    }
    std::shared_ptr<const T> value_;
};

}  // namespace obrys::base
