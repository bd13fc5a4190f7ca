#pragma once
/// What the run says of the program: alarms, what it did not check, what it assumes. Private to interp.

#include "interp/axes.hpp"
#include "interp/state.hpp"

namespace obrys::interp {

/// Passes of a loop after which it is looked at again whether it ends.
inline constexpr std::uint64_t passes_between_looks = 1000;

// --- complaints.cpp
/// The control would stop here: the run ends.
void alarm(Saying&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
[[nodiscard]] std::string of_alarm(std::string_view number);  ///< " (alarm 34)"; nothing without a number
/// Something obrys does not know or run: reported once per place; the run goes on.
void unchecked(Saying&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
/// As `unchecked`, once per text wherever it comes up.
void unchecked_once(Saying&, std::string_view code, const base::Span& where, std::string text, std::string remedy = {});
/// Something that is hardly meant so: a warning, once per code and place; the run goes on.
void doubt(Saying&, std::string_view code, const base::Span& where, std::string text, std::string remedy);
/// Something assumed: listed once per text.
void assume(Saying&, const base::Span& where, std::string text, std::string remedy = {});

// --- block_name.cpp
/// "the loop of N96 had run 8000000 passes": the innermost one with many; empty where there is none.
[[nodiscard]] std::string loop_being_run(const Saying&);
/// "N150", or "line 12" where the block has no number.
[[nodiscard]] std::string block_name(const Saying&, const base::Span&);

}  // namespace obrys::interp
