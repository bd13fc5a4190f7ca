#include "check/collect.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "check/group.hpp"

namespace obrys::check {

namespace {

void add_once(std::vector<Note>& notes, Note note) {
    const auto same = std::find_if(notes.begin(), notes.end(), [&](const Note& n) { return n.text == note.text; });
    if (same != notes.end())
        ++same->times;
    else
        notes.push_back(std::move(note));
}

}  // namespace

void Collector::finding(const Move& move, Finding f) {
    if (move.index != last_move_) of_last_move_.clear();
    last_move_ = move.index;
    const bool each_axis = f.code == base::codes::axis_limit;  // one move may leave the travel of several
    if (!of_last_move_.insert(f.code).second && !each_axis) return;
    f.move = move.index;
    f.from = move.from;
    f.to = move.to;
    finding(move.record, std::move(f));
}

void Collector::finding(const cl::Record& record, Finding f) {
    if (!is_placed(f.where)) {
        f.where = record.from;
        f.stack = stacks_.sites(record.stack);
    }
    OfCode& known = per_code_[f.code];
    std::string key = cause_key(f);
    if (!f.cause.empty()) note_site(key, f);
    const auto cause = known.causes.find(key);
    const std::size_t next = result_.findings.size();
    if (cause == known.causes.end()) {
        if (known.causes.size() >= limit_) {
            ++result_.findings_dropped;
            return;
        }
        known.causes.emplace(std::move(key), Kept{next, true});
    } else if (known.details < limit_) {
        ++known.details;
        cause->second = {next, false};
    } else if (!is_worse(f, result_.findings[cause->second.last])) {
        ++result_.findings[cause->second.last].more;
        return;
    } else if (cause->second.only) {
        cause->second = {next, false};
    } else {  // takes the place of the last one, which is counted
        Finding& last = result_.findings[cause->second.last];
        f.more = last.more + 1;
        last = std::move(f);
        return;
    }
    result_.findings.push_back(std::move(f));
}

void Collector::note_site(const std::string& key, const Finding& f) {
    const auto add = [](std::vector<std::uint64_t>& place, const base::Span& span) {
        place.push_back(span.file);
        place.push_back(span.begin);
    };
    std::vector<std::uint64_t> place;
    add(place, f.where);
    for (const base::Span& call : f.stack) add(place, call);
    Sites& sites = result_.sites[key];
    auto at = sites.all.find(place);
    if (at == sites.all.end()) {
        if (sites.all.size() >= Sites::most) {
            sites.more = true;
            return;
        }
        at = sites.all.emplace(std::move(place), Site{f.where, f.stack, {}}).first;
    }
    if (const Amount* a = chief_amount(f)) at->second.worst = std::max(at->second.worst.value_or(a->value), a->value);
}

void Collector::unchecked(const cl::Record& record, std::string text, std::string remedy) {
    add_once(result_.unchecked, {base::codes::not_simulated, std::move(text), std::move(remedy), record.from,
                                 stacks_.sites(record.stack), 1});
}

void Collector::unchecked(std::string text, std::string remedy) {
    add_once(result_.unchecked, {base::codes::not_simulated, std::move(text), std::move(remedy), nowhere, {}, 1});
}

void Collector::assumption(std::string text, base::Span where) {
    add_once(result_.assumptions, {base::codes::assumption, std::move(text), "", where, {}, 1});
}

}  // namespace obrys::check
