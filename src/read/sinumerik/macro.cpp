#include "read/sinumerik/statement.hpp"
#include "read/sinumerik/word.hpp"

namespace obrys::read::sinumerik {

namespace {

constexpr int deepest_macro = 8;
constexpr std::size_t longest_line = 1u << 20;

/// One pass over a line: replaces macros, keeps strings and the comment. True where something was replaced.
bool replace_once(const State& s, const Expanded& in, Expanded& out) {
    bool changed = false, quoted = false;
    const std::string_view text = in.text;
    const auto copy = [&](std::size_t begin, std::size_t end) {
        out.text.append(text, begin, end - begin);
        out.from.insert(out.from.end(), in.from.begin() + static_cast<std::ptrdiff_t>(begin), in.from.begin() + static_cast<std::ptrdiff_t>(end));
        out.to.insert(out.to.end(), in.to.begin() + static_cast<std::ptrdiff_t>(begin), in.to.begin() + static_cast<std::ptrdiff_t>(end));
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '"') quoted = !quoted;
        if (text[i] == ';' && !quoted) {
            copy(i, text.size());
            break;
        }
        if (quoted || !is_name_start(text[i]) || (i > 0 && text[i - 1] == '$')) {
            copy(i, i + 1);
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && is_name_part(text[end])) ++end;
        const auto found = s.macros.find(base::to_upper(text.substr(i, end - i)));
        if (found == s.macros.end()) {
            // Letter and digits are a word of their own in a compact block: G0M6
            if (end > i + 1 && base::is_digit(text[i + 1])) {
                end = i + 1;
                while (end < text.size() && base::is_digit(text[end])) ++end;
                const auto word = s.macros.find(base::to_upper(text.substr(i, end - i)));
                if (word == s.macros.end()) {
                    copy(i, end);
                    i = end;
                    continue;
                }
                out.text += word->second.text;
                out.from.insert(out.from.end(), word->second.text.size(), in.from[i]);
                out.to.insert(out.to.end(), word->second.text.size(), in.to[end - 1]);
                changed = true;
                i = end;
                continue;
            }
            copy(i, end);
            i = end;
            continue;
        }
        out.text += found->second.text;
        out.from.insert(out.from.end(), found->second.text.size(), in.from[i]);
        out.to.insert(out.to.end(), found->second.text.size(), in.to[end - 1]);
        changed = true;
        i = end;
    }
    return changed;
}

}  // namespace

void read_define(State& s, const char* from) {
    Cursor& c = s.cursor;
    c.skip_blanks();
    const std::string_view name = c.name();
    if (name.empty()) return fail_here(s, "DEFINE needs a name, found " + here(s), "write DEFINE NAME AS …");
    c.p += name.size();
    c.skip_blanks();
    if (!base::equals_ignoring_case(c.name(), "AS")) return fail_here(s, "expected AS in DEFINE, found " + here(s), "write DEFINE NAME AS …");
    c.p += 2;
    if (c.at_end()) return fail(s, from, c.p, "the macro has no text", "write DEFINE NAME AS …");
    const char* text = c.p;
    skip_line(s);
    const std::string upper = base::to_upper(name);
    s.macros[upper] = {std::string(text, c.p)};
    if (upper.size() > 1 && base::is_digit(upper[1])) s.odd_names = true;
}

bool expand(State& s, Expanded& out) {
    Cursor& c = s.cursor;
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
        if (pass == deepest_macro || next.text.size() > longest_line) {
            fail(s, c.p, c.end, "a macro of this line contains itself");
            break;
        }
        in = std::move(next);
    }
    out = std::move(in);
    return changed;
}

}  // namespace obrys::read::sinumerik
