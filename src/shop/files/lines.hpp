#pragma once
/// The lines of a table as they stand in its file.

#include <cstdint>
#include <string_view>

namespace obrys::shop {

struct TableLine {
    std::string_view text;  ///< without its end
    std::string_view end;
    std::uint32_t at = 0;
};

/// The lines of a text, one after the other. A line ends with CR LF, LF or CR.
class TableLines {
public:
    explicit TableLines(std::string_view text) : text_(text) {}

    [[nodiscard]] bool done() const { return at_ >= text_.size(); }
    [[nodiscard]] std::uint32_t at() const { return static_cast<std::uint32_t>(at_); }
    [[nodiscard]] TableLine peek() const;
    TableLine take();

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace obrys::shop
