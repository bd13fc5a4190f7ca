#pragma once
/// Lines of canonical calls: their counter, the block's number, numbers as rs274 prints them.

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "base/function_ref.hpp"

namespace obrys::write {

/// As printf's fixed point writes it, the sign of a zero too.
[[nodiscard]] std::string decimals(double v, int digits = 4);
/// Four decimals each, ", " between them.
[[nodiscard]] std::string listed(std::initializer_list<double> values);
/// A length that went through millimetres is the number that it was: ties round as they did.
[[nodiscard]] double restored(double v);
/// Values of axes, the first of which is number `from` of X Y Z A B C U V W; `unit`: mm of a length of 1.
[[nodiscard]] std::string canon_axes(std::span<const double> values, std::size_t from, double unit,
                                     std::string_view between);

class CanonCalls {
public:
    explicit CanonCalls(base::FunctionRef<void(std::string_view)> out) : out_(out) {}
    /// Of the block that calls come from now; empty: it has none.
    void set_number(const std::string& n);
    void call(const std::string& what);
    /// What the interpreter says about itself.
    void remark(const std::string& what) { call("COMMENT(\"interpreter: " + what + "\")"); }
    /// A line that is no call.
    void plain(const std::string& line) { out_(line + "\n"); }
    [[nodiscard]] bool any() const { return lines_ > 0; }

private:
    base::FunctionRef<void(std::string_view)> out_;
    std::uint64_t lines_ = 0;
    std::string prefix_ = "N..... ";
};

}  // namespace obrys::write
