#include "rewrite/rewrite.hpp"

#include <algorithm>

#include "base/comment.hpp"
#include "base/text.hpp"
#include "rewrite/frames.hpp"
#include "rewrite/writing.hpp"
#include "write/layout.hpp"

namespace obrys::rewrite {

Writing::Writing(const Input& in, const Language& l) : input(in), language(l), naming(l, *in.names) {}

void Writing::say(std::string text) {
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        std::string line(base::trim(std::string_view(text).substr(from, end - from)));
        for (std::size_t two = line.find("  "); two != std::string::npos; two = line.find("  ")) line.erase(two, 1);
        if (!line.empty()) lines.push_back({std::move(line), here});
        from = end + 1;
    }
}

bool Writing::say(std::string_view key, const Places& places, std::string_view what) {
    const std::string* text = language.find(key);
    if (text == nullptr) {
        refuse(here, source(here) + ": the control has nothing for " + std::string(what));
        return false;
    }
    say(filled(*text, places));
    return true;
}

void Writing::refuse(const base::Span& where, std::string what, std::string remedy) {
    const std::string* comment = language.find("flow.comment");
    if (comment != nullptr)
        say(filled(*comment, {{"text", base::comment_text("NOT TRANSLATED: " + what, language.comments)}}));
    notes.push_back({Fate::lost, where, std::move(what), std::move(remedy), lines.size()});
}

void Writing::tell(const base::Span& where, std::string what) {
    notes.push_back({Fate::expanded, where, std::move(what), {}, lines.size() + 1});
}

std::string Writing::source(const base::Span& where) const {
    constexpr std::size_t longest = 60;
    std::string text(base::trim(input.sources->text(where)));
    text = base::as_utf8(text.substr(0, text.find_first_of("\r\n;")));
    text = std::string(base::trim(text));
    return text.size() > longest ? text.substr(0, longest) + "…" : text;
}

Rewritten Writing::finished(const std::string& name) {
    Rewritten out;
    const auto add = [&](const Line& line, std::size_t& number) {
        const bool plain = line.text[0] == '%' || language.step == 0;
        const std::string text = write::encoded(line.text, language.encoding);
        out.text += plain ? text : std::to_string(number) + " " + text;
        out.text += '\n';
        if (!plain) number += static_cast<std::size_t>(language.step);
        out.lines.emplace_back(out.lines.size() + 1, line.from);
    };
    std::size_t number = 0;
    std::vector<Line> all;
    const auto frame = [&](std::string_view key) {
        if (const std::string* text = language.find(key)) {
            std::vector<Line> kept = std::move(lines);
            lines.clear();
            say(filled(*text, {{"name", name}}));
            all.insert(all.end(), lines.begin(), lines.end());
            lines = std::move(kept);
        }
    };
    here = {input.main->file, input.main->begin, input.main->begin};
    frame("flow.file-begin");
    const std::size_t shift = all.size();
    all.insert(all.end(), lines.begin(), lines.end());
    frame("flow.file-end");
    for (const Line& line : all) add(line, number);
    out.notes = std::move(notes);
    for (Note& note : out.notes)
        if (note.line != 0) note.line += shift;
    out.names = naming.all();
    for (const Unit* u : programs) out.programs.push_back({u->name, program_names_[u], ""});
    return out;
}

/// T prepares a tool, and M6 brings it.
bool Writing::tools_wait() const { return !input.lathe || input.main->traits->changes_on_m6; }

Rewritten Writing::run(const std::string& name) {
    std::vector<const Unit*> open;
    program_names_[input.main] = language.numbered_programs ? "0001" : name;
    const bool endless = !collect(*input.main, open);
    here = {input.main->file, input.main->begin, input.main->begin};
    if (!input.main->parameters.empty())
        refuse(here, "a program with arguments is not translated as the main one",
               "translate the program that calls it");
    if (endless) refuse(here, "programs that call themselves are not translated by structure");
    naming.collect(programs);
    for (const Unit* u : programs) graphs[u] = graph_of(*u, *input.names, *input.sources);
    Held start;
    start[Mode::motion] = several;
    start[Mode::plane] = input.lathe ? 18 : 17;
    start[Mode::distance] = 0;
    start[Mode::across] = input.diameters ? 1 : 0;
    start[Mode::feed] = input.lathe ? 1 : 0;
    for (const Mode m : {Mode::surface, Mode::tool, Mode::prepared, Mode::length, Mode::side}) start[m] = 0;
    start[Mode::radius] = nowhere;
    for (const Mode m : {Mode::cycle, Mode::contour, Mode::pole}) start[m] = nowhere;
    for (const Mode m : frame_modes) start[m] = nowhere;
    modes = held_modes(programs, start, graphs,
                       {tools_wait(), [this](const Unit& u, const program::Call& c) { return callee(u, c); }});
    std::vector<const Unit*> order = programs;
    if (language.subs_first) std::rotate(order.begin(), order.begin() + 1, order.end());
    for (const Unit* u : order) {
        unit = u;
        at = 0;
        here = {u->file, u->begin, u->begin};
        if (u->inch) refuse(here, "programs in inches are not translated by structure");
        if (u->save && u != input.main) saves();
        const std::size_t first = lines.size();
        begin_program(*u, u == input.main);
        const std::size_t top = lines.size();
        if (u == input.main && language.has("flow.main-start"))
            static_cast<void>(say("flow.main-start", {}, "the beginning"));
        begin_frames();
        statements(*u);
        end_program(*u, u == input.main);
        const std::size_t middle = lines.size();
        parts_of_unit();
        if (!rep_keepers_.empty()) begin_repeats(top);
        declare(top);
        if (language.subs_first) parts_first(first, middle);
    }
    say_behind();
    tell_missing_remarks();
    return finished(name);
}

/// Lines behind `middle`, parts of the program that begins at `first`, go in front of it.
void Writing::parts_first(std::size_t first, std::size_t middle) {
    const std::size_t parts = lines.size() - middle, program = middle - first;
    if (parts == 0) return;
    const auto at_line = [this](std::size_t n) { return lines.begin() + static_cast<std::ptrdiff_t>(n); };
    std::rotate(at_line(first), at_line(middle), lines.end());
    for (Note& note : notes)
        if (note.line > middle)
            note.line -= program;
        else if (note.line > first)
            note.line += parts;
}

/// Programs that stand for cycles; in front of all where called ones stand there.
void Writing::say_behind() {
    std::vector<Line> before = std::move(lines);
    lines.clear();
    for (const Line& program : said_behind_) {
        here = program.from;
        say(program.text);
    }
    if (!language.subs_first) std::swap(before, lines);
    const std::size_t shift = language.subs_first ? lines.size() : 0;
    for (Note& note : notes)
        if (note.line != 0) note.line += shift;
    lines.insert(lines.end(), before.begin(), before.end());
}

void Writing::saves() {
    const Held &before = modes.at(unit).front(), &behind = modes.at(unit).back();
    constexpr std::array said{Mode::plane, Mode::distance, Mode::across, Mode::feed, Mode::surface};
    for (const Mode m : said)
        if (before[m] != behind[m] && behind[m] != never_there)
            return refuse(here,
                          unit->name + ": SAVE brings back what the caller had in force, and the program changes it",
                          "say at its end what is to hold then");
}

void Writing::declare(std::size_t top) {
    const std::string* form = language.find("parameters.declare");
    if (form == nullptr) return;
    std::vector<Line> out;
    const std::vector<Argument> arguments = naming.arguments(*unit);
    for (const std::string& name : naming.declared(*unit)) {
        const auto same = [&](const Argument& a) { return a.to == name; };
        if (unit != input.main && std::any_of(arguments.begin(), arguments.end(), same)) continue;
        out.push_back({filled(*form, {{"name", name}}), here});
    }
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(top), out.begin(), out.end());
}

bool Rewritten::loses() const {
    return std::any_of(notes.begin(), notes.end(), [](const Note& n) { return n.fate == Fate::lost; });
}

Rewritten rewrite(const Input& input, const Language& language, const std::string& name) {
    return Writing(input, language).run(name);
}

}  // namespace obrys::rewrite
