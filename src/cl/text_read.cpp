#include <cmath>
#include <optional>
#include <utility>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "cl/text.hpp"
#include "cl/text_fields.hpp"
#include "cl/text_words.hpp"
#include "cl/unknown_tool.hpp"

namespace obrys::cl {

namespace {

std::optional<CycleKind> named(std::string_view w, CycleKind) { return cycle_kind_spelt(w); }
std::optional<CycleRole> named(std::string_view w, CycleRole) { return cycle_role_spelt(w); }
constexpr const char* no_such(CycleKind) { return "there is no such cycle"; }
constexpr const char* no_such(CycleRole) { return "there is no such value of a cycle"; }

/// Fills the fields of a record from the words of its line.
class Reading {
public:
    static constexpr bool writes = false;

    explicit Reading(Words& words) : words_(words) {}

    void word(std::string_view w) { words_.expect(w); }
    void number(double& v) { v = words_.number(); }
    void vec(geom::Vec3& v) { v = words_.vec(); }
    template <class Integer>
    void whole(Integer& n) {
        n = words_.integer<Integer>();
    }
    template <class Integer>
    void whole(std::string_view w, Integer& n) {
        if (words_.accept(w)) whole(n);
    }
    template <class Integer>
    void whole_if_any(Integer& n, int) {
        if (words_.ok() && !words_.peek().empty() && base::is_digit(words_.peek().front())) whole(n);
    }
    void tool_number(std::uint32_t& n) {
        if (words_.accept("?"))
            n = unknown_tool;
        else
            whole(n);
    }
    void flag(std::string_view w, bool& is_there) { is_there = words_.accept(w); }
    template <class Enum>
    void flag_is(std::string_view w, Enum& e, Enum wanted) {
        if (words_.accept(w)) e = wanted;
    }
    void value(std::string_view w, double& v) {
        if (words_.accept(w)) number(v);
    }
    void vector(std::string_view w, geom::Vec3& v, const geom::Vec3&) {
        if (words_.accept(w)) vec(v);
    }
    void perhaps(std::string_view w, std::optional<double>& v) {
        if (words_.accept(w)) v = words_.number();
    }
    void perhaps(std::string_view w, std::optional<geom::Vec3>& v) {
        if (words_.accept(w)) v = words_.vec();
    }
    template <std::size_t N, class Enum>
    void choice(const std::array<std::string_view, N>& words, Enum& e, std::size_t less = 0) {
        e = static_cast<Enum>(words_.choice(words) + less);
    }
    template <std::size_t N, class Enum>
    void any_choice(const std::array<std::string_view, N>& words, Enum& e) {
        for (std::size_t i = 0; i < N && e == Enum{}; ++i)
            if (words_.accept(words[i])) e = static_cast<Enum>(i + 1);
    }
    void sense(const std::array<std::string_view, 3>& words, std::int8_t& n) {
        n = static_cast<std::int8_t>(static_cast<int>(words_.choice(words)) - 1);
    }
    void perhaps(const std::array<std::string_view, 3>& words, std::optional<std::int8_t>& n) {
        for (std::size_t i = 0; i < words.size() && !n; ++i)
            if (words_.accept(words[i])) n = static_cast<std::int8_t>(static_cast<int>(i) - 1);
    }
    template <class Enum>
    void spelt(Enum& e) {
        const auto found = words_.ok() ? named(words_.word(), e) : std::nullopt;
        if (!found) words_.fail(no_such(e));
        e = found.value_or(Enum{});
    }
    template <class Item, class F>
    void each_text(std::vector<Item>& list, F f) {
        while (words_.ok() && words_.peek().starts_with('"')) f(list.emplace_back());
    }
    template <class Item, class F>
    void each_word(std::vector<Item>& list, std::string_view end, F f) {
        while (words_.ok() && !words_.peek().empty() && words_.peek().front() >= 'a' && words_.peek() != end)
            f(list.emplace_back());
    }
    void letter(char& c) {
        const std::string text = words_.quoted();
        if (text.size() != 1) words_.fail("expected one letter");
        if (!text.empty()) c = text[0];
    }
    void axis_name(std::array<char, 8>& out) {
        const std::string name = words_.quoted();
        if (name.size() > out.size()) words_.fail("an axis name has at most 8 characters");
        for (std::size_t i = 0; i < name.size() && i < out.size(); ++i) out[i] = name[i];
    }
    void quoted(std::string& text) { text = words_.quoted(); }
    void number_or_text(double& v, std::optional<std::string>& text) {
        if (words_.ok() && words_.peek().starts_with('"'))
            text = words_.quoted(), v = std::nan("");
        else
            number(v);
    }
    void cycle(CycleBegin& s) {
        Cycle cycle;
        fields(*this, cycle, s);
        s.cycle = std::move(cycle);
    }
    void fail(const char* message) {
        words_.word();
        words_.fail(message);
    }

private:
    Words& words_;
};

/// The record that begins with this word, as far as the word says it.
template <class... Records>
std::optional<Step> begun(std::string_view word, const std::variant<Records...>*) {
    if (word == "rapid") return Linear{.to = {}, .rapid = true};
    if (word == "message" || word == "print") return Comment{"", true, word == "print"};
    if (word == "label") return PartBegin{.kind = PartKind::label, .name = {}};
    if (word == "repeat") return PartBegin{.kind = PartKind::repetition, .name = {}};
    static_assert((!head<Records>.empty() && ...), "a record without a word");
    std::optional<Step> found;
    ((word == head<Records> ? void(found = Records{}) : void()), ...);
    return found;
}

/// The line before a move that says where an axis stands at its end.
AxisEnd axis_end(Words& w) {
    w.word();
    AxisEnd axis;
    Reading reading(w);
    fields(reading, axis);
    return axis;
}

std::optional<Step> step(Words& w) {
    const std::string_view word = w.word();
    std::optional<Step> s = begun(word, static_cast<const Step*>(nullptr));
    if (!s) w.fail("unknown record kind \"" + std::string(word) + "\"");
    Reading reading(w);
    if (s) std::visit([&](auto& record) { fields(reading, record); }, *s);
    return s;
}

/// `@file:begin-end` and, where it is not the main program, `^stack`.
void origin(Words& w, Record& record) {
    if (!w.ok()) return;
    const std::string_view at = w.word();
    const std::size_t colon = at.find(':'), dash = at.find('-');
    if (!at.starts_with('@') || colon == std::string_view::npos || dash == std::string_view::npos || dash < colon)
        return w.fail("expected the source as @file:begin-end");
    record.from.file = w.integer_of<std::uint32_t>(at.substr(1, colon - 1));
    record.from.begin = w.integer_of<std::uint32_t>(at.substr(colon + 1, dash - colon - 1));
    record.from.end = w.integer_of<std::uint32_t>(at.substr(dash + 1));
    if (!w.ok() || w.at_end()) return;
    const std::string_view stack = w.word();
    if (!stack.starts_with('^')) return w.fail("expected the call stack as ^number, or the end of the line");
    record.stack = w.integer_of<StackId>(stack.substr(1));
    if (w.ok() && !w.at_end()) {
        w.word();
        w.fail("nothing may follow the call stack");
    }
}

}  // namespace

void TextReader::complain(std::size_t begin, std::size_t end, std::string message) {
    const base::Span where{file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    diagnostics_.add({base::Severity::error, base::codes::syntax, where, std::move(message), "", {}, {}});
}

bool TextReader::step(Sink sink) {
    const std::string_view text = sources_[file_].text;
    if (at_ >= text.size()) {
        if (!std::exchange(ends_, {}).empty())
            complain(last_axis_.first, last_axis_.second, "no move follows that takes this axis along");
        return false;
    }
    const std::size_t begin = at_, newline = std::min(text.find('\n', begin), text.size());
    at_ = newline + 1;
    std::string_view line = text.substr(begin, newline - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (base::trim(line).empty() || line.starts_with(';')) return true;
    if (!header_) {
        header_ = line == text_header;
        if (header_) return true;
        complain(begin, begin + line.size(), "expected the first line \"obrys-cl 2\"");
        at_ = text.size();
        return false;
    }
    line_ = {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + line.size())};
    Words words(line);
    Record record;
    const bool is_axis = words.peek() == head<AxisEnd>;
    AxisEnd end;
    if (is_axis)
        end = axis_end(words);
    else if (std::optional<Step> s = cl::step(words))
        record.step = std::move(*s);
    origin(words, record);
    if (!words.ok())
        complain(begin + words.wrong_begin(), begin + words.wrong_end(), words.message());
    else if (is_axis)
        ends_.push_back(end), last_axis_ = {begin, begin + line.size()};
    else
        hand_on(record, sink);
    return true;
}

/// A move takes along the axes of the lines before it.
void TextReader::hand_on(Record& record, Sink sink) {
    if (AxisEnds* ends = ends_before(record.step)) *ends = std::exchange(ends_, {});
    sink(record);
}

void read_text(const base::Sources& sources, std::uint32_t file, Sink sink, base::Diagnostics& diagnostics) {
    TextReader reader(sources, file, diagnostics);
    while (reader.step(sink)) {
    }
}

std::vector<Record> read_text(const base::Sources& sources, std::uint32_t file, base::Diagnostics& diagnostics) {
    std::vector<Record> records;
    const auto keep = [&records](const Record& record) { records.push_back(record); };
    read_text(sources, file, Sink(keep), diagnostics);
    return records;
}

}  // namespace obrys::cl
