#include "read/fusion/listing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/float_chars.hpp"
#include "base/whole.hpp"
#include "dialect/fusion/records.hpp"
#include "dialect/fusion/words.hpp"

namespace obrys::read::fusion {

using dialect::fusion::Field;
using dialect::fusion::FieldType;
using dialect::fusion::Record;
using dialect::fusion::Shape;

namespace {

constexpr std::size_t longest_name = 256;   ///< of the format, at the file's begin
constexpr std::size_t longest_text = 1000;  ///< bytes of a text that the listing shows

std::uint32_t whole_at(std::string_view bytes, std::size_t at) {
    std::uint32_t v = 0;
    for (std::size_t k = 4; k-- > 0;) v = v << 8 | static_cast<unsigned char>(bytes[at + k]);
    return v;
}
float single_at(std::string_view bytes, std::size_t at) { return base::bit_cast<float>(whole_at(bytes, at)); }
double double_at(std::string_view bytes, std::size_t at) {
    return base::bit_cast<double>(whole_at(bytes, at) | std::uint64_t{whole_at(bytes, at + 4)} << 32);
}

void append(std::string& out, std::uint64_t n) { out += std::to_string(n); }

/// Fewest digits that give the same single.
void append_single(std::string& out, float v) {
    constexpr std::int32_t most = 999999;
    if (const auto n = base::whole<std::int32_t>(v, -most, most)) {
        out += std::to_string(*n);
        return;
    }
    std::array<char, 40> buffer;
    for (int digits = 6; digits <= 9; ++digits) {
        const base::ToChars end =
            base::to_chars(buffer.data(), buffer.data() + buffer.size(), v, base::CharsFormat::general, digits);
        double again = 0;
        (void)base::from_chars(buffer.data(), end.ptr, again);
        if (static_cast<float>(again) != v && digits < 9) continue;
        out.append(buffer.data(), end.ptr);
        return;
    }
}

/// Many doubles of these files have been singles.
void append(std::string& out, double v) {
    if (!std::isfinite(v)) {
        out += std::isnan(v) ? "nan" : "inf";
        return;
    }
    constexpr double largest_single = 3.4e38;
    if (std::abs(v) < largest_single && static_cast<double>(static_cast<float>(v)) == v)
        return append_single(out, static_cast<float>(v));
    std::array<char, 40> buffer;
    const base::ToChars end = base::to_chars(buffer.data(), buffer.data() + buffer.size(), v);
    out.append(buffer.data(), end.ptr);
}

void append_quoted(std::string& out, std::string_view text) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    out += '"';
    for (const char c : text.substr(0, longest_text)) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (byte < 0x20 || byte == 0x7F) {
            out += "\\x";
            out += hex[byte >> 4];
            out += hex[byte & 0xF];
        } else {
            out += c;
        }
    }
    out += text.size() > longest_text ? "\"..." : "\"";
}

void append_utf8(std::string& out, std::uint32_t code) {
    const auto put = [&](std::uint32_t bits) { out += static_cast<char>(bits); };
    if (code < 0x80) return put(code);
    if (code < 0x800) return put(0xC0 | code >> 6), put(0x80 | (code & 0x3F));
    if (code < 0x10000) return put(0xE0 | code >> 12), put(0x80 | (code >> 6 & 0x3F)), put(0x80 | (code & 0x3F));
    put(0xF0 | code >> 18), put(0x80 | (code >> 12 & 0x3F)), put(0x80 | (code >> 6 & 0x3F)), put(0x80 | (code & 0x3F));
}

/// The begin of a text in UTF-16, half of a pair alone as '?'.
std::string utf8_of(std::string_view wide) {
    const auto unit = [&](std::size_t i) {
        return static_cast<unsigned char>(wide[i]) | static_cast<std::uint32_t>(static_cast<unsigned char>(wide[i + 1]))
                                                         << 8;
    };
    std::string out;
    for (std::size_t i = 0; i + 1 < wide.size() && out.size() <= longest_text; i += 2) {
        std::uint32_t code = unit(i);
        if (code >= 0xD800 && code < 0xE000) {
            const std::uint32_t low = i + 3 < wide.size() ? unit(i + 2) : 0;
            const bool pair = code < 0xDC00 && low >= 0xDC00 && low < 0xE000;
            code = pair ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : '?';
            if (pair) i += 2;
        }
        append_utf8(out, code);
    }
    return out;
}

class Lister {
public:
    Lister(std::string_view bytes, std::size_t most) : bytes_(bytes), most_(most) {}

    std::optional<std::string> list() {
        begin_line("compact-nci");
        if (text(false)) header_rest();
        while (!over_ && at_ < bytes_.size() && out_.size() <= most_) record();
        if (out_.size() > most_) return std::nullopt;
        return std::move(out_);
    }

private:
    void begin_line(std::string_view name) {
        begin_ = at_;
        append(out_, std::uint64_t{begin_});
        (out_ += ' ') += name;
    }
    [[nodiscard]] bool holds(std::uint64_t bytes) const { return bytes <= bytes_.size() - at_; }

    /// The record that has begun goes on behind the file's end.
    bool cut() {
        out_.resize(out_.rfind('\n') + 1);  // npos + 1 is the begin
        append(out_, std::uint64_t{begin_});
        out_ += " cut-off ";
        append(out_, std::uint64_t{bytes_.size()});
        out_ += '\n';
        over_ = true;
        return false;
    }

    void header_rest() {
        using dialect::fusion::header_bytes;
        if (!holds(header_bytes)) {
            out_ += '\n';
            return (void)cut();
        }
        out_ += " version";
        for (std::size_t i = 0; i < header_bytes; ++i)
            out_ += ' ', append(out_, std::uint64_t{static_cast<unsigned char>(bytes_[at_ + i])});
        out_ += '\n';
        at_ += header_bytes;
    }

    bool text(bool wide) {
        if (!holds(4)) return cut();
        const std::uint64_t length = whole_at(bytes_, at_) * std::uint64_t{wide ? 2U : 1U};
        at_ += 4;
        if (!holds(length)) return cut();
        const std::string_view raw = bytes_.substr(at_, static_cast<std::size_t>(length));
        out_ += ' ';
        append_quoted(out_, wide ? utf8_of(raw) : std::string(raw.substr(0, longest_text + 1)));
        at_ += static_cast<std::size_t>(length);
        return true;
    }

    void flags(std::uint32_t bits) {
        const std::uint32_t movement = bits >> 16;
        if (movement >= dialect::fusion::movements.size())
            out_ += " movement ", append(out_, std::uint64_t{movement});
        else if (movement != 0)
            (out_ += ' ') += dialect::fusion::movements[movement];
        std::uint32_t rest = bits & 0xFFFF;
        for (const dialect::fusion::Flag& f : dialect::fusion::flag_names)
            if ((rest & f.bit) != 0) (out_ += ' ') += f.name, rest &= ~f.bit;
        if (rest != 0) out_ += " flags ", append(out_, std::uint64_t{rest});
    }

    void field(const Field& f) {
        if (!f.name.empty()) (out_ += ' ') += f.name;
        for (std::size_t i = 0; i < f.count; ++i) {
            const std::size_t at = begin_ + f.offset + i * (f.type == FieldType::f64 ? 8 : 4);
            if (f.type == FieldType::flags) return flags(whole_at(bytes_, at));
            out_ += ' ';
            switch (f.type) {
                case FieldType::f32: append(out_, double{single_at(bytes_, at)}); break;
                case FieldType::f64: append(out_, double_at(bytes_, at)); break;
                default: append(out_, std::uint64_t{whole_at(bytes_, at)});
            }
        }
    }

    bool fields(const Record& r) {
        std::uint64_t size = r.size;
        if (size > bytes_.size() - begin_) return cut();
        if (r.pairs_at != 0) size += std::uint64_t{8} * whole_at(bytes_, begin_ + r.pairs_at);
        if (size > bytes_.size() - begin_) return cut();
        for (const Field& f : r.fields) field(f);
        at_ = begin_ + static_cast<std::size_t>(size);
        return true;
    }

    bool doubles(std::size_t count) {
        if (!holds(8 * count)) return cut();
        for (std::size_t i = 0; i < count; ++i) {
            out_ += ' ';
            append(out_, double_at(bytes_, at_));
            at_ += 8;
        }
        return true;
    }

    bool whole() {
        if (!holds(4)) return cut();
        out_ += ' ';
        out_ += std::to_string(base::bit_cast<std::int32_t>(whole_at(bytes_, at_)));
        at_ += 4;
        return true;
    }

    bool body(const Record& r) {
        switch (r.shape) {
            case Shape::fields: return fields(r);
            case Shape::text: return text(false) && text(false);
            case Shape::wide_text: return text(false) && text(true);
            case Shape::whole: return text(false) && whole();
            case Shape::real: return text(false) && doubles(1);
            case Shape::name: return text(false);
            case Shape::names_and_axes: return text(false) && text(false) && doubles(9);
        }
        return false;
    }

    void record() {
        begin_ = at_;
        if (!holds(4)) return (void)cut();
        const std::uint32_t number = whole_at(bytes_, at_);
        const Record* r = dialect::fusion::find_record(number);
        if (r == nullptr) {
            begin_line("unknown-record");
            out_ += ' ', append(out_, std::uint64_t{number});
            out_ += '\n';
            over_ = true;
            return;
        }
        begin_line(r->name);
        at_ += 4;
        if (body(*r)) out_ += '\n';
    }

    std::string_view bytes_;
    std::size_t most_;
    std::size_t at_ = 0, begin_ = 0;
    std::string out_;
    bool over_ = false;
};

}  // namespace

bool is_intermediate(std::string_view bytes) {
    if (bytes.size() < 4) return false;
    const std::size_t length = whole_at(bytes, 0);
    if (length > longest_name || length > bytes.size() - 4) return false;
    return bytes.substr(4, length).ends_with(dialect::fusion::format_name);
}

std::optional<std::string> listing_of(std::string_view bytes, std::size_t most) { return Lister(bytes, most).list(); }

}  // namespace obrys::read::fusion
