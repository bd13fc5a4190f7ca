#include <algorithm>
#include <map>

#include "report/ledger/ledger.hpp"
#include "report/path.hpp"

namespace obrys::report {

namespace {

constexpr std::string_view style = R"css(
body{margin:0;font:14px/1.4 system-ui,sans-serif;color:#1e2228;display:flex;flex-direction:column;height:100vh}
header{padding:8px 12px;border-bottom:1px solid #c8ccd2}h1{font-size:16px;margin:0}
#entries{max-height:28vh;overflow:auto;border-bottom:1px solid #c8ccd2}
table{border-collapse:collapse;width:100%}td{padding:1px 12px;white-space:nowrap}tr:hover{background:#f0f3f7;cursor:pointer}
#texts{flex:1;display:flex;min-height:0}#texts>section{flex:1;overflow:auto;border-right:1px solid #c8ccd2}
h2{font-size:13px;margin:0;padding:4px 12px;background:#f0f3f7;position:sticky;top:0}
pre{margin:0;font:13px/1.35 ui-monospace,monospace}pre div{padding:0 12px}
pre i{display:inline-block;min-width:4em;color:#8a919b;font-style:normal;user-select:none}
.mapped{color:#1a7f37}.expanded{color:#9a6700}.lost{color:#c0202b}
pre .mapped,pre .expanded,pre .lost{color:inherit;cursor:pointer;border-left:4px solid;padding-left:8px}
pre .mapped{border-color:#1a7f37}pre .expanded{border-color:#d4a72c}pre .lost{border-color:#c0202b}
.now{background:#fff3b0!important}
@media print{body{height:auto;display:block}#entries,#texts>section{max-height:none;overflow:visible}}
)css";

/// Entries know both their lines; a click shows them side by side.
constexpr std::string_view script = R"js(
function show(n){const r=document.querySelector('tr[data-n="'+n+'"]');if(!r)return;
document.querySelectorAll('.now').forEach(e=>e.classList.remove('now'));r.classList.add('now');
for(const id of [r.dataset.a,r.dataset.b]){const e=id&&document.getElementById(id);
if(e){e.classList.add('now');e.scrollIntoView({block:'center'})}}r.scrollIntoView({block:'nearest'})}
document.addEventListener('click',e=>{const t=e.target.closest('[data-n]');if(t)show(t.dataset.n)});
)js";

/// The worst entry of a line, by its number.
struct Mark {
    std::size_t entry = 0;
    base::Fate fate = base::Fate::mapped;
};
using Marks = std::map<std::pair<std::string, std::uint64_t>, Mark>;

void mark(Marks& marks, const std::optional<LedgerPlace>& place, std::size_t entry, base::Fate fate) {
    if (!place) return;
    const auto [at, is_new] = marks.try_emplace({place->file, place->line}, Mark{entry, fate});
    if (!is_new && fate > at->second.fate) at->second = {entry, fate};
}

std::size_t index_in(const std::vector<LedgerText>& texts, const std::string& name) {
    const auto found = std::find_if(texts.begin(), texts.end(), [&](const LedgerText& t) { return t.name == name; });
    return static_cast<std::size_t>(found - texts.begin());
}

std::string id_of(char side, const std::vector<LedgerText>& texts, const std::optional<LedgerPlace>& place) {
    if (!place) return {};
    return side + std::to_string(index_in(texts, place->file)) + "-" + std::to_string(place->line);
}

void put_line(std::string& out, char side, std::size_t text, std::uint64_t line, std::string_view content,
              const Mark* mark) {
    out += "<div";
    if (mark != nullptr) {
        out += " id=\"" + std::string(1, side) + std::to_string(text) + "-" + std::to_string(line) + "\" class=\"" +
               std::string(base::name_of(mark->fate)) + "\" data-n=\"" + std::to_string(mark->entry) + "\"";
    }
    out += "><i>" + std::to_string(line) + "</i>" + escaped(content) + "</div>";
}

void put_texts(std::string& out, char side, const std::vector<LedgerText>& texts, const Marks& marks) {
    out += "<section>";
    for (std::size_t i = 0; i < texts.size(); ++i) {
        out += "<h2>" + escaped(texts[i].name) + "</h2><pre>";
        std::string_view rest = texts[i].text;
        for (std::uint64_t line = 1; !rest.empty(); ++line) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            std::string_view content = rest.substr(0, end);
            if (content.ends_with('\r')) content.remove_suffix(1);
            const auto found = marks.find({texts[i].name, line});
            put_line(out, side, i, line, content, found == marks.end() ? nullptr : &found->second);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        out += "</pre>\n";
    }
    out += "</section>\n";
}

std::string place_text(const std::optional<LedgerPlace>& place) {
    return place ? escaped(place->file) + ":" + std::to_string(place->line) : "";
}

void put_entries(std::string& out, const Ledger& ledger) {
    out += "<div id=\"entries\"><table>\n";
    for (std::size_t i = 0; i < ledger.entries.size(); ++i) {
        const LedgerEntry& e = ledger.entries[i];
        const std::string fate(base::name_of(e.fate));
        out += "<tr data-n=\"" + std::to_string(i) + "\" data-a=\"" + id_of('a', ledger.sources, e.from) +
               "\" data-b=\"" + id_of('b', ledger.outputs, e.to) + "\"><td class=\"" + fate + "\">" + fate +
               "</td><td>" + place_text(e.from) + "</td><td>" + place_text(e.to) + "</td><td>" + escaped(e.what) +
               (e.times > 1 ? " (" + std::to_string(e.times) + " times)" : "") + "</td></tr>\n";
    }
    out += "</table></div>\n";
}

}  // namespace

std::string ledger_html(const Ledger& ledger) {
    Marks from, to;
    for (std::size_t i = 0; i < ledger.entries.size(); ++i) {
        mark(from, ledger.entries[i].from, i, ledger.entries[i].fate);
        mark(to, ledger.entries[i].to, i, ledger.entries[i].fate);
    }
    const std::string title = escaped(ledger.program + " -> " + ledger.output);
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
                      "</title><style>" + std::string(style) + "</style></head><body>\n<header><h1>" + title + "</h1>" +
                      escaped(ledger.control + " -> " + ledger.post + ": " + ledger.proof) +
                      (ledger.written ? "" : ", not written") + "; " + summary(ledger) + "</header>\n";
    put_entries(out, ledger);
    out += "<div id=\"texts\">\n";
    put_texts(out, 'a', ledger.sources, from);
    put_texts(out, 'b', ledger.outputs, to);
    out += "</div>\n<script>" + std::string(script) + "</script></body></html>\n";
    return out;
}

}  // namespace obrys::report
