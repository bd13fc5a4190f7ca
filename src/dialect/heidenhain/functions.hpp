#pragma once
/// FN functions of the iTNC 530 (Klartext `FN 9: IF …`, DIN/ISO `D09`) and the error texts of FN 14. Source: iTNC 530
/// User's Manual Conversational Programming (606 42x), "Programming: Q parameters".

#include <span>
#include <string>

#include "dialect/heidenhain/use.hpp"

namespace obrys::dialect::heidenhain {

struct FnFunction {
    int number = 0;
    Use use = Use::run;
    std::string_view name;  ///< as the control writes it behind the colon; empty where it writes a formula only
    std::string_view text;  ///< what it does, and why it is refused
};

/// Nothing for numbers that are not assigned.
[[nodiscard]] const FnFunction* find_fn(int number);
/// Sorted by number.
[[nodiscard]] std::span<const FnFunction> all_fn();

/// `FN 14: ERROR = 1011`: numbers 1000 … 1099 are the control's own messages, 0 … 299 "FN 14: Error code n", 300 … 999
/// the machine builder's (not known).
struct ErrorText {
    int number = 0;
    std::string_view text;
};
/// Sorted by number.
[[nodiscard]] std::span<const ErrorText> all_errors();
/// Empty where the control has no text of its own for the number.
[[nodiscard]] std::string_view error_text(int number);
/// What FN 14 shows: "ERROR 1005: Start position incorrect".
[[nodiscard]] std::string error_message(int number);

}  // namespace obrys::dialect::heidenhain
