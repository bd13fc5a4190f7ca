#pragma once
/// What holds of every program tree, whatever text it was read from: spans lie
/// inside the text, numbers inside their tables. Aborts where it does not, so
/// that a fuzzer sees it.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "program/unit.hpp"

namespace obrys::fuzz {

using program::Code;
using program::ExprKind;
using program::StatementKind;

inline void require(bool holds) {
  if (!holds)
    std::abort();
}

inline void check_span(const base::Span &s, std::size_t size) {
  require(s.begin <= s.end && s.end <= size);
}

inline void check_expr(const program::Unit &u, program::ExprId id) {
  require(id == program::no_expr || id < u.exprs.size());
}

inline void check_exprs(const program::Unit &u, std::size_t size) {
  for (std::size_t i = 0; i < u.exprs.size(); ++i) {
    const program::Expr &e = u.exprs[i];
    check_span({u.file, e.begin, e.end}, size);
    const bool has_child =
        e.kind == ExprKind::parameter_at || e.kind == ExprKind::unary ||
        e.kind == ExprKind::binary || e.kind == ExprKind::qualified;
    if (e.kind == ExprKind::number)
      require(e.a < u.numbers.size());
    if (e.kind == ExprKind::text)
      require(e.a < u.texts.size());
    if (has_child)
      require(e.a < i);
    if (e.kind == ExprKind::binary)
      require(e.b < i);
    if (e.count > 0)
      require(std::size_t{e.b} + e.count <= u.children.size());
    for (std::uint32_t k = 0; k < e.count; ++k)
      require(u.children[e.b + k] == program::no_expr ||
              u.children[e.b + k] < i);
  }
}

inline std::size_t table_size(const program::Unit &u, StatementKind kind) {
  switch (kind) {
  case StatementKind::for_:
  case StatementKind::endfor:
    return u.fors.size();
  case StatementKind::case_:
    return u.cases.size();
  case StatementKind::jump:
    return u.jumps.size();
  case StatementKind::repeat_section:
    return u.sections.size();
  case StatementKind::call:
    return u.calls.size();
  case StatementKind::procedure:
    return u.procedures.size();
  case StatementKind::frame:
    return u.frames.size();
  case StatementKind::define:
    return u.defines.size();
  case StatementKind::return_:
    return u.jumps.size() + 1;
  case StatementKind::label_call:
    return u.label_calls.size();
  case StatementKind::cycle_definition:
    return u.cycles.size();
  case StatementKind::special:
    return u.specials.size();
  case StatementKind::pattern:
    return u.patterns.size();
  case StatementKind::contour:
    return u.contours.size();
  case StatementKind::if_:
  case StatementKind::else_:
  case StatementKind::endif:
  case StatementKind::while_:
  case StatementKind::endwhile:
  case StatementKind::repeat_:
  case StatementKind::until:
  case StatementKind::loop_:
  case StatementKind::endloop:
  case StatementKind::repeat_count:
  case StatementKind::end_repeat_count:
    return u.branches.size();
  case StatementKind::block:
  case StatementKind::label_end:
    return 0;
  }
  return 0;
}

inline void check_word(const program::Unit &u, const program::Word &w,
                       StatementKind kind) {
  const auto at = static_cast<std::size_t>(w.payload);
  switch (program::code_of(w)) {
  case Code::control:
    return require(kind != StatementKind::block && at < table_size(u, kind));
  case Code::named_axis:
  case Code::named_value:
    return require(at < u.named.size());
  case Code::assign:
    return require(at < u.assigns.size());
  case Code::unsupported:
  case Code::unknown:
    return require(at < u.problems.size());
  case Code::modal:
    return;
  case Code::comment:
    return require(at < u.texts.size());
  default:
    break;
  }
  if (program::form_of(w) == program::Form::expression)
    require(at < u.exprs.size());
  if (program::form_of(w) == program::Form::pooled)
    require(at < u.numbers.size());
  require(program::form_of(w) <= program::Form::bare &&
          program::form_of(w) != program::Form::index);
}

inline void check_statements(const program::Unit &u, std::size_t size) {
  std::uint32_t words = 0;
  for (std::uint32_t i = 0; i < u.statements.size(); ++i) {
    const program::Statement &s = u.statements[i];
    check_span(u.span(s), size);
    require(s.first == words);
    words = u.words_end(i);
    require(words >= s.first && words <= u.words.size());
    if (s.kind != StatementKind::block && s.kind != StatementKind::label_end)
      require(words > s.first &&
              program::code_of(u.words[s.first]) == Code::control);
    for (std::uint32_t w = s.first; w < words; ++w) {
      check_span(u.span(s, u.words[w]), size);
      check_word(u, u.words[w], s.kind);
      if (w > s.first)
        require(program::code_of(u.words[w]) != Code::control);
    }
  }
  require(words == u.words.size() || u.statements.empty());
  const auto is_target = [&](std::uint32_t t) {
    return t == program::no_target || t <= u.statements.size();
  };
  for (const auto &b : u.branches)
    check_expr(u, b.condition), require(is_target(b.target));
  for (const auto &f : u.fors)
    check_expr(u, f.variable), check_expr(u, f.from), check_expr(u, f.to),
        require(is_target(f.target));
  for (const auto &[name, places] : u.labels)
    for (const std::uint32_t place : places)
      require(place < u.statements.size());
}

inline void check_tables(const program::Unit &u, std::size_t size) {
  for (const auto &a : u.assigns)
    require(a.target < u.exprs.size() && a.value < u.exprs.size());
  for (const auto &n : u.named)
    check_expr(u, n.index), require(n.value < u.exprs.size());
  for (const auto &p : u.problems)
    check_span(p.where, size);
  for (const auto &p : u.ignored)
    check_span(p.where, size);
  for (const auto &j : u.jumps) {
    check_expr(u, j.condition), check_expr(u, j.destination);
    require(j.target == program::no_target || j.target <= u.statements.size());
  }
  for (const auto &c : u.calls) {
    check_span(c.where, size);
    for (const auto a : c.arguments)
      check_expr(u, a);
    check_expr(u, c.passes), check_expr(u, c.target);
  }
  for (const auto &c : u.label_calls)
    check_expr(u, c.label), check_expr(u, c.repeats);
  for (const auto &c : u.cycles) {
    check_span(c.where, size);
    for (const auto &s : c.settings)
      check_span(s.where, size), check_expr(u, s.value);
    for (const auto t : c.texts)
      check_expr(u, t);
  }
  for (const auto &s : u.specials) {
    check_span(s.where, size);
    for (const auto &d : s.data)
      check_span(d.where, size), check_expr(u, d.value);
  }
  for (const auto &p : u.procedures) {
    check_span(p.where, size);
    for (const auto a : p.arguments)
      check_expr(u, a);
  }
  for (const auto &d : u.defines)
    for (const auto &v : d.variables) {
      check_span(v.where, size);
      for (const auto a : v.values)
        check_expr(u, a);
    }
}

inline void check_unit(const program::Unit &u, std::size_t size) {
  check_exprs(u, size);
  check_statements(u, size);
  check_tables(u, size);
}

/// The one unit that a text was read as, what was said of it, and how likely it
/// is a program of its control.
inline void check_one_part(const std::vector<program::Unit> &units,
                           const base::Sources &sources, std::uint32_t file,
                           const base::Diagnostics &diagnostics, int score) {
  require(units.size() == 1);
  const std::size_t length = sources[file].text.size();
  for (const program::Unit &u : units)
    check_unit(u, length);
  for (const base::Diagnostic &d : diagnostics.all())
    check_span(d.where, length), (void)base::render(d, sources);
  require(score >= 0 && score <= 100);
}

} // namespace obrys::fuzz
