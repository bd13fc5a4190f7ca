#include "driver/files.hpp"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <vector>

#include "base/codes.hpp"
#include "base/edit_distance.hpp"
#include "base/text.hpp"
#include "driver/large_text.hpp"
#include "driver/output_file.hpp"
#include "read/fusion/listing.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

constexpr std::uintmax_t largest_file = 0xFFFFFFF0u;  // spans count bytes in 32 bits

/// Why a file cannot be read, in the words of the system.
std::string cannot(const std::string& shown, int error) {
    return shown + " cannot be read: " + std::generic_category().message(error == 0 ? EIO : error);
}

}  // namespace

void complain(base::Diagnostics& diagnostics, std::string_view code, const base::Span& where, std::string text,
              std::string remedy) {
    diagnostics.add({base::Severity::error, code, where, std::move(text), std::move(remedy), {}, {}});
}

std::string similar_names(const Storage& from, const fs::path& folder, std::string_view name) {
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const fs::path& path : from.list(folder)) {
        const std::string other = path.filename().string();
        const std::size_t distance = base::edit_distance(base::to_upper(name), base::to_upper(other));
        const std::size_t stem = fs::path(name).stem().string().size();
        if (distance > std::max<std::size_t>(stem > 3 ? 2 : 1, stem / 3)) continue;
        if (from.look(path).kind != StoredEntry::Kind::folder) near.emplace_back(distance, other);
    }
    std::sort(near.begin(), near.end());
    std::string out;
    for (std::size_t i = 0; i < near.size() && i < 3; ++i) out += (i > 0 ? ", " : "") + near[i].second;
    return out;
}

namespace {

/// Why the entry is no file to be read, and what to do about it.
std::pair<std::string, std::string> no_file(const Storage& from, const fs::path& path, const StoredEntry& entry) {
    using Kind = StoredEntry::Kind;
    const std::string shown = path.generic_string();
    switch (entry.kind) {
        case Kind::unreadable: return {cannot(shown, entry.error), {}};
        case Kind::dead_link:
            return {shown + " is a link that leads nowhere: there is no file " + entry.leads_to.generic_string(), {}};
        case Kind::nothing: {
            const std::string near = similar_names(from, path.parent_path(), path.filename().string());
            return {"there is no file " + shown, near.empty() ? std::string{} : "did you mean " + near + "?"};
        }
        case Kind::folder: return {shown + " is a folder", "name a program or a job file in it"};
        case Kind::other: return {shown + " is no regular file", "put its content into a file"};
        case Kind::file: break;
    }
    return {shown + " is larger than 4 GiB", {}};
}

/// The size of a file that can be read; nothing after a complaint.
std::optional<std::uintmax_t> size_of(const Storage& from, const fs::path& path, base::Diagnostics& diagnostics,
                                      const base::Span& where) {
    if (path.empty()) {
        complain(diagnostics, codes::file_missing, where, "the name of the file is empty");
        return std::nullopt;
    }
    const StoredEntry entry = from.look(path);
    if (entry.kind == StoredEntry::Kind::file && entry.size <= largest_file) return entry.size;
    auto [text, remedy] = no_file(from, path, entry);
    complain(diagnostics, codes::file_missing, where, std::move(text), std::move(remedy));
    return std::nullopt;
}

}  // namespace

std::optional<std::string> load_bytes(const Storage& from, const fs::path& path, base::Diagnostics& diagnostics,
                                      const base::Span& where) {
    const auto size = size_of(from, path, diagnostics, where);
    if (!size) return std::nullopt;
    std::string bytes;
    const int error = from.read(path, *size, bytes);
    if (error == 0) return bytes;
    complain(diagnostics, codes::file_missing, where, cannot(path.generic_string(), error));
    return std::nullopt;
}

void check_readable(const Storage& from, const fs::path& path, base::Diagnostics& diagnostics,
                    const base::Span& where) {
    if (size_of(from, path, diagnostics, where) == std::uintmax_t{0})
        complain(diagnostics, codes::file_empty, where, path.generic_string() + " is empty");
}

namespace {

/// Two bytes a character, as Windows calls "Unicode": with its mark, or a zero in every other byte of ordinary text.
bool is_utf16(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
    const std::size_t n = std::min<std::size_t>(text.size() / 2 * 2, 64);
    std::size_t even = 0, odd = 0;
    for (std::size_t i = 0; i < n; i += 2) even += text[i] == '\0' ? 1 : 0, odd += text[i + 1] == '\0' ? 1 : 0;
    const auto ordinary = [&](std::size_t zeros) { return 4 * zeros >= n / 2; };  // letters of other scripts have none
    const auto of_scripts = [&](std::size_t first) {                              // Latin, Greek, Cyrillic, Hebrew
        for (std::size_t i = first; i < n; i += 2)
            if (static_cast<unsigned char>(text[i]) > 0x06) return false;
        return true;
    };
    return n >= 4 && ((even == 0 && ordinary(odd) && of_scripts(1)) || (odd == 0 && ordinary(even) && of_scripts(0)));
}

/// The code of IBM mainframes: digits from F0, capital letters in three rows from C1, a blank 40, a line's end 15
/// or 25.
bool is_ebcdic(std::string_view text) {
    const std::string_view head = text.substr(0, base::telling_bytes);
    std::size_t digits = 0, signs = 0;
    constexpr std::string_view others =
        "\x40\x4B\x4D\x4E\x50\x5B\x5C\x5D\x5E\x60\x61\x6B\x6C\x6D\x7A\x7B\x7E\x15\x25\x0D";
    for (const char c : head) {
        const auto byte = static_cast<unsigned char>(c);
        const unsigned column = byte & 0x0FU, row = byte >> 4U;
        const bool digit = row == 0xF && column <= 9;
        const bool letter = (row >= 0x8 && row <= 0xE && row != 0xB && column >= 1 && column <= 9);
        digits += digit ? 1 : 0;
        signs += digit || letter || others.find(c) != std::string_view::npos ? 1 : 0;
    }
    constexpr std::size_t least = 8, part_of_digits = 5, percent = 98;
    const bool ascii = std::any_of(head.begin(), head.end(), base::is_digit);
    return head.size() >= least && !ascii && digits * part_of_digits >= head.size() &&
           signs * 100 >= percent * head.size();
}

/// What a DNC link and punched tape leave in front of a text and behind it, each a blank for the readers: NUL, the
/// marks of a transmission (SOH to EOT), device control (DC1 to DC4, XON and XOFF) and Ctrl-Z.
void blank_transfer_signs(std::string& text) {
    const auto is_sign = [](char c) {
        return (c >= '\0' && c <= '\x04') || (c >= '\x11' && c <= '\x14') || c == '\x1A';
    };
    const auto is_spare = [&](char c) { return is_sign(c) || base::is_blank(c) || c == '\r' || c == '\n'; };
    const auto first = std::find_if_not(text.begin(), text.end(), is_spare);
    if (first == text.end()) return;  // nothing but signs is no program
    const auto last = std::find_if_not(text.rbegin(), text.rend(), is_spare).base();
    std::replace_if(text.begin(), first, is_sign, ' ');
    std::replace_if(last, text.end(), is_sign, ' ');
}

bool is_text(std::string_view text, const std::string& shown, base::Diagnostics& diagnostics, const base::Span& where) {
    if (is_utf16(text)) {
        complain(diagnostics, codes::file_binary, where, shown + " is UTF-16 text, which no control reads",
                 "save it as UTF-8 or ANSI, in an editor of Windows not as \"Unicode\"");
        return false;
    }
    if (is_ebcdic(text)) {
        complain(diagnostics, codes::file_binary, where, shown + " is text in EBCDIC, the code of mainframes",
                 "convert it to ASCII: iconv -f IBM037 -t ASCII");
        return false;
    }
    if (base::looks_binary(text)) {
        complain(diagnostics, codes::file_binary, where, shown + " is not a text file",
                 "programs, job files, tool lists and machine files are text");
        return false;
    }
    if (!base::trim(text).empty()) return true;
    complain(diagnostics, codes::file_empty, where, shown + " is empty");
    return false;
}

/// An intermediate file of a CAM system is read as the listing of its records.
std::optional<std::uint32_t> add_listing(std::string_view bytes, const std::string& shown, base::Sources& sources,
                                         base::Diagnostics& diagnostics, const base::Span& where) {
    constexpr std::size_t longest_listing = std::size_t{1} << 30;
    auto listing = read::fusion::listing_of(bytes, longest_listing);
    if (listing) return sources.add(shown, std::move(*listing));
    complain(diagnostics, codes::file_binary, where,
             shown + " holds more records than are read: their listing is longer than 1 GiB",
             "let the CAM system write one file an operation");
    return std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> load(const Storage& from, const fs::path& path, base::Sources& sources,
                                  base::Diagnostics& diagnostics, const base::Span& where, Signs signs) {
    const std::string shown = path.generic_string();
    const auto known = size_of(from, path, diagnostics, where);
    if (!known) return std::nullopt;
    const std::uintmax_t size = *known;
    std::string small;
    std::unique_ptr<base::Store> large;
    if (size >= large_text) large = from.read_large(path, shown, size);
    if (const int failed = large == nullptr ? from.read(path, size, small) : 0; failed != 0) {
        complain(diagnostics, codes::file_missing, where, cannot(shown, failed));
        return std::nullopt;
    }
    if (const std::string_view bytes = large == nullptr ? std::string_view(small) : large->bytes();
        signs != Signs::refuse && read::fusion::is_intermediate(bytes))
        return add_listing(bytes, shown, sources, diagnostics, where);
    std::string blanked = small;
    if (!is_utf16(small) && signs != Signs::refuse) blank_transfer_signs(blanked);
    const std::string_view text = large == nullptr ? std::string_view(blanked) : large->bytes();
    if (!is_text(text, shown, diagnostics, where)) return std::nullopt;
    if (signs == Signs::blank) small = std::move(blanked);
    return large == nullptr ? sources.add(shown, std::move(small)) : sources.add(shown, std::move(large));
}

fs::path beside(const fs::path& job, const std::string& written) {
    const fs::path path(written);
    return path.is_absolute() ? path : (job.parent_path() / path).lexically_normal();
}

bool store(const fs::path& path, std::string_view content, base::Diagnostics& diagnostics) {
    OutputFile out(path);
    out.write(content);
    if (out.finish()) return true;
    complain(diagnostics, codes::file_missing, nowhere, path.generic_string() + " cannot be written: " + out.error());
    return false;
}

}  // namespace obrys::driver
