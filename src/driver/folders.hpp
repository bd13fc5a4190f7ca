#pragma once
/// The folders in which called programs, tables and forms are looked for: each is listed once for all inputs of a call,
/// and again only when it has changed.

#include <map>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "driver/control.hpp"
#include "driver/files.hpp"

namespace obrys::driver {

/// What a control finds in a folder.
struct ProgramIndex {
    std::unordered_map<std::string, fs::path> files;  ///< program name, and the same with its suffix -> file
    std::unordered_map<std::string, fs::path> twins;  ///< file name in capitals -> another file of that name
    std::vector<fs::path> definition_files;
};

/// Whether a file ends like one of these, in capitals.
[[nodiscard]] bool has_suffix(const fs::path& path, std::span<const std::string_view> suffixes);
/// Its name with the ending, in capitals.
[[nodiscard]] std::string full_name(const fs::path& path);

class Folders {
public:
    using Paths = std::shared_ptr<const std::vector<fs::path>>;

    explicit Folders(std::shared_ptr<const Storage> storage = disk()) : storage_(std::move(storage)) {}
    [[nodiscard]] const std::shared_ptr<const Storage>& storage() const { return storage_; }

    /// Everything in the folder, in the same order on every file system; nothing where it cannot be looked into.
    [[nodiscard]] Paths list(const fs::path& folder);
    [[nodiscard]] std::shared_ptr<const ProgramIndex> programs(const fs::path& folder, const Control& control);
    /// Tables, forms and the texts of tables.
    [[nodiscard]] Paths shop_files(const fs::path& folder);

private:
    struct Listed {
        std::optional<std::int64_t> changed;
        Paths paths, shop_files;
        std::map<const Control*, std::shared_ptr<const ProgramIndex>> programs;
    };
    Listed& listed(const fs::path& folder);

    std::shared_ptr<const Storage> storage_;
    std::map<fs::path, Listed> folders_;
};

}  // namespace obrys::driver
