#include "driver/storage.hpp"

#include <cerrno>
#include <cstdio>
#include <mutex>

#include "driver/large_text.hpp"

namespace obrys::driver {

std::unique_ptr<base::Store> Storage::read_large(const fs::path& /*path*/, const std::string& /*shown*/,
                                                 std::uintmax_t /*size*/) const {
    return nullptr;
}

namespace {

fs::path or_here(const fs::path& folder) { return folder.empty() ? fs::path(".") : folder; }

class Disk final : public Storage {
public:
    [[nodiscard]] StoredEntry look(const fs::path& path) const override {
        using Kind = StoredEntry::Kind;
        std::error_code error;
        const fs::file_status status = fs::status(path, error);
        // Not "not there": its folder may not be looked into, links go round.
        if (status.type() == fs::file_type::none) return {Kind::unreadable, 0, error.value()};
        if (!fs::exists(status) && fs::is_symlink(fs::symlink_status(path, error)))
            return {Kind::dead_link, 0, 0, fs::read_symlink(path, error)};
        if (!fs::exists(status)) return {};
        if (fs::is_directory(status)) return {Kind::folder};
        if (!fs::is_regular_file(status)) return {Kind::other};
        const std::uintmax_t size = fs::file_size(path, error);
        return error ? StoredEntry{Kind::unreadable, 0, error.value()} : StoredEntry{Kind::file, size};
    }

    [[nodiscard]] int read(const fs::path& path, std::uintmax_t size, std::string& bytes) const override {
        errno = 0;
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.string().c_str(), "rb"), std::fclose);
        if (in == nullptr) return errno != 0 ? errno : EIO;
        if (size == 0 && std::fgetc(in.get()) != EOF) return EINVAL;  // a window into the system, which has no size
        if (std::ferror(in.get()) != 0) return errno != 0 ? errno : EIO;
        bytes.resize(static_cast<std::size_t>(size));
        bytes.resize(std::fread(bytes.data(), 1, bytes.size(), in.get()));
        if (std::ferror(in.get()) == 0) return 0;
        return errno != 0 ? errno : EIO;
    }

    [[nodiscard]] std::unique_ptr<base::Store> read_large(const fs::path& path, const std::string& shown,
                                                          std::uintmax_t size) const override {
        return read_large_text(path.string(), shown, size);
    }

    [[nodiscard]] std::vector<fs::path> list(const fs::path& folder) const override {
        std::error_code error;
        std::vector<fs::path> found;
        for (const fs::directory_entry& entry : fs::directory_iterator(or_here(folder), error))
            found.push_back(entry.path().lexically_normal());
        return found;
    }

    [[nodiscard]] std::optional<std::int64_t> changed(const fs::path& folder) const override {
        std::error_code error;
        const fs::file_time_type at = fs::last_write_time(or_here(folder), error);
        if (error) return std::nullopt;
        return static_cast<std::int64_t>(at.time_since_epoch().count());
    }
};

/// `whole`: from the root, so that all spellings of a file of the disk are one.
std::string key_of(const fs::path& path, bool whole) {
    std::error_code error;
    const fs::path named = whole ? fs::absolute(path, error) : path;
    return named.lexically_normal().generic_string();
}

/// With which the keys of all that is in the folder begin.
std::string prefix_of(const fs::path& folder, bool whole) {
    const fs::path normal = key_of(or_here(folder), whole);
    if (normal == "." || normal == "./") return {};
    return (normal / "").generic_string();
}

bool is_below(const std::string& key, const std::string& prefix) {
    return key.starts_with(prefix) && (!prefix.empty() || (!key.starts_with('/') && !key.starts_with("../")));
}

}  // namespace

std::shared_ptr<const Storage> disk() {
    static const auto the_disk = std::make_shared<const Disk>();
    return the_disk;
}

void Memory::put(const fs::path& path, std::string bytes) {
    const std::unique_lock alone(use_);
    ++changes_;
    files_[key_of(path, below_ != nullptr)] = std::make_shared<const std::string>(std::move(bytes));
}

bool Memory::remove(const fs::path& path) {
    const std::unique_lock alone(use_);
    ++changes_;
    return files_.erase(key_of(path, below_ != nullptr)) > 0;
}

std::shared_ptr<const Memory> Memory::snapshot() const {
    auto copy = std::make_shared<Memory>(below_);
    const std::shared_lock together(use_);
    copy->files_ = files_;
    copy->changes_ = changes_;
    return copy;
}

bool Memory::holds(const fs::path& path) const {
    const std::shared_lock together(use_);
    return files_.contains(key_of(path, below_ != nullptr));
}

StoredEntry Memory::look(const fs::path& path) const {
    {
        const std::shared_lock together(use_);
        if (const auto found = files_.find(key_of(path, below_ != nullptr)); found != files_.end())
            return {StoredEntry::Kind::file, found->second->size()};
    }
    if (below_ != nullptr)
        if (StoredEntry there = below_->look(path); there.kind != StoredEntry::Kind::nothing) return there;
    const std::string prefix = prefix_of(path, below_ != nullptr);
    const std::shared_lock together(use_);
    const auto first = files_.lower_bound(prefix);
    const bool folder = prefix.empty() || (first != files_.end() && first->first.starts_with(prefix));
    return {folder ? StoredEntry::Kind::folder : StoredEntry::Kind::nothing};
}

int Memory::read(const fs::path& path, std::uintmax_t size, std::string& bytes) const {
    {
        const std::shared_lock together(use_);
        if (const auto found = files_.find(key_of(path, below_ != nullptr)); found != files_.end()) {
            bytes = *found->second;
            return 0;
        }
    }
    return below_ == nullptr ? ENOENT : below_->read(path, size, bytes);
}

std::unique_ptr<base::Store> Memory::read_large(const fs::path& path, const std::string& shown,
                                                std::uintmax_t size) const {
    return below_ == nullptr || holds(path) ? nullptr : below_->read_large(path, shown, size);
}

std::vector<fs::path> Memory::list(const fs::path& folder) const {
    std::vector<fs::path> found;
    if (below_ != nullptr)
        for (fs::path& path : below_->list(folder))
            if (!holds(path)) found.push_back(std::move(path));
    const std::string prefix = prefix_of(folder, below_ != nullptr);
    const std::shared_lock together(use_);
    for (auto it = files_.lower_bound(prefix); it != files_.end() && it->first.starts_with(prefix); ++it)
        if (is_below(it->first, prefix) && it->first.find('/', prefix.size()) == std::string::npos)
            found.push_back((folder / it->first.substr(prefix.size())).lexically_normal());
    return found;
}

std::optional<std::int64_t> Memory::changed(const fs::path& folder) const {
    std::optional<std::int64_t> there = 0;
    // A folder that is in memory alone is none that the storage below could say something of.
    if (below_ != nullptr && below_->look(folder).kind == StoredEntry::Kind::folder) there = below_->changed(folder);
    const std::shared_lock together(use_);
    if (!there) return std::nullopt;
    return static_cast<std::int64_t>((static_cast<std::uint64_t>(*there) ^ static_cast<std::uint64_t>(changes_)) *
                                     0x9E3779B97F4A7C15U);
}

}  // namespace obrys::driver
