#include "rewrite/good_name.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace obrys::rewrite {

namespace {

std::size_t longest(Named what, const Language& l) {
    const std::size_t most = what == Named::label     ? l.longest_label
                             : what == Named::program ? l.longest_program
                                                      : l.longest_variable;
    return most == 0 ? std::string::npos : most;
}

bool is_kept(std::string_view name, const Language& l) {
    if (l.is_word && l.is_word(name)) return true;
    const std::vector<std::string>& begins = l.kept_names;
    return std::any_of(begins.begin(), begins.end(), [&](const std::string& b) { return name.starts_with(b); });
}

}  // namespace

std::string with_end(std::string name, std::string_view end, Named what, const Language& l) {
    const std::size_t most = longest(what, l);
    if (most != std::string::npos && name.size() + end.size() > most)
        name.resize(most - std::min(most - std::min<std::size_t>(most, 1), end.size()));
    return name + std::string(end);
}

std::string good_name(std::string_view text, Named what, std::string_view prefix, const Language& l) {
    std::string name;
    for (const char c : text) name += base::is_letter(c) || base::is_digit(c) ? base::upper(c) : '_';
    const bool good = name.size() > 1 && !base::is_digit(name[0]) && !base::is_digit(name[1]);
    if (!good) name = std::string(prefix) + name;
    if (is_kept(name, l)) name = "U_" + name.substr(std::min(name.find_first_not_of('_'), name.size()));
    return with_end(std::move(name), "", what, l);
}

}  // namespace obrys::rewrite
