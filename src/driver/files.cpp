#include "driver/files.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <vector>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "driver/large_text.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

constexpr std::uintmax_t largest_file = 0xFFFFFFF0u;  // spans count bytes in 32 bits

void complain(base::Diagnostics& d, std::string_view code, const base::Span& where, std::string text,
              std::string remedy = {}) {
    d.add({base::Severity::error, code, where, std::move(text), std::move(remedy), {}, {}});
}

/// Edits that turn a into b, letter case ignored.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = diagonal + (base::upper(a[i - 1]) == base::upper(b[j - 1]) ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

bool read_text(const fs::path& path, std::uintmax_t size, std::string& text) {
    std::ifstream in(path, std::ios::binary);
    text.resize(static_cast<std::size_t>(size));
    in.read(text.data(), static_cast<std::streamsize>(size));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return static_cast<bool>(in) || in.eof();
}

}  // namespace

std::string similar_names(const fs::path& folder, std::string_view name) {
    std::error_code error;
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, error)) {
        const std::string other = entry.path().filename().string();
        const std::size_t distance = edit_distance(name, other);
        if (distance <= std::max<std::size_t>(2, name.size() / 3)) near.emplace_back(distance, other);
    }
    std::sort(near.begin(), near.end());
    std::string out;
    for (std::size_t i = 0; i < near.size() && i < 3; ++i) out += (i > 0 ? ", " : "") + near[i].second;
    return out;
}

namespace {

/// The size of a file that can be read; nothing after a complaint.
std::optional<std::uintmax_t> size_of(const fs::path& path, base::Diagnostics& diagnostics, const base::Span& where) {
    const std::string shown = path.generic_string();
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        const std::string near = similar_names(path.parent_path(), path.filename().string());
        complain(diagnostics, codes::file_missing, where, "there is no file " + shown,
                 near.empty() ? std::string{} : "did you mean " + near + "?");
        return std::nullopt;
    }
    if (fs::is_directory(status)) {
        complain(diagnostics, codes::file_missing, where, shown + " is a folder", "name a program or a job file in it");
        return std::nullopt;
    }
    const std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(path, error) : 0;
    if (size > largest_file) {
        complain(diagnostics, codes::file_missing, where, shown + " is larger than 4 GiB");
        return std::nullopt;
    }
    if (!error && fs::is_regular_file(status)) return size;
    complain(diagnostics, codes::file_missing, where,
             shown + " cannot be read" + (error ? ": " + error.message() : std::string{}));
    return std::nullopt;
}

}  // namespace

std::optional<std::string> load_bytes(const fs::path& path, base::Diagnostics& diagnostics, const base::Span& where) {
    const auto size = size_of(path, diagnostics, where);
    std::string bytes;
    if (size && read_text(path, *size, bytes)) return bytes;
    if (size) complain(diagnostics, codes::file_missing, where, path.generic_string() + " cannot be read");
    return std::nullopt;
}

std::optional<std::uint32_t> load(const fs::path& path, base::Sources& sources, base::Diagnostics& diagnostics,
                                  const base::Span& where) {
    const std::string shown = path.generic_string();
    const auto known = size_of(path, diagnostics, where);
    if (!known) return std::nullopt;
    const std::uintmax_t size = *known;
    std::string small;
    std::unique_ptr<base::Store> large;
    if (size >= large_text) large = read_large_text(path.string(), shown, size);
    if (large == nullptr && !read_text(path, size, small)) {
        complain(diagnostics, codes::file_missing, where, shown + " cannot be read");
        return std::nullopt;
    }
    const std::string_view text = large == nullptr ? std::string_view(small) : large->bytes();
    if (base::looks_binary(text)) {
        complain(diagnostics, codes::file_binary, where, shown + " is not a text file",
                 "name an NC program or a job file");
        return std::nullopt;
    }
    if (base::trim(text).empty()) {
        complain(diagnostics, codes::file_empty, where, shown + " is empty");
        return std::nullopt;
    }
    return large == nullptr ? sources.add(shown, std::move(small)) : sources.add(shown, std::move(large));
}

fs::path beside(const fs::path& job, const std::string& written) {
    const fs::path path(written);
    return path.is_absolute() ? path : (job.parent_path() / path).lexically_normal();
}

bool store(const fs::path& path, std::string_view content, base::Diagnostics& diagnostics) {
    const fs::path part = fs::path(path).concat(".part");
    std::error_code error;
    {
        std::ofstream out(part, std::ios::binary);
        out.write(content.data(), static_cast<std::streamsize>(content.size()));
        out.flush();
        if (!out) error = std::make_error_code(std::errc::io_error);
    }
    if (!error) fs::rename(part, path, error);
    if (!error) return true;
    std::error_code ignored;
    fs::remove(part, ignored);
    complain(diagnostics, codes::file_missing, nowhere,
             path.generic_string() + " cannot be written: " + error.message());
    return false;
}

}  // namespace obrys::driver
