#include "program/remarks.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace obrys::program {

namespace {

struct Found {
    std::uint32_t begin = 0, end = 0;  ///< of its text, without signs
};

/// Goes through one line; a sign between quotes is none.
class LineRemarks {
public:
    LineRemarks(std::string_view text, std::uint32_t begin, std::uint32_t end, const RemarkSigns& signs)
        : text_(text), at_(begin), end_(end), signs_(signs) {}

    std::vector<Found> all() {
        if (signs_.star_blocks && takes_star()) return found_;
        for (bool quoted = false; at_ < end_; ++at_) {
            const char c = text_[at_];
            if (c == '"') quoted = !quoted && closes(at_);
            if (quoted) continue;
            if (c == signs_.to_line_end && c != '\0') {
                add(at_ + 1, end_);
                break;
            }
            if (c == '(' && signs_.brackets) take_bracket();
        }
        return found_;
    }

private:
    /// Block number and skip sign may stand in front.
    bool takes_star() {
        std::uint32_t i = at_;
        while (i < end_ && (base::is_digit(text_[i]) || base::is_blank(text_[i]) || text_[i] == '/')) ++i;
        if (i == end_ || text_[i] != '*') return false;
        while (i < end_ && (text_[i] == '*' || text_[i] == '-' || base::is_blank(text_[i]))) ++i;
        add(i, end_);
        return true;
    }

    [[nodiscard]] bool closes(std::uint32_t quote) const {
        const std::size_t next = text_.find('"', quote + 1);
        return next != std::string_view::npos && next < end_;
    }

    /// To the bracket that belongs to it; where there is none, to the first one.
    void take_bracket() {
        const std::uint32_t from = at_ + 1;
        std::uint32_t first = end_, i = from;
        for (int depth = 1; i < end_; ++i) {
            if (text_[i] == '(') ++depth;
            if (text_[i] != ')') continue;
            first = std::min(first, i);
            if (--depth == 0) break;
        }
        at_ = i < end_ ? i : first;
        add(from, at_);
    }

    void add(std::uint32_t begin, std::uint32_t end) {
        while (begin < end && is_edge(text_[begin])) ++begin;
        while (end > begin && is_edge(text_[end - 1])) --end;
        if (begin < end) found_.push_back({begin, end});
    }
    [[nodiscard]] bool is_edge(char c) const {
        return base::is_blank(c) || c == '\r' || (c == signs_.to_line_end && c != '\0');
    }

    std::string_view text_;
    std::uint32_t at_ = 0, end_ = 0;
    const RemarkSigns& signs_;
    std::vector<Found> found_;
};

/// `;$PATH=/_N_WKS_DIR` says where the control keeps the program.
bool is_for_control(std::string_view remark) { return remark.starts_with("$PATH"); }

/// A procedure of the line that ends at `line_end`, whose first statement is `first`, shows what stands at `at`.
bool is_shown(const Unit& unit, std::uint32_t first, std::uint32_t line_end, std::uint32_t at) {
    for (std::uint32_t i = first; i < unit.statements.size() && unit.statements[i].begin < line_end; ++i) {
        if (unit.statements[i].kind != StatementKind::procedure) continue;
        const Word& entry = unit.words[unit.statements[i].first];
        const base::Span& where = unit.procedures[static_cast<std::size_t>(entry.payload)].where;
        if (where.begin <= at && at <= where.end) return true;
    }
    return false;
}

/// Where the line goes on in the next one.
bool goes_on(std::string_view text, std::uint32_t begin, std::uint32_t end, char sign) {
    while (end > begin && (base::is_blank(text[end - 1]) || text[end - 1] == '\r')) --end;
    return sign != '\0' && end > begin && text[end - 1] == sign;
}

}  // namespace

void add_remarks(Unit& unit, std::string_view text, const RemarkSigns& signs) {
    const std::uint32_t last = std::min(unit.end, static_cast<std::uint32_t>(text.size()));
    std::uint32_t statement = 0;
    const auto count = static_cast<std::uint32_t>(unit.statements.size());
    bool inside = false;
    for (std::uint32_t line = unit.begin; line < last;) {
        const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(text.find('\n', line), last));
        while (statement < count && unit.statements[statement].begin < line) ++statement;
        const Statement* before = statement > 0 ? &unit.statements[statement - 1] : nullptr;
        const bool within = before != nullptr && before->begin + before->length > line;
        const bool wanted = !inside && !within && statement < count;
        inside = goes_on(text, line, end, signs.goes_on);
        if (wanted && !inside)
            for (const Found& f : LineRemarks(text, line, end, signs).all()) {
                const std::string_view said = text.substr(f.begin, f.end - f.begin);
                if (!is_for_control(said) && !is_shown(unit, statement, end, f.begin))
                    unit.remarks.push_back({statement, base::as_utf8(said)});
            }
        line = end + 1;
    }
}

}  // namespace obrys::program
