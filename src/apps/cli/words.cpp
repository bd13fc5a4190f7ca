#include "words.hpp"

#include <algorithm>
#include <filesystem>

#include "base/codes.hpp"
#include "shop/nearest.hpp"

namespace obrys::cli {

namespace {

const std::vector<std::string>& commands() {
    static const std::vector<std::string> words{"check", "run",  "plot",      "fmt",  "translate", "compare",
                                                "sheet", "time", "calibrate", "post", "version",   "help"};
    return words;
}

bool is_one_of(const std::string& word, const std::vector<std::string>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

WordCheck only(std::vector<std::string> words) {
    return [words = std::move(words)](const std::string& word) {
        return is_one_of(word, words) ? std::string{} : "\"" + word + "\" is none; " + shop::words_remedy(word, words);
    };
}

std::string is_code_or_severity(const std::string& word) {
    std::vector<std::string> words{"error", "warning", "note"};
    for (const base::Code& c : base::all_codes)
        if (c.kind == base::CodeKind::finding) words.emplace_back(c.name);
    if (is_one_of(word, words)) return "";
    const std::string near = shop::nearest(word, words);
    return "\"" + word + "\" is neither error, warning, note nor the code of a finding (docs/diagnostics.md)" +
           (near.empty() ? "" : "; did you mean \"" + near + "\"?");
}

bool is_command(const std::string& word) { return is_one_of(word, commands()); }

std::string no_command(const std::string& word) {
    std::error_code error;
    const bool file = std::filesystem::exists(word, error) || word.find('.') != std::string::npos;
    const std::string near = file ? "" : shop::nearest(word, commands());
    return "there is no command '" + word + "'; the commands are " + shop::joined(commands()) + "\n" +
           (near.empty() ? "  to check a program: obrys check " + word : "  did you mean " + near + "?") + "\n";
}

}  // namespace obrys::cli
