#pragma once
/// Text form of the CL stream: one record a line, reads back to exactly the same records. Format: docs/cl-stream.md.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/function_ref.hpp"
#include "base/source.hpp"
#include "cl/record.hpp"

namespace obrys::cl {

/// First line of every text; the number is the format's version.
inline constexpr std::string_view text_header = "obrys-cl 2";

/// Words for FrameKind.
inline constexpr std::array<std::string_view, 7> frame_kinds{"datum",   "shift", "rotation",  "mirror",
                                                             "scaling", "plane", "programmed"};

/// Words for CompensationSide, Approach, LeadKind, PathKind, PlaceKind, OverrideKind; for Corner and Seek but none.
inline constexpr std::array<std::string_view, 2> sides{"left", "right"};
inline constexpr std::array<std::string_view, 3> approaches{"normal", "around", "smooth"};
inline constexpr std::array<std::string_view, 4> lead_kinds{"tangent-line", "normal-line", "tangent-arc",
                                                            "arc-and-line"};
inline constexpr std::array<std::string_view, 4> path_kinds{"exact", "exact-stop", "free", "within"};
inline constexpr std::array<std::string_view, 4> place_kinds{"coordinates", "home", "fixed", "frame"};
inline constexpr std::array<std::string_view, 4> override_kinds{"feed", "spindle", "adaptive-feed", "feed-hold"};
inline constexpr std::array<std::string_view, 3> corners{"chamfer", "chamfer-leg", "rounding"};
inline constexpr std::array<std::string_view, 4> sought{"contact", "contact-or-end", "release", "release-or-end"};

/// The record as one line without its line end. Numbers are the shortest that read back to the same double.
void append_text(std::string& out, const Record& record);
[[nodiscard]] std::string to_text(const Record& record);
/// `axis "C" 90 deg`, as it stands before a move.
[[nodiscard]] std::string to_text(const AxisEnd& axis);
/// Header and all records, each line ended by a newline.
[[nodiscard]] std::string to_text(const std::vector<Record>& records);

/// A sink that hands on the text line by line (each with its newline); the header goes out at construction.
class TextWriter {
public:
    explicit TextWriter(base::FunctionRef<void(std::string_view)> out);
    void operator()(const Record& record);

private:
    base::FunctionRef<void(std::string_view)> out_;
    std::string line_;
};

/// Reads a text line by line.
class TextReader {
public:
    TextReader(const base::Sources& sources, std::uint32_t file, base::Diagnostics& diagnostics)
        : sources_(sources), diagnostics_(diagnostics), file_(file) {}
    /// Hands on the record of the next line, if it has one; false behind the last line, and where it is no such text.
    bool step(Sink sink);
    /// Where the line of the last record stands in the text.
    [[nodiscard]] base::Span line() const { return line_; }

private:
    void complain(std::size_t begin, std::size_t end, std::string message);
    void hand_on(Record& record, Sink sink);

    const base::Sources& sources_;
    base::Diagnostics& diagnostics_;
    std::uint32_t file_;
    std::size_t at_ = 0;
    base::Span line_;
    bool header_ = false;
    AxisEnds ends_;                                  ///< of the next move
    std::pair<std::size_t, std::size_t> last_axis_;  ///< line of the last of them
};

/// Reads a text, record by record. A line that cannot be read is a `syntax` diagnostic at its first wrong word and is
/// left out.
void read_text(const base::Sources& sources, std::uint32_t file, Sink sink, base::Diagnostics& diagnostics);
[[nodiscard]] std::vector<Record> read_text(const base::Sources& sources, std::uint32_t file,
                                            base::Diagnostics& diagnostics);

}  // namespace obrys::cl
