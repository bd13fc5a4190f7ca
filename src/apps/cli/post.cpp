/// obrys post list, new, check, preview.

#include <cstdio>

#include "base/number.hpp"
#include "commands.hpp"
#include "driver/documents/check_post.hpp"
#include "driver/translate.hpp"
#include "milled.hpp"
#include "post_start.hpp"
#include "report/post_page.hpp"
#include "session.hpp"
#include "shop/files/document.hpp"
#include "write/preview.hpp"

namespace obrys::cli {

namespace {

/// Writes the document, unless the file may not be written; exit code 2 then, else `code`.
int deliver_post(const Arguments& a, const driver::Session& s, std::string_view text, int code) {
    std::vector<driver::fs::path> read;
    if (a.post.name.ends_with(".toml")) read.emplace_back(a.post.name);
    for (std::uint32_t file = 0; file < s.sources.size(); ++file) read.emplace_back(s.sources[file].name);
    const std::vector<std::string> why_not =
        driver::refusals({{"--output", a.output.empty() ? "-" : a.output}}, read, a.request.force);
    for (const std::string& line : why_not) std::fprintf(stderr, "obrys: %s\n", line.c_str());
    return why_not.empty() && deliver(a.output, text) ? code : 2;
}

std::string text_of(const shop::Value& table, std::string_view key) {
    const shop::Entry* e = shop::find(table, key);
    return e == nullptr ? "" : e->value.text;
}

int list_posts(const Arguments& a) {
    std::vector<report::PostLine> lines;
    driver::Session s;
    for (const std::string& name : write::shipped_post_names()) {
        const std::string text(write::shipped_post(name)->text);
        const auto post = driver::find_post(name, s);
        const auto root = shop::parse_toml(s.sources.add(name, text), s.sources, s.diagnostics);
        if (!post || !root) return print_diagnostics(s), 2;
        lines.push_back({name, post->title, text_of(*root, "extends"), post->control});
    }
    return deliver_post(a, {}, a.format == "json" ? post_list_json(lines) : post_list_text(lines), 0);
}

/// Post and session; nothing where it cannot be used, which has been said.
std::optional<write::Post> read_named(const Arguments& a, driver::Session& s) {
    auto post = driver::find_post(a.post.name, s);
    if (!post) print_diagnostics(s, base::Severity::warning);
    if (!post || !post->is_canon) return post;
    std::fprintf(stderr,
                 "obrys post: %s has no templates: its calls are those of LinuxCNC (obrys translate --to canon)\n",
                 a.post.name.c_str());
    return std::nullopt;
}

std::string note_line(const write::Note& n, const driver::Session& s) {
    const std::string out = write::sentence_of(n);
    if (!n.in_post) return out;
    const base::Position at = s.sources.position(*n.in_post);
    return s.sources[n.in_post->file].name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": " +
           out;
}

int check_post(const Arguments& a) {
    driver::Session s;
    const auto post = read_named(a, s);
    if (!post) return 2;
    const driver::TriedPost tried = driver::try_post(*post);
    report::PostCheck out{a.post.name, post->title, post->control, tried.has_reader, {}};
    for (const driver::TriedSample& t : tried.samples) {
        report::PostSample row{t.sample.name,
                               t.sample.kind,
                               std::string(driver::name_of(t.outcome)),
                               std::string(driver::name_of(t.read)),
                               t.blocks,
                               {},
                               t.differences};
        for (const write::Note& n : t.notes) row.notes.push_back(note_line(n, s));
        out.samples.push_back(std::move(row));
    }
    const bool unclear = !tried.has_reader || tried.count(driver::ReadBack::unclear) > 0;
    const int code = unclear ? 3 : tried.count(driver::ReadBack::differs) > 0 ? 1 : 0;
    return deliver_post(a, s, a.format == "json" ? post_check_json(out) : post_check_text(out, a.post.all), code);
}

int preview_post(const Arguments& a) {
    driver::Session s;
    const auto post = read_named(a, s);
    if (!post) return 2;
    write::Choice choice;
    for (const std::string& text : a.post.set) {
        const std::size_t at = text.find('=');
        choice[text.substr(0, at)] = *base::parse_double(std::string_view(text).substr(at + 1));
    }
    report::PostSheet sheet{a.post.name, post->title, post->control, {}};
    for (const write::Previewed& p : write::preview(*post, a.post.command, choice)) {
        report::PostRow row{p.command, p.form, p.blocks, {}, p.fault};
        for (const write::ChosenValue& v : p.values) row.values.emplace_back(v.name, base::shortest(v.number));
        sheet.rows.push_back(std::move(row));
    }
    if (sheet.rows.empty()) {
        std::fprintf(
            stderr,
            "obrys post preview: the post has nothing for %s: it is written by other words, by moves, or refused\n",
            a.post.command.c_str());
        return 1;
    }
    return deliver_post(a, s, a.format == "html" ? preview_html(sheet) : preview_text(sheet), 0);
}

}  // namespace

int post(const Arguments& a) {
    switch (a.post.verb) {
        case PostVerb::list: return list_posts(a);
        case PostVerb::make: return deliver_post(a, {}, post_start(a.post.name, a.post.extends), 0);
        case PostVerb::check: return check_post(a);
        case PostVerb::preview: return preview_post(a);
        case PostVerb::none: break;
    }
    return 2;
}

}  // namespace obrys::cli
