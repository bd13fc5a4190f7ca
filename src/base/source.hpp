#pragma once
/// Source texts and places in them. A place is a span of bytes; line and column are derived on demand.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::base {

/// Half-open range of bytes `[begin, end)` of source text number `file`.
struct Span {
    std::uint32_t file = 0, begin = 0, end = 0;
    bool operator==(const Span&) const = default;
};

/// Line and column counted from 1; the column counts characters as an editor shows them (UTF-8 or CP1252).
struct Position {
    std::uint32_t line = 1, column = 1;
};

/// How the blocks of a source text carry their number, for messages and reports.
enum class BlockNumbers : std::uint8_t {
    none,     ///< text without block numbers (TOML, tool tables)
    n_word,   ///< `N120 G1 …` (also behind a skip sign `/`)
    leading,  ///< `12 L X+0 …`
};

/// Keeps the bytes of one large text. Pieces of it may be laid aside, so that they take no memory, and are fetched
/// again when they are wanted. Address and length stay as they are; what is laid aside must not be looked at.
class Store {
public:
    static constexpr std::size_t piece = std::size_t{1} << 21;  ///< bytes that come and go together

    virtual ~Store() = default;
    /// The whole text; a NUL stands behind it.
    [[nodiscard]] virtual std::string_view bytes() const = 0;
    /// The pieces that lie in `[begin, end)` as a whole will not be looked at before they are fetched.
    virtual void lay_aside(std::size_t begin, std::size_t end) = 0;
    /// Makes `[begin, end)` readable; true where some of it was aside. Throws where it is not to be had any more.
    virtual bool fetch(std::size_t begin, std::size_t end) = 0;
};

/// One text, as read. `name` is the path as the user wrote it (messages show it).
struct Source {
    std::string name;
    /// A NUL stands behind it. Where the reader has laid it aside, `Sources` alone gives its parts.
    std::string_view text;
    BlockNumbers block_numbers = BlockNumbers::none;
    bool utf8 = true;  ///< false: bytes above 127 are CP1252
};

/// All texts of a run. References to a source stay valid while others are added. A copy shares the texts that are
/// there, and what is added to it is its own; copies may be looked at by threads at once.
class Sources {
public:
    /// Takes a text; a UTF-8 byte order mark at its start is dropped. Texts of 4 GiB and more are refused by the
    /// caller.
    std::uint32_t add(std::string name, std::string text, BlockNumbers numbers = BlockNumbers::none);
    std::uint32_t add(std::string name, std::unique_ptr<Store> text, BlockNumbers numbers = BlockNumbers::none);

    [[nodiscard]] const Source& operator[](std::uint32_t file) const { return texts_[file]->source; }
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(texts_.size()); }
    /// Of a text that was just added: no copy has it yet.
    void set_block_numbers(std::uint32_t file, BlockNumbers numbers) { texts_[file]->source.block_numbers = numbers; }

    /// For readers of large texts, now and then: what stands before `end` will not be looked at any more, except
    /// through the functions below. Has no effect on small texts.
    void lay_aside(std::uint32_t file, std::uint32_t end) const;
    /// Makes the whole text readable again. As all functions below, it throws where a text that was laid aside is not
    /// to be had any more: its file has changed.
    void fetch(std::uint32_t file) const;

    [[nodiscard]] Position position(std::uint32_t file, std::uint32_t offset) const;
    [[nodiscard]] Position position(const Span& span) const { return position(span.file, span.begin); }
    /// The text of a line (counted from 1) without its line end, raw bytes; empty past the end.
    [[nodiscard]] std::string_view line(std::uint32_t file, std::uint32_t number) const;
    /// The text of the span's first line, as UTF-8.
    [[nodiscard]] std::string line_utf8(const Span& span) const;
    [[nodiscard]] std::string_view text(const Span& span) const;
    /// Number of the block in which `offset` lies, where the text numbers its blocks and this one has a number.
    [[nodiscard]] std::optional<std::uint32_t> block_number(std::uint32_t file, std::uint32_t offset) const;

private:
    struct Text {
        Source source;
        std::string bytes;                       // of a text without a store
        std::unique_ptr<Store> store;            // null: `bytes` are all
        std::mutex use;                          // of the store, whose pieces come and go, and of what follows
        std::vector<std::uint32_t> line_starts;  // filled when first asked for
    };
    std::uint32_t add(std::unique_ptr<Text> text, std::string_view bytes);
    static void find_lines(Text& text);
    /// Where its lines begin; once found they stay.
    static const std::vector<std::uint32_t>& line_starts(Text& text);
    /// Bytes `[begin, end)` of a text, fetched where they were aside.
    static std::string_view part(Text& text, std::size_t begin, std::size_t end);

    std::vector<std::shared_ptr<Text>> texts_;
};

}  // namespace obrys::base
