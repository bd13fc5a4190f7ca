#include "read/sinumerik/statement.hpp"
#include "read/sinumerik/word.hpp"

namespace obrys::read::sinumerik {

namespace {

constexpr int deepest_macro = 8;
constexpr std::size_t longest_line = 1u << 20;

/// Copies bytes [begin, end) of `in`, or `text` in their place.
void append(Expanded& out, const Expanded& in, std::size_t begin, std::size_t end, const std::string* text) {
    if (text != nullptr) {
        out.text += *text;
        out.from.insert(out.from.end(), text->size(), in.from[begin]);
        out.to.insert(out.to.end(), text->size(), in.to[end - 1]);
        return;
    }
    const auto first = static_cast<std::ptrdiff_t>(begin), last = static_cast<std::ptrdiff_t>(end);
    out.text.append(in.text, begin, end - begin);
    out.from.insert(out.from.end(), in.from.begin() + first, in.from.begin() + last);
    out.to.insert(out.to.end(), in.to.begin() + first, in.to.begin() + last);
}

/// The macro whose name begins at `begin`, and where that name ends. A letter with digits is a name of its own too, as
/// in the compact block G0M6.
const std::string* find_macro(const State& s, std::string_view text, std::size_t begin, std::size_t& end) {
    end = begin;
    while (end < text.size() && is_name_part(text[end])) ++end;
    const auto find = [&] {
        const auto found = s.macros.find(base::to_upper(text.substr(begin, end - begin)));
        return found == s.macros.end() ? nullptr : &found->second;
    };
    const std::string* whole = find();
    if (whole != nullptr || end < begin + 2 || !base::is_digit(text[begin + 1])) return whole;
    end = begin + 1;
    while (end < text.size() && base::is_digit(text[end])) ++end;
    return find();
}

/// One pass over a line: replaces macros, keeps strings and the comment. True where something was replaced.
bool replace_once(const State& s, const Expanded& in, Expanded& out) {
    bool changed = false, quoted = false;
    const std::string_view text = in.text;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        const std::string* macro = nullptr;
        if (text[i] == '"') quoted = !quoted;
        if (text[i] == ';' && !quoted)
            end = text.size();
        else if (!quoted && text[i] == '$')
            while (end < text.size() && is_name_part(text[end])) ++end;
        else if (!quoted && is_name_start(text[i]))
            macro = find_macro(s, text, i, end);
        append(out, in, i, end, macro);
        changed = changed || macro != nullptr;
        i = end;
    }
    return changed;
}

/// DEFINE itself is not expanded, so that a macro can be defined anew.
bool is_definition(Cursor c) {
    c.skip_blanks();
    if (base::upper(c.peek()) == 'N' && base::is_digit(c.peek(1))) {
        ++c.p;
        while (base::is_digit(c.peek())) ++c.p;
        c.skip_blanks();
    }
    return base::equals_ignoring_case(c.name(), "DEFINE");
}

}  // namespace

void read_define(State& s, const char* from) {
    Cursor& c = s.cursor;
    s.declares = true;
    c.skip_blanks();
    const std::string_view name = c.name();
    if (name.empty()) return fail_here(s, "DEFINE needs a name, found " + here(s), "write DEFINE NAME AS …");
    c.p += name.size();
    c.skip_blanks();
    if (!base::equals_ignoring_case(c.name(), "AS"))
        return fail_here(s, "expected AS in DEFINE, found " + here(s), "write DEFINE NAME AS …");
    c.p += 2;
    if (c.at_end()) return fail(s, from, c.p, "the macro has no text", "write DEFINE NAME AS …");
    const char* text = c.p;
    skip_line(s);
    const std::string upper = base::to_upper(name);
    s.macros[upper] = std::string(text, c.p);
    if (upper.size() > 1 && base::is_digit(upper[1])) s.odd_names = true;
}

bool expand(State& s, Expanded& out) {
    Cursor& c = s.cursor;
    if (is_definition(c)) return false;
    Expanded in;
    in.text.assign(c.p, c.end);
    for (const char* q = c.p; q < c.end; ++q) {
        in.from.push_back(c.from(q));
        in.to.push_back(c.to(q + 1));
    }
    bool changed = false;
    for (int pass = 0;; ++pass) {
        Expanded next;
        if (!replace_once(s, in, next)) break;
        changed = true;
        if (next.text.size() > longest_line) {
            fail(s, c.p, c.end, "the block becomes longer than 1 MiB when its macros are replaced");
            break;
        }
        if (pass == deepest_macro) {
            fail(s, c.p, c.end, "a macro of this line contains itself");
            break;
        }
        in = std::move(next);
    }
    out = std::move(in);
    return changed;
}

}  // namespace obrys::read::sinumerik
