/// What the programmer has written for people, in front of what it stands beside.

#include "base/comment.hpp"
#include "base/text.hpp"
#include "rewrite/writing.hpp"

namespace obrys::rewrite {

void Writing::remark(const std::string& text) {
    std::string said = base::comment_text(text, language.comments);
    if (language.encoding != write::Encoding::utf8)
        said = base::without_marks(said, language.encoding == write::Encoding::windows_1252);
    if (const std::string* form = language.find("flow.comment"); form != nullptr && !said.empty())
        say(filled(*form, {{"text", said}}));
    else if (form == nullptr)
        tell(here, "a comment is left out: the control has none");
}

void Writing::remarks(std::uint32_t statement) {
    if (!remarked_.insert({unit, statement}).second) return;  // what is written twice is explained once
    for (const program::Remark& r : unit->remarks_of(statement)) remark(r.text);
    if (unit->statements[statement].kind != StatementKind::block) return;
    for (std::uint32_t w = unit->statements[statement].first; w < unit->words_end(statement); ++w)
        if (program::code_of(unit->words[w]) == program::Code::comment)
            remark(unit->texts[static_cast<std::size_t>(unit->words[w].payload)]);
}

void Writing::tell_missing_remarks() {
    for (const Unit* u : programs)
        for (const program::Remark& r : u->remarks)
            if (remarked_.insert({u, r.statement}).second) {
                notes.push_back({Fate::expanded,
                                 u->span(u->statements[r.statement]),
                                 "a comment is left out: what it stands at is not run, or part of a contour",
                                 {},
                                 0});
            }
}

}  // namespace obrys::rewrite
