#pragma once
/// Words of the command line of which there are only so many, and what to say about others.

#include <functional>
#include <string>
#include <vector>

namespace obrys::cli {

/// Says what is wrong with a word; "" where nothing is.
using WordCheck = std::function<std::string(const std::string&)>;

/// Takes these words only; one that is misspelt gets its nearest.
[[nodiscard]] WordCheck only(std::vector<std::string> words);

/// "" where findings can be told apart by it.
[[nodiscard]] std::string is_code_or_severity(const std::string& word);

[[nodiscard]] bool is_command(const std::string& word);
/// That there is no such command, which there are, and what was meant. Ends its line.
[[nodiscard]] std::string no_command(const std::string& word);

}  // namespace obrys::cli
