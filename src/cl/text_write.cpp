#include <cmath>

#include "base/number.hpp"
#include "base/text.hpp"
#include "cl/text.hpp"
#include "cl/text_fields.hpp"
#include "cl/unknown_tool.hpp"

namespace obrys::cl {

namespace {

/// Takes the fields of a record to the end of its line.
class Line {
public:
    static constexpr bool writes = true;

    explicit Line(std::string& out) : out_(out) {}

    void word(std::string_view w) {
        out_ += ' ';
        out_ += w;
    }
    void number(double value) {
        out_ += ' ';
        out_ += std::isnan(value) ? "?" : base::shortest(value);
    }
    void vec(const geom::Vec3& v) {
        number(v.x);
        number(v.y);
        number(v.z);
    }
    template <class Integer>
    void whole(Integer n) {
        word(std::to_string(n));
    }
    template <class Integer>
    void whole(std::string_view w, Integer n) {
        if (n != 0) word(w), whole(n);
    }
    template <class Integer>
    void whole_if_any(Integer n, int none) {
        if (n != none) whole(n);
    }
    void tool_number(std::uint32_t n) { word(n == unknown_tool ? "?" : std::to_string(n)); }
    void flag(std::string_view w, bool is_there) {
        if (is_there) word(w);
    }
    template <class Enum>
    void flag_is(std::string_view w, Enum e, Enum wanted) {
        flag(w, e == wanted);
    }
    void value(std::string_view w, double v) {
        if (v != 0) word(w), number(v);
    }
    void vector(std::string_view w, const geom::Vec3& v, const geom::Vec3& none) {
        if (!(v == none)) word(w), vec(v);
    }
    void perhaps(std::string_view w, const std::optional<double>& v) {
        if (v) word(w), number(*v);
    }
    void perhaps(std::string_view w, const std::optional<geom::Vec3>& v) {
        if (v) word(w), vec(*v);
    }
    template <std::size_t N, class Enum>
    void choice(const std::array<std::string_view, N>& words, Enum e, std::size_t less = 0) {
        word(words[static_cast<std::size_t>(e) - less]);
    }
    template <std::size_t N, class Enum>
    void any_choice(const std::array<std::string_view, N>& words, Enum e) {
        if (e != Enum{}) choice(words, e, 1);
    }
    void sense(const std::array<std::string_view, 3>& words, std::int8_t n) { word(words[n < 0 ? 0 : n == 0 ? 1 : 2]); }
    void perhaps(const std::array<std::string_view, 3>& words, const std::optional<std::int8_t>& n) {
        if (n) sense(words, *n);
    }
    template <class Enum>
    void spelt(Enum e) {
        word(spelling(e));
    }
    template <class List, class F>
    void each_text(const List& list, F f) {
        for (const auto& item : list) f(item);
    }
    template <class List, class F>
    void each_word(const List& list, std::string_view, F f) {
        each_text(list, f);
    }
    void letter(char c) { quoted({&c, 1}); }
    void axis_name(const std::array<char, 8>& name) { quoted(name_of(name)); }
    void number_or_text(double v, const std::optional<std::string>& text) {
        if (text)
            quoted(*text);
        else
            number(v);
    }
    void cycle(const CycleBegin& s) { fields(*this, *s.cycle, s); }
    void fail(const char*) {}

    /// A blank and the text in quotes; control characters, quotes and backslashes escaped, all other bytes as they are.
    void quoted(std::string_view text) {
        constexpr std::string_view hex = "0123456789abcdef";
        out_ += " \"";
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            if (c == '"' || c == '\\') {
                out_ += '\\';
                out_ += c;
            } else if (c == '\n') {
                out_ += "\\n";
            } else if (byte < 0x20 || byte == 0x7F) {
                out_ += "\\x";
                out_ += hex[byte >> 4];
                out_ += hex[byte & 15];
            } else {
                out_ += c;
            }
        }
        out_ += '"';
    }

private:
    std::string& out_;
};

template <class T>
std::string_view head_of(const T&) {
    static_assert(!head<T>.empty(), "a record without a word");
    return head<T>;
}
std::string_view head_of(const Linear& s) { return s.rapid ? "rapid" : head<Linear>; }
std::string_view head_of(const Comment& s) { return s.terminal ? "print" : s.message ? "message" : head<Comment>; }
std::string_view head_of(const PartBegin& s) {
    return s.kind == PartKind::label ? "label" : s.kind == PartKind::repetition ? "repeat" : head<PartBegin>;
}

void append_origin(std::string& out, const Record& record) {
    out += " @" + std::to_string(record.from.file) + ':' + std::to_string(record.from.begin) + '-' +
           std::to_string(record.from.end);
    if (record.stack != 0) out += " ^" + std::to_string(record.stack);
}

template <class T>
void append_fields(std::string& out, const T& of) {
    out += head_of(of);
    Line line(out);
    fields(line, of);
}

}  // namespace

/// The axes that a move takes along stand in lines before its own.
void append_text(std::string& out, const Record& record) {
    const AxisEnds* ends = ends_before(record.step);
    for (std::size_t i = 0; ends != nullptr && i < ends->size(); ++i) {
        append_fields(out, (*ends)[i]);
        append_origin(out, record);
        out += '\n';
    }
    std::visit([&](const auto& step) { append_fields(out, step); }, record.step);
    append_origin(out, record);
}

std::string to_text(const AxisEnd& axis) {
    std::string out;
    append_fields(out, axis);
    return out;
}

std::string to_text(const Record& record) {
    std::string out;
    append_text(out, record);
    return out;
}

std::string to_text(const std::vector<Record>& records) {
    std::string out(text_header);
    out += '\n';
    for (const Record& record : records) {
        append_text(out, record);
        out += '\n';
    }
    return out;
}

TextWriter::TextWriter(base::FunctionRef<void(std::string_view)> out) : out_(out) {
    line_ = text_header;
    line_ += '\n';
    out_(line_);
}

void TextWriter::operator()(const Record& record) {
    line_.clear();
    append_text(line_, record);
    line_ += '\n';
    out_(line_);
}

}  // namespace obrys::cl
