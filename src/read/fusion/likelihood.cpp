#include "read/fusion/listing.hpp"
#include "read/fusion/read.hpp"

namespace obrys::read::fusion {

int likelihood(std::string_view text, std::string_view, std::vector<std::string>* signs) {
    if (!text.starts_with(first_words)) return 0;
    if (signs != nullptr) signs->emplace_back("compact-nci");
    return 100;
}

}  // namespace obrys::read::fusion
