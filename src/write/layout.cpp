#include "write/layout.hpp"

#include <algorithm>
#include <cstring>

#include "base/number.hpp"
#include "base/text.hpp"
#include "write/printer.hpp"

namespace obrys::write {

namespace {

constexpr std::size_t longest_part = 16u << 20u;  ///< bytes of an open part: what is longer is no subprogram
constexpr std::size_t most_seen = 8;              ///< texts that are looked back for
constexpr std::ptrdiff_t most_forms = 16;         ///< subprograms that one part may come to
constexpr std::size_t longest_name = 20;          ///< characters that every control takes

bool is_ascii(std::string_view s) {
    std::size_t i = 0;
    std::uint64_t any = 0, eight = 0;
    for (; i + sizeof eight <= s.size(); i += sizeof eight) {
        std::memcpy(&eight, s.data() + i, sizeof eight);
        any |= eight;
    }
    for (; i < s.size(); ++i) any |= static_cast<unsigned char>(s[i]);
    return (any & 0x8080808080808080u) == 0;
}

bool is_same(const Note& a, const Note& b) { return a.fate == b.fate && a.from == b.from && a.what == b.what; }

std::vector<std::string_view> words_of(std::string_view block) {
    std::vector<std::string_view> out;
    for (std::size_t at = 0; at < block.size();) {
        const std::size_t end = std::min(block.find(' ', at), block.size());
        if (end > at) out.push_back(block.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

void shift_into(std::vector<Note>& to, const std::vector<Note>& notes, std::uint64_t lines) {
    for (const Note& n : notes) {
        to.push_back(n);
        if (n.file.empty()) to.back().line += lines;
    }
}

}  // namespace

std::string encoded(std::string text, Encoding encoding) {
    const auto beyond = [](char c) { return static_cast<unsigned char>(c) > 0x7F; };
    if (encoding == Encoding::utf8 || std::none_of(text.begin(), text.end(), beyond)) return text;
    text = base::utf8_to_cp1252(base::as_utf8(text), '?');
    if (encoding == Encoding::ascii) std::replace_if(text.begin(), text.end(), beyond, '?');
    return text;
}

Layout::Layout(const Post& post, const std::string& name, Output output) : post_(post), output_(std::move(output)) {
    if (output_.file && post_.own_file)
        form_ = &*post_.own_file;
    else if (post_.subprogram)
        form_ = &*post_.subprogram;
    names_.push_back(base::to_upper(name));
}

bool Layout::append_number(std::string& line, const Lines& lines) const {
    const double number = post_.numbers->first + post_.numbers->step * static_cast<double>(lines.numbered);
    const std::size_t begin = line.size();
    for (const Token& t : post_.numbers->text) {
        line += t.before;
        if (t.kind == Token::Kind::word && !write::append_number(line, number, post_.styles[t.style]))
            return line.resize(begin), false;
        line += t.after;
        line += ' ';
    }
    return true;
}

void Layout::append_line(std::string& to, std::string_view block, Lines& lines) const {
    const std::size_t begin = to.size();
    const auto begins = [&](const std::string& word) { return block.starts_with(word); };
    if (post_.numbers && std::none_of(post_.numbers->skip.begin(), post_.numbers->skip.end(), begins)) {
        // Numbers that the control's word cannot hold begin anew.
        if (!append_number(to, lines)) lines.numbered = 0, static_cast<void>(append_number(to, lines));
        ++lines.numbered;
    }
    to += block;
    to += post_.block_end;
    ++lines.lines;
    if (post_.encoding != Encoding::utf8 && !is_ascii(std::string_view(to).substr(begin)))
        to.replace(begin, std::string::npos, encoded(to.substr(begin), post_.encoding));
    to += post_.line_end;
}

void Layout::put(std::string_view block) {
    line_.clear();
    append_line(line_, block, lines_);
    output_.text(line_);
}

Layout::Level* Layout::top() { return levels_.empty() || levels_.back().spilled ? nullptr : &levels_.back(); }

void Layout::block(std::string_view text, const std::vector<std::string>& in_force) {
    Level* level = top();
    flush(level);
    if (level == nullptr) return put(text);
    level->text.blocks.emplace_back(text);
    level->text.in_force.push_back(in_force);
    level->bytes += text.size();
    if (level->bytes > longest_part) spill();
}

std::uint64_t Layout::next() {
    Level* level = top();
    flush(level);
    return (level == nullptr ? lines_.lines : level->text.blocks.size()) + 1;
}

void Layout::note(Note note) {
    if (note.line == 0) note.line = next();
    if (Level* level = top())
        level->text.notes.push_back(std::move(note));
    else
        output_.note(std::move(note));
}

/// A call that waits may be one of several with this pass.
void Layout::open(const cl::PartBegin& part, Note call) { levels_.push_back({part, std::move(call), {}, {}}); }

void Layout::append(Level* level, const Piece& text) {
    flush(level);
    std::vector<Note> notes;
    if (level == nullptr) {
        shift_into(notes, text.notes, lines_.lines);
        for (Note& n : notes) output_.note(std::move(n));
        for (const std::string& block : text.blocks) put(block);
        return;
    }
    shift_into(level->text.notes, text.notes, level->text.blocks.size());
    level->text.blocks.insert(level->text.blocks.end(), text.blocks.begin(), text.blocks.end());
    level->text.in_force.insert(level->text.in_force.end(), text.in_force.begin(), text.in_force.end());
    level->text.in_force.resize(level->text.blocks.size());
    for (const std::string& block : text.blocks) level->bytes += block.size();
}

void Layout::unroll(const Level& closed) {
    Note note = closed.call;
    note.fate = Fate::expanded;
    note.line = 0;
    this->note(std::move(note));
    append(top(), closed.text);
}

void Layout::spill() {
    for (Level& level : levels_) {
        if (level.spilled) continue;
        flush(&level);
        level.spilled = true;
        Note note = level.call;
        note.fate = Fate::expanded;
        note.line = lines_.lines + 1;
        output_.note(std::move(note));
        append(nullptr, std::exchange(level.text, {}));
    }
}

/// Whether blocks that stand already do for a pass: each is the pass's own, or says besides what is in force there.
bool Layout::does_for(const std::vector<std::string>& blocks, const Piece& pass) {
    if (blocks.size() != pass.blocks.size()) return false;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (blocks[i] == pass.blocks[i]) continue;
        if (pass.in_force[i].empty()) return false;
        const auto holds = [&](std::string_view word) {
            return std::find(pass.in_force[i].begin(), pass.in_force[i].end(), word) != pass.in_force[i].end();
        };
        std::vector<std::string_view> needed = words_of(pass.blocks[i]);
        std::erase_if(needed, holds);
        for (const std::string_view word : words_of(blocks[i])) {
            const auto own = std::find(needed.begin(), needed.end(), word);
            if (own != needed.end())
                needed.erase(own);
            else if (!holds(word))
                return false;
        }
        if (!needed.empty()) return false;
    }
    return true;
}

std::optional<std::size_t> Layout::same_as(const Level& closed) const {
    for (std::size_t i = 0; i < subprograms_.size(); ++i)
        if (subprograms_[i].part == closed.part.name && does_for(subprograms_[i].text.blocks, closed.text)) return i;
    return std::nullopt;
}

/// A part that is called is written as a subprogram at its first pass; further forms of it, and passes of repetitions,
/// where the same text comes again.
bool Layout::is_worth_it(const Level& closed) {
    const auto forms = std::count_if(subprograms_.begin(), subprograms_.end(),
                                     [&](const Subprogram& s) { return s.part == closed.part.name; });
    if (forms >= most_forms) return false;
    if (forms == 0 && closed.part.kind != cl::PartKind::repetition) return true;
    const auto seen = std::find_if(seen_.begin(), seen_.end(), [&](const Seen& s) {
        return s.part == closed.part.name && does_for(s.blocks, closed.text);
    });
    if (seen != seen_.end()) return seen_.erase(seen), true;
    seen_.push_back({closed.part.name, closed.text.blocks});
    if (seen_.size() > most_seen) seen_.erase(seen_.begin());
    return false;
}

std::string Layout::name_for(const std::string& part, double number) {
    std::string name;
    for (const char c : base::stem(part))
        if ((base::is_letter(c) || base::is_digit(c) || c == '_') && name.size() < longest_name) name += base::upper(c);
    const bool usable = name.size() > 1 && base::is_letter(name[0]) && base::is_letter(name[1]);
    if (!usable) name = "SUB" + base::fixed(number, 0);
    const std::string plain = name;
    for (int n = 2; std::find(names_.begin(), names_.end(), name) != names_.end(); ++n)
        name = plain + "_" + std::to_string(n);
    names_.push_back(name);
    if (form_->lower)
        for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
}

std::vector<std::string> Layout::blocks_of(const Template& text, const Subprogram& s, std::uint64_t passes) const {
    Values values;
    values.set(Value::number, s.number);
    values.set(Value::passes, static_cast<double>(passes));
    values.set(Text::name, s.name);
    const Printer printer(post_, [](std::string_view) {});
    std::vector<std::string> out;
    for (const Block& block : text)
        if (auto line = printer.whole(block, values)) out.push_back(std::move(*line));
    return out;
}

Layout::Piece Layout::whole(const Subprogram& s) const {
    Piece out;
    out.blocks = blocks_of(form_->begin, s);
    shift_into(out.notes, s.text.notes, out.blocks.size());
    out.blocks.insert(out.blocks.end(), s.text.blocks.begin(), s.text.blocks.end());
    for (std::string& line : blocks_of(form_->end, s)) out.blocks.push_back(std::move(line));
    return out;
}

std::size_t Layout::add(const Level& closed) {
    Subprogram s;
    s.part = closed.part.name;
    s.number = form_->first + static_cast<double>(subprograms_.size());
    s.name = name_for(closed.part.name, s.number);
    s.text = closed.text;
    subprograms_.push_back(std::move(s));
    Subprogram& added = subprograms_.back();
    if (form_->place == SubprogramPlace::end) behind_.push_back(subprograms_.size() - 1);
    if (form_->place == SubprogramPlace::here) {
        flush(nullptr);
        added.lines = lines_.lines + form_->begin.size();
        append(nullptr, whole(added));
    }
    if (form_->place == SubprogramPlace::file) put_file(added);
    return subprograms_.size() - 1;
}

void Layout::put_file(Subprogram& s) {
    for (const std::string& word : blocks_of(form_->file_name, s)) s.file = word;
    s.lines = form_->begin.size();
    const Piece piece = whole(s);
    Lines lines;
    std::string text;
    for (const std::string& block : piece.blocks) append_line(text, block, lines);
    for (Note n : piece.notes) {
        if (n.file.empty()) n.file = s.file;
        output_.note(std::move(n));
    }
    output_.file(s.file, text);
}

void Layout::put_subprograms() {
    flush(nullptr);
    for (const std::size_t i : std::exchange(behind_, {})) append(nullptr, whole(subprograms_[i]));
}

/// What this pass loses or expands, and the one that stands in the subprogram did not.
void Layout::tell_more(Subprogram& s, const Level& closed) {
    for (const Note& n : closed.text.notes) {
        const auto said = [&](const Note& other) { return is_same(n, other); };
        if (n.fate == Fate::mapped || std::any_of(s.text.notes.begin(), s.text.notes.end(), said)) continue;
        s.text.notes.push_back(n);
        if (form_->place == SubprogramPlace::end) continue;
        Note now = n;  // the subprogram is written already
        now.line += s.lines;
        now.file = s.file;
        output_.note(std::move(now));
    }
}

void Layout::call(std::size_t subprogram, const Level& closed) {
    Level* level = top();
    tell_more(subprograms_[subprogram], closed);
    std::optional<Call>& waiting = level == nullptr ? waiting_ : level->waiting;
    if (waiting && waiting->subprogram == subprogram && !form_->repeat.empty()) {
        ++waiting->passes;
        if (!is_same(waiting->notes.back(), closed.call)) waiting->notes.push_back(closed.call);
        return;
    }
    flush(level);
    waiting = Call{subprogram, 1, {closed.call}};
}

void Layout::flush(Level* level) {
    std::optional<Call>& waiting = level == nullptr ? waiting_ : level->waiting;
    if (!waiting) return;
    const Call call = *std::exchange(waiting, std::nullopt);
    const Template& form = call.passes > 1 ? form_->repeat : form_->call;
    Piece piece;
    piece.blocks = blocks_of(form, subprograms_[call.subprogram], call.passes);
    for (Note note : call.notes) {
        note.fate = Fate::mapped;
        note.line = 1;
        piece.notes.push_back(std::move(note));
    }
    append(level, piece);
}

void Layout::close(bool whole) {
    flush(top());
    const Level closed = std::move(levels_.back());
    levels_.pop_back();
    if (closed.spilled) return;
    if (!whole || form_ == nullptr || closed.text.blocks.empty()) return unroll(closed);
    if (const auto same = same_as(closed)) return call(*same, closed);
    if (!is_worth_it(closed)) return unroll(closed);
    call(add(closed), closed);
}

void Layout::finish() { flush(nullptr); }

}  // namespace obrys::write
