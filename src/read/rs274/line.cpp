#include "read/rs274/line.hpp"

namespace obrys::read::rs274 {

void Line::load(std::string_view source, std::uint32_t begin, std::uint32_t end, bool nested, bool semicolon) {
    at_ = 0;
    fault_ = CommentFault::none;
    while (begin < end && base::is_blank(source[begin])) ++begin;
    while (end > begin && (base::is_blank(source[end - 1]) || source[end - 1] == '\r')) --end;
    begin_ = begin;
    end_ = end;
    text_.resize(end - begin);
    from_.resize(end - begin);
    std::size_t count = 0;
    int depth = 0;
    bool to_end = false;  // behind `;`
    for (std::uint32_t i = begin; i < end; ++i) {
        const char c = source[i];
        if (!to_end && depth == 0 && (base::is_blank(c) || c == '\r')) continue;
        to_end = to_end || (semicolon && c == ';' && depth == 0);
        if (!to_end && c == '(') {
            if (depth == 0) fault_begin_ = i;
            if (depth > 0 && !nested && fault_ == CommentFault::none) {
                fault_ = CommentFault::nested;
                fault_begin_ = i;
            }
            if (depth == 0 || nested) ++depth;
        }
        text_[count] = to_end || depth > 0 ? c : base::upper(c);
        from_[count++] = i;
        if (!to_end && c == ')' && depth > 0) --depth;
    }
    text_.resize(count);
    from_.resize(count);
    if (depth > 0 && fault_ == CommentFault::none) fault_ = CommentFault::unclosed;
}

}  // namespace obrys::read::rs274
