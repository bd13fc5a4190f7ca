#include "interp/calls/print_form.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number.hpp"
#include "base/text.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace {

constexpr int widest_field = 200;
constexpr double largest_shown = 1e15;
constexpr std::size_t longest_form = 1'000'000;  ///< bytes that one form may become

struct PrintFormat {
    bool left = false, plus = false, zeros = false;
    int width = 0, decimals = -1;
    char kind = 0;  ///< F, D, S; 0: none that is known
};

int digits(std::string_view s, std::size_t& at) {
    int n = 0;
    for (; at < s.size() && base::is_digit(s[at]); ++at) n = std::min(n * 10 + (s[at] - '0'), widest_field);
    return n;
}

/// Behind the `%`; moves `at` behind the format.
PrintFormat read_print_format(std::string_view s, std::size_t& at) {
    PrintFormat f;
    for (; at < s.size() && std::string_view("-+0 ").find(s[at]) != std::string_view::npos; ++at) {
        f.left = f.left || s[at] == '-';
        f.plus = f.plus || s[at] == '+';
        f.zeros = f.zeros || s[at] == '0';
    }
    f.width = digits(s, at);
    if (at < s.size() && s[at] == '.') f.decimals = std::min(digits(s, ++at), 9);
    if (at < s.size() && std::string_view("LlRr").find(s[at]) != std::string_view::npos) ++at;
    const char c = at < s.size() ? base::upper(s[at]) : '\0';
    if (c != 'F' && c != 'D' && c != 'I' && c != 'S') return f;
    f.kind = c == 'I' ? 'D' : c;
    ++at;
    return f;
}

std::string printed_as(const PrintFormat& f, const Value& v) {
    std::string text;
    if (f.kind == 'S' || !v.is_number())
        text = printed(v);
    else if (!(std::abs(v.number) < largest_shown))
        text = "?";
    else
        text = base::fixed(v.number, f.kind == 'D' ? 0 : f.decimals < 0 ? 6 : f.decimals);
    const bool number = f.kind != 'S' && text != "?";
    if (number && f.plus && text.front() != '-') text.insert(text.begin(), '+');
    const auto width = static_cast<std::size_t>(f.width);
    if (text.size() >= width) return text;
    if (f.left) return text + std::string(width - text.size(), ' ');
    if (!f.zeros || !number) return std::string(width - text.size(), ' ') + text;
    const std::size_t sign = text.front() == '-' || text.front() == '+' ? 1 : 0;
    return text.insert(sign, width - text.size(), '0');
}

constexpr std::array clock_words{"HOUR",          "MIN", "SEC", "DAY", "MONTH", "YEAR2", "YEAR4", "STR_MONTH_SHORT",
                                 "STR_MONTH_LONG"};

class Filler {
public:
    Filler(base::FunctionRef<Value(std::string_view)> value, std::string_view path) : value_(value), path_(path) {}

    void line(std::string_view text) {
        ++number_;
        text = base::trim(text);
        if (text.empty() || text.front() == ';') return;
        if (text.front() == '"') return formatted(text);
        keyword(base::to_upper(base::trim(text.substr(0, text.find(';')))));
    }
    FilledForm result;

private:
    void problem(std::string text) {
        if (result.problems.size() < 10)
            result.problems.push_back("line " + std::to_string(number_) + ": " + std::move(text));
    }

    void keyword(const std::string& word) {
        if (word.starts_with("L_")) {
            language_ = word == "L_ENGLISH" || word == "L_ALL";
        } else if (word == "M_CLOSE") {
            result.close = true;
        } else if (word == "M_APPEND") {
            result.append = true;
        } else if (word == "CALL_PATH") {
            if (language_) result.text += std::string(path_) + "\n";
        } else {
            problem("\"" + word + "\" is no keyword of a form");
        }
    }

    Value argument(const std::string& name) {
        if (name == "CALL_PATH") return Value::string(std::string(path_));
        if (std::find(clock_words.begin(), clock_words.end(), name) == clock_words.end()) return value_(name);
        result.clock = true;
        return Value::unknown();
    }

    /// "text %9.3LF", Q31;
    void formatted(std::string_view text) {
        if (!language_) return;
        const std::size_t end = text.find('"', 1);
        if (end == std::string_view::npos) return problem("the text has no closing quote");
        std::string_view rest = text.substr(end + 1, text.substr(end + 1).find(';'));
        std::vector<std::string> names;
        while (!rest.empty()) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            if (const auto name = base::trim(rest.substr(0, comma)); !name.empty())
                names.push_back(base::to_upper(name));
            rest.remove_prefix(std::min(comma + 1, rest.size()));
        }
        put(text.substr(1, end - 1), names);
    }

    void put(std::string_view text, const std::vector<std::string>& names) {
        std::size_t used = 0;
        for (std::size_t i = 0; i < text.size();) {
            if (text[i] != '%') {
                result.text += text[i++];
                continue;
            }
            if (++i < text.size() && text[i] == '%') {
                result.text += text[i++];
                continue;
            }
            const PrintFormat f = read_print_format(text, i);
            if (f.kind == 0) {
                problem("a format of this kind is not known");
                result.text += '?';
                if (i < text.size() && base::is_letter(text[i])) ++i;
                used = std::min(used + 1, names.size());
            } else if (used == names.size()) {
                problem("there are more formats than values");
                result.text += '?';
            } else {
                result.text += printed_as(f, argument(names[used++]));
            }
        }
        if (used < names.size()) problem("there are more values than formats");
        result.text += '\n';
    }

    base::FunctionRef<Value(std::string_view)> value_;
    std::string_view path_;
    bool language_ = true;
    int number_ = 0;
};

}  // namespace

FilledForm fill_form(std::string_view form, base::FunctionRef<Value(std::string_view)> value, std::string_view path) {
    Filler filler(value, path);
    while (!form.empty() && filler.result.text.size() < longest_form) {
        const std::size_t end = std::min(form.find('\n'), form.size());
        filler.line(form.substr(0, end));
        form.remove_prefix(std::min(end + 1, form.size()));
    }
    return std::move(filler.result);
}

}  // namespace obrys::interp
