#pragma once
/// Where the files of a run come from: the disk, memory, or texts in memory that stand in front of the disk's.

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <string>
#include <vector>

#include "base/source.hpp"

namespace obrys::driver {

namespace fs = std::filesystem;

/// What stands under a name.
struct StoredEntry {
    enum class Kind : std::uint8_t {
        nothing,
        file,
        folder,
        dead_link,   ///< it leads to `leads_to`, where nothing is
        other,       ///< a device, a pipe
        unreadable,  ///< `error` says why, also where it is not known what it is
    };
    Kind kind = Kind::nothing;
    std::uintmax_t size = 0;  ///< of a file, bytes
    int error = 0;            ///< the system's number
    fs::path leads_to{};
};

/// May be read by threads at once.
class Storage {
public:
    Storage() = default;
    Storage(const Storage&) = delete;
    Storage& operator=(const Storage&) = delete;
    virtual ~Storage() = default;

    [[nodiscard]] virtual StoredEntry look(const fs::path& path) const = 0;
    /// All bytes of a file of about `size`; 0, or the system's number for what went wrong.
    [[nodiscard]] virtual int read(const fs::path& path, std::uintmax_t size, std::string& bytes) const = 0;
    /// A large text whose pieces may be laid aside; null: it is read as a whole. `shown`: as messages name it.
    [[nodiscard]] virtual std::unique_ptr<base::Store> read_large(const fs::path& path, const std::string& shown,
                                                                  std::uintmax_t size) const;
    /// What lies in a folder, by names that lead to it, in no order; nothing where it cannot be looked into.
    [[nodiscard]] virtual std::vector<fs::path> list(const fs::path& folder) const = 0;
    /// Another number whenever something was put into the folder or taken from it; nothing: not known.
    [[nodiscard]] virtual std::optional<std::int64_t> changed(const fs::path& folder) const = 0;
};

/// The disk of this machine.
[[nodiscard]] std::shared_ptr<const Storage> disk();

/// Texts by their paths, and folders that are there because something is in them. Upper and lower case differ. Over a
/// disk a path is the same from wherever it counts; links are not followed.
class Memory final : public Storage {
public:
    /// `below`: where to look for what is not here; null: nowhere.
    explicit Memory(std::shared_ptr<const Storage> below = nullptr) : below_(std::move(below)) {}

    /// Adds a file, or gives it another content.
    void put(const fs::path& path, std::string bytes);
    /// False where it holds no such file; one below it is seen again.
    bool remove(const fs::path& path);

    /// As it is now; later changes of this one do not reach it. Shares the bytes.
    [[nodiscard]] std::shared_ptr<const Memory> snapshot() const;

    [[nodiscard]] StoredEntry look(const fs::path& path) const override;
    [[nodiscard]] int read(const fs::path& path, std::uintmax_t size, std::string& bytes) const override;
    [[nodiscard]] std::unique_ptr<base::Store> read_large(const fs::path& path, const std::string& shown,
                                                          std::uintmax_t size) const override;
    [[nodiscard]] std::vector<fs::path> list(const fs::path& folder) const override;
    [[nodiscard]] std::optional<std::int64_t> changed(const fs::path& folder) const override;

private:
    [[nodiscard]] bool holds(const fs::path& path) const;

    std::shared_ptr<const Storage> below_;
    std::map<std::string, std::shared_ptr<const std::string>> files_;  ///< by normal path
    std::int64_t changes_ = 0;
    mutable std::shared_mutex use_;
};

}  // namespace obrys::driver
