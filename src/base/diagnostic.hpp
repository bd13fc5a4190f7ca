#pragma once
/// Complaints about the input, collected by every stage and printed only by the edge.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.hpp"

namespace obrys::base {

enum class Severity : std::uint8_t { note, warning, error };

[[nodiscard]] std::string_view name(Severity s);
/// Of a severity's name; false where there is none of this name.
[[nodiscard]] bool is_this_or_worse(Severity s, std::string_view named);

/// One more place that belongs to a complaint, e.g. where a loop that never ends begins.
struct Related {
    Span where;
    std::string text;
};

/// One complaint. `code` is one of base/codes.hpp: stable, documented, tested; `text` may be reworded.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string_view code;  ///< static storage: take it from codes::
    Span where;
    std::string text;         ///< what is wrong, in the programmer's words
    std::string remedy;       ///< what to do about it; may be empty
    std::vector<Span> stack;  ///< call sites, innermost first; empty in the main program
    std::vector<Related> related;
};

class Diagnostics {
public:
    /// Adds a complaint. Past `limit` complaints of one code only their number is kept (see `dropped`).
    void add(Diagnostic d);
    [[nodiscard]] bool has_errors() const { return errors_ > 0; }
    [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
    [[nodiscard]] std::size_t dropped() const { return dropped_; }
    void set_limit_per_code(std::size_t n) { limit_ = n; }

private:
    std::vector<Diagnostic> all_;
    std::map<std::string_view, std::size_t> per_code_;
    std::size_t errors_ = 0, dropped_ = 0, limit_ = 1000;
};

/// What is shown of a long call stack: its innermost and its outermost sites, 12 at most.
struct ShownStack {
    std::vector<Span> inner, outer;
    std::size_t left_out = 0;  ///< between them
};
[[nodiscard]] ShownStack shown(const std::vector<Span>& stack);

/// file:line:column: severity: text [code], the source line, a caret under the span, remedy, call stack, related
/// places.
[[nodiscard]] std::string render(const Diagnostic& d, const Sources& sources);

}  // namespace obrys::base
