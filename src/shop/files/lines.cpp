#include "shop/files/lines.hpp"

#include <algorithm>

namespace obrys::shop {

TableLine TableLines::peek() const {
    const std::size_t stop = std::min(text_.find_first_of("\r\n", at_), text_.size());
    std::size_t next = std::min(stop + 1, text_.size());
    if (next < text_.size() && text_[stop] == '\r' && text_[next] == '\n') ++next;
    return {text_.substr(at_, stop - at_), text_.substr(stop, next - stop), at()};
}

TableLine TableLines::take() {
    const TableLine line = peek();
    at_ += line.text.size() + line.end.size();
    return line;
}

}  // namespace obrys::shop
