/// Klartext: blocks end with their line, unless `~` stands at its end.

#include "format/heidenhain/klartext.hpp"

#include "base/text.hpp"
#include "format/heidenhain/lines.hpp"
#include "format/heidenhain/numbers.hpp"
#include "format/heidenhain/structure.hpp"

namespace obrys::format::heidenhain {

namespace {

/// A line that ends with an open word (`M ~`) would take its value from the next line: not touched.
bool ends_open(std::string_view code) {
    if (code.empty()) return true;
    const char last = base::upper(code.back());
    const bool alone = code.size() == 1 || !base::is_letter(code[code.size() - 2]);
    return alone && (last == 'F' || last == 'R' || last == 'M');
}

std::string joined(std::string code, const Parts& p) {
    if (!p.comment.empty()) append_word(code, p.comment);
    if (p.goes_on) append_word(code, "~");
    return code;
}

class Klartext {
public:
    Klartext(std::string_view text, const Options& options)
        : lines_(split_lines(text)), options_(options), writer_(out_.text, options.line_ends) {
        out_.text.reserve(text.size() + text.size() / 8);
        skip_preface(text);
    }

    /// No block gets a number that has none.
    void keep_numbers() { count_.keep(); }
    [[nodiscard]] bool numbered() const { return first_numbered_; }

    Formatted run() {
        out_.numbers_kept = refers_to_blocks();
        if (out_.numbers_kept) count_.keep();
        while (at_ < lines_.size()) {
            const std::string_view line = lines_[at_].text, blank = trim_left(line);
            if (blank.empty() || static_cast<unsigned char>(blank.front()) < ' ') {
                // Kept: dirt of old editors, and the blanks that end a block in spite of its `~`.
                const bool kept = !blank.empty() || open_;
                writer_.line(kept ? line : blank, lines_[at_].end);
                if (!line.empty()) open_ = goes_on(line);
                ++at_;
            } else {
                block();
                std::size_t last = at_ - 1;
                while (lines_[last].text.empty()) --last;
                open_ = goes_on(lines_[last].text);
            }
        }
        return std::move(out_);
    }

private:
    /// RX 13, RPR 5, PAR 17 … of free contours.
    [[nodiscard]] bool refers_to_blocks() const {
        for (const Line& line : lines_) {
            const std::string code = base::to_upper(split_number(line.text, false).body);
            if (!code.starts_with('F')) continue;
            const std::string_view words = std::string_view(code).substr(0, code.find(';'));
            for (const std::string_view word : {" RX", " RY", " RPR", " RPA", " RAN", " RCC", " PAR"})
                if (words.find(word) != std::string_view::npos) return true;
        }
        return false;
    }

    /// What stands in front of BEGIN PGM is no program.
    void skip_preface(std::string_view text) {
        const std::size_t begin = base::to_upper(text).find("BEGIN PGM");
        if (begin == std::string::npos) return;
        while (at_ < lines_.size()) {
            const std::string_view line = lines_[at_].text;
            if (static_cast<std::size_t>(line.data() - text.data()) + line.size() >= begin) return;
            copy_line();
        }
    }

    void copy_lines(std::size_t end) {
        while (at_ < end) copy_line();
    }

    void copy_line() {
        writer_.line(lines_[at_].text, lines_[at_].end);
        ++at_;
    }

    /// One past the last line of the block that begins at `at_`.
    [[nodiscard]] std::size_t block_end() const {
        std::size_t end = at_ + 1;
        if (!goes_on(lines_[at_].text)) return end;
        while (end < lines_.size()) {
            const std::string_view line = lines_[end].text;
            if (blanks_only(line)) break;
            ++end;
            if (!line.empty() && !goes_on(line)) break;
        }
        return end;
    }

    void block() {
        const std::size_t end = block_end();
        const std::string_view line = lines_[at_].text;
        Numbered n = split_number(line, false);
        if (blocks_++ == 0) first_numbered_ = n.number;
        if (n.body.starts_with(';') || n.body.starts_with('*')) return comment_block(n, end);
        if (!n.number && behind_left_ && is_cycle_line(n.body)) return copy_lines(end);
        behind_left_ = false;
        if (!n.number && first_numbered_ && in_cycle_ && is_cycle_line(n.body)) return cycle_lines(end);
        if (!n.body.empty() && !n.body.starts_with('~')) in_cycle_ = opens_cycle(n.body);
        if (base::to_upper(n.body.substr(0, 5)) == "BEGIN") count_.restart();
        // A number in front of these would change what the lines mean.
        const bool number_follows = !n.number && n.body.starts_with('~');
        if (number_follows || has_control_characters(split_comment(n.body, true).code)) n.understood = false;
        std::vector<std::string> code;
        if (!n.understood || !code_lines(n.body, end, code)) return raw_block(n, end);
        write(code, count_.next(n), end);
    }

    void comment_block(const Numbered& n, std::size_t end) {
        if (!n.understood) return raw_block(n, end);
        Numbered kept = n;
        kept.body = trim_right(n.body);
        writer_.line(count_.next(kept).append(kept.body), lines_[at_].end);
        for (++at_; at_ < end; ++at_) writer_.line(trim_right(lines_[at_].text), lines_[at_].end);
    }

    /// The code of each line; false where a line is not understood.
    bool code_lines(std::string_view body, std::size_t end, std::vector<std::string>& out) const {
        Block block;
        for (std::size_t i = at_; i < end; ++i) {
            const std::string_view line = i == at_ ? body : trim_left(lines_[i].text);
            if (i > at_ && line.empty()) {
                out.emplace_back();
                continue;
            }
            const bool free_text = opens_cycle(i == at_ ? body : std::string_view{});
            const Parts p = split_comment(line, !free_text);
            if (has_control_characters(p.code)) return false;
            if (p.code.empty() && i == at_) {
                if (p.goes_on || !p.comment.empty()) return false;
                out.emplace_back();
                continue;
            }
            const bool on = p.goes_on || goes_on(p.comment);
            std::optional<std::string> code;
            if (p.code.empty())
                code.emplace();
            else
                code = i == at_ ? opening_line(p.code, options_.decimal, block)
                                : further_line(p.code, options_.decimal, block);
            if (!code || (on && block.shape == Shape::kept)) return false;
            const bool glued =
                line.size() > p.code.size() && line[p.code.size()] == ';';  // `R;text` is no R to readers
            const bool has_words = block.shape == Shape::words || block.shape == Shape::generic;
            if ((on || glued) && has_words && ends_open(p.code)) return false;
            out.push_back(joined(std::move(*code), p));
        }
        return true;
    }

    void write(const std::vector<std::string>& code, const std::string& number, std::size_t end) {
        for (std::size_t i = 0; at_ < end; ++i, ++at_) {
            const std::string_view indent = code[i].empty() ? "" : "  ";
            writer_.line(i == 0 ? number + code[i] : std::string(indent) + code[i], lines_[at_].end);
        }
    }

    /// Lines of a cycle without number and `~`.
    void cycle_lines(std::size_t end) {
        std::vector<std::string> out;
        for (std::size_t i = at_; i < end; ++i) {
            const Parts p = split_comment(trim_left(lines_[i].text), false);
            auto code =
                p.code.empty() ? std::optional<std::string>(std::string{}) : cycle_line(p.code, options_.decimal);
            if (!code || has_control_characters(p.code)) {
                leave();
                return copy_lines(end);
            }
            out.push_back(joined(std::move(*code), p));
        }
        write(out, "  ", end);
    }

    void leave() {
        behind_left_ = true;
        out_.left.push_back({static_cast<std::uint32_t>(at_ + 1), std::string(lines_[at_].text)});
    }

    void raw_block(const Numbered& n, std::size_t end) {
        leave();
        // Where a reader ends such a block is not certain: one of its lines may define a cycle.
        for (std::size_t i = at_ + 1; i < end; ++i)
            in_cycle_ = in_cycle_ || opens_cycle(split_number(lines_[i].text, false).body);
        if (n.understood && n.number) {
            writer_.line(count_.next(n).append(n.body), lines_[at_].end);
            ++at_;
        }
        copy_lines(end);
    }

    std::vector<Line> lines_;
    Options options_;
    Formatted out_;
    Writer writer_;
    Counter count_{"", 0, 1};
    std::size_t at_ = 0, blocks_ = 0;
    bool first_numbered_ = false;
    bool open_ = false;         ///< `~` ends the last line that is not empty
    bool in_cycle_ = false;     ///< a cycle's definition came last, but for comments
    bool behind_left_ = false;  ///< a block that stays as it is came last, but for comments
};

}  // namespace

Formatted formatted_klartext(std::string_view text, const Options& options) {
    return without_new_numbers<Klartext>(text, options);
}

}  // namespace obrys::format::heidenhain
