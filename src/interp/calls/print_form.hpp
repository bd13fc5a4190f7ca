#pragma once
/// Forms that a program prints its results in (FN 16: F-PRINT): lines `"text %9.3LF", Q31;` and keywords.
/// Source: iTNC 530 User's Manual Conversational Programming, "FN 16: F-PRINT: formatted output".
///
/// Formats: %[flags][width][.decimals] and LF (number with decimals), D, LD, I (whole number), S, RS (text), %%
/// (percent sign); flags - + 0 and blank. Keywords: CALL_PATH, M_CLOSE, M_APPEND, L_ENGLISH … L_ALL. Of lines in
/// several languages the English ones are taken. Date and time (HOUR, DAY …) are not known to a run: "?".

#include <string>
#include <string_view>
#include <vector>

#include "base/function_ref.hpp"
#include "interp/value.hpp"

namespace obrys::interp {

struct FilledForm {
    std::string text;                   ///< lines with \n
    bool append = false;                ///< M_APPEND: behind what the file holds already
    bool close = false;                 ///< M_CLOSE: the file is complete; printing to it again begins it anew
    bool clock = false;                 ///< asks for date or time
    std::vector<std::string> problems;  ///< what is not understood, with its line
};

/// `value` gives a parameter by its upper-case name ("Q31", "QS5"); `path` is what CALL_PATH puts in.
[[nodiscard]] FilledForm fill_form(std::string_view form, base::FunctionRef<Value(std::string_view)> value,
                                   std::string_view path);

}  // namespace obrys::interp
