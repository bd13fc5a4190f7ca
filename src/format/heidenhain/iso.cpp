/// DIN/ISO of the iTNC 530: a block a line, `*` at its end; lines `Q200=2` belong to the cycle before them.

#include <charconv>

#include "base/text.hpp"
#include "format/heidenhain/klartext.hpp"
#include "format/heidenhain/lines.hpp"
#include "format/heidenhain/numbers.hpp"
#include "format/heidenhain/structure.hpp"

namespace obrys::format::heidenhain {

using base::is_digit;
using Text = std::optional<std::string>;

namespace {

/// Number of a word such as G200 or D09; -1 where this is none.
int word_number(std::string_view code, char letter) {
    if (code.size() < 2 || base::upper(code[0]) != letter || !is_digit(code[1])) return -1;
    int n = -1;
    const auto end = std::from_chars(code.data() + 1, code.data() + code.size(), n).ptr;
    return end == code.data() + code.size() || !is_digit(*end) ? n : -1;
}

/// G codes whose words have names or values alone behind them: cycles, contours, programs.
bool is_cycle(int g) {
    const bool words =
        g <= 35 || (g >= 40 && g <= 51) || g == 54 || g == 70 || g == 71 || g == 90 || g == 91 || g == 98 || g == 99;
    return !words;
}

bool iso_word(Scan& in, std::string& word) {
    const char c = in.upper();
    std::string parameter;
    if (in.parameter(parameter)) {
        word = parameter;
        return in.take('=') && in.value(word += '=', Sign::as_written);
    }
    if (c == '\0') return false;
    if (std::string_view("XYZUVWABCIJKH").find(c) != std::string_view::npos) {
        in.step();
        return in.value(word = c, Sign::always);
    }
    if (std::string_view("FRS").find(c) != std::string_view::npos) {
        in.step();
        word = c;
        if (c == 'F' && in.take_word("MAX")) return word += "MAX", true;
        return in.value(word, Sign::as_written);
    }
    if (std::string_view("GMTLDP").find(c) == std::string_view::npos) return false;
    // A letter away from its number is no word here (`M 3`); glued together it would say what was not read.
    const char behind = in.peek(1);
    if (base::is_blank(behind) || ((c == 'G' || c == 'D') && !is_digit(behind))) return false;
    Scan fixed(in.rest(), Decimal::keep);                               // L1,5 names a label and how often
    fixed.step();
    word = c;
    if (!fixed.text(word) && !fixed.value(word, Sign::as_written)) return false;
    in.step(fixed.at());
    return true;
}

Text iso_words(std::string_view code, Decimal decimal) {
    Scan in(code, decimal);
    std::string out;
    while (!in.at_end()) {
        std::string word;
        if (!iso_word(in, word)) return std::nullopt;
        append_word(out, word);
    }
    return out;
}

/// The words of a block without number, `*` and comment.
Text iso_code(std::string_view code, Decimal decimal) {
    if (code.find('~') != std::string_view::npos) return std::nullopt;
    if (const int d = word_number(code, 'D'); d >= 0) {
        const bool words_only = d <= 14 || d == 18 || d == 19;
        const Text t = collapsed(code, words_only);
        return t && words_only ? Text(with_decimals(*t, decimal)) : t;
    }
    if (is_cycle(word_number(code, 'G')) && word_number(code, 'G') >= 0) return collapsed(code, false);
    Scan in(code, decimal);
    std::string parameter, out;
    if (in.parameter(parameter)) {
        in.go_to(0);
        if (code.find('=') == std::string_view::npos) return std::nullopt;
        if (formula_words(in, out)) return out;
        return base::upper(code[1]) == 'S' ? collapsed(code, true) : std::nullopt;
    }
    return iso_words(code, decimal);
}

/// %NAME G71 *: begins and ends a program.
bool frames_program(std::string_view body) {
    return body.starts_with('%') &&
           (body.find("G71") != std::string_view::npos || body.find("G70") != std::string_view::npos);
}

/// How many lines stand before the first block: up to the `%` that begins the program, whatever stands behind its name,
/// with the text in front of it that the control leaves out. None where a numbered block comes first.
std::size_t heading(const std::vector<Line>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Numbered n = split_number(lines[i].text, true);
        if (n.number) return 0;
        if (trim_left(lines[i].text).starts_with('%')) return i + 1;
    }
    return 0;
}

class Iso {
public:
    Iso(std::string_view text, const Options& options)
        : lines_(split_lines(text)),
          options_(options),
          writer_(out_.text, options.line_ends),
          heading_(heading(lines_)) {
        out_.text.reserve(text.size() + text.size() / 8);
    }

    /// No block gets a number that has none.
    void keep_numbers() { count_.keep(); }
    [[nodiscard]] bool numbered() const { return first_numbered_; }

    Formatted run() {
        for (at_ = 0; at_ < lines_.size(); ++at_) {
            const std::string_view text = lines_[at_].text;
            if (at_ < heading_) {
                write(has_control_characters(text) ? text : trim_right(text));
                continue;
            }
            if (open_)
                further_line(text);
            else
                line(text);
            if (!text.empty()) open_ = goes_on(text);
        }
        return std::move(out_);
    }

private:
    void write(std::string_view text) { writer_.line(text, lines_[at_].end); }

    void leave(std::string_view text) {
        out_.left.push_back({static_cast<std::uint32_t>(at_ + 1), std::string(lines_[at_].text)});
        write(text);
    }

    void line(std::string_view line) {
        const Numbered n = split_number(line, true);
        if (n.body.empty() && !n.number) return write(has_control_characters(line) ? line : trim_right(line));
        if (frames_program(n.body)) return write(trim_right(line));
        const bool comment = n.body.starts_with(';');
        if (!n.number && comment) return write(trim_right(line));
        if (!n.number && in_cycle_ && is_cycle_line(n.body) && cycle_parameters(line)) return;
        if (blocks_++ == 0) first_numbered_ = n.number;
        if (!n.understood || (!n.number && first_numbered_)) return leave(line);
        if (comment || n.body.starts_with('*')) {
            Numbered kept = n;
            kept.body = trim_right(n.body);
            return write(count_.next(kept).append(kept.body));
        }
        block(n);
    }

    /// Behind `~`: parameters of a cycle; anything else stays.
    void further_line(std::string_view line) {
        if (!in_cycle_ || !is_cycle_line(line) || !cycle_parameters(line)) write(line);
    }

    bool cycle_parameters(std::string_view line) {
        Parts p = split_comment(trim_left(line), true);
        if (has_control_characters(p.code)) return false;
        const bool end = p.code.ends_with('*');
        if (end) p.code = trim_right(p.code.substr(0, p.code.size() - 1));
        Text code = cycle_line(p.code, options_.decimal);
        if (!code) return false;
        if (end) append_word(*code, "*");
        if (!p.comment.empty()) append_word(*code, p.comment);
        if (p.goes_on) append_word(*code, "~");
        write("  " + *code);
        return true;
    }

    void block(const Numbered& n) {
        Parts p = split_comment(n.body, true);
        in_cycle_ = is_cycle(word_number(p.code, 'G')) && word_number(p.code, 'G') >= 0;
        const bool end = p.code.ends_with('*');
        if (end) p.code = trim_right(p.code.substr(0, p.code.size() - 1));
        const bool call = p.code.starts_with('%');
        const bool on = p.goes_on || goes_on(p.comment);
        Text code = (on && !in_cycle_) || has_control_characters(p.code) ? std::nullopt
                    : call                                               ? Text(p.code)
                                                                         : iso_code(p.code, options_.decimal);
        if (!code) return leave(count_.next(n).append(n.body));
        if (end) append_word(*code, "*");
        if (!p.comment.empty()) append_word(*code, p.comment);
        if (p.goes_on) append_word(*code, "~");
        write(count_.next(n).append(*code));
    }

    std::vector<Line> lines_;
    Options options_;
    Formatted out_;
    Writer writer_;
    Counter count_{"N", 10, 10};
    std::size_t at_ = 0, heading_ = 0, blocks_ = 0;
    bool first_numbered_ = false, in_cycle_ = false;
    bool open_ = false;  ///< `~` ends the last line that is not empty
};

}  // namespace

Formatted formatted_iso(std::string_view text, const Options& options) {
    return without_new_numbers<Iso>(text, options);
}

}  // namespace obrys::format::heidenhain
