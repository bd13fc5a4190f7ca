#pragma once
/// Tables and forms beside the program, and what a program prints: the files behind interp::ShopFiles.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "driver/files.hpp"
#include "driver/folders.hpp"
#include "interp/shop_files.hpp"
#include "shop/machine.hpp"

namespace obrys::driver {

class ShopFiles final : public interp::ShopFiles {
public:
    /// References must outlive it.
    ShopFiles(base::Sources& sources, base::Diagnostics& diagnostics, std::shared_ptr<Folders> listings)
        : sources_(sources), diagnostics_(diagnostics), listings_(std::move(listings)) {}
    /// For a further run with the files of `prepared`.
    ShopFiles(const ShopFiles& prepared, base::Sources& sources, base::Diagnostics& diagnostics);

    /// A folder in which tables and forms are looked for, in the order of the calls.
    void add_folder(const fs::path& folder);
    /// A file that stands above those of the folders.
    void add_file(const fs::path& path);
    /// Where printed files go; without it they are lost.
    void print_to(const fs::path& folder) { prints_ = folder; }
    /// Whether the program's prints may replace files that were there before; behind them they are put in any case.
    void set_force(bool force) { force_ = force; }
    /// Files that the call reads besides what was loaded here, and those that it writes itself: no print goes there.
    void keep(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
        inputs_.assign(inputs.begin(), inputs.end());
        outputs_.assign(outputs.begin(), outputs.end());
    }
    /// Writes what was printed, and forgets it. False (and a complaint) where that fails.
    bool write_printed();
    [[nodiscard]] bool failed() const { return failed_; }

    const interp::DatumTable* datum_table(std::string_view name) override;
    shop::HeidenhainTable* table(std::string_view name) override;
    const std::string* form(std::string_view name) override;
    bool print(std::string_view name, std::string_view text, bool again) override;

private:
    [[nodiscard]] std::optional<fs::path> path_of(std::string_view name) const;
    [[nodiscard]] std::optional<fs::path> usual_datum_table() const;

    base::Sources& sources_;
    base::Diagnostics& diagnostics_;
    std::shared_ptr<Folders> listings_;
    std::vector<fs::path> files_;  ///< tables and forms, those that come first first
    std::size_t named_ = 0;        ///< how many of them were named one by one
    std::unordered_map<std::string, std::unique_ptr<interp::DatumTable>> datums_;
    std::unordered_map<std::string, std::unique_ptr<shop::HeidenhainTable>> tables_;
    std::unordered_map<std::string, std::unique_ptr<std::string>> forms_;
    std::optional<fs::path> prints_;
    struct Printed {
        std::string text;
        bool replaces = false;  ///< what stood in the file before is lost
    };
    [[nodiscard]] bool may_write(const fs::path& path, const Printed& printed);

    std::map<std::string, Printed> printed_;
    std::vector<fs::path> inputs_, outputs_;
    bool force_ = false, failed_ = false;
};

/// The presets of a table (.PR) become datums of the machine; those that it has already stay.
void add_presets(const Storage& storage, const fs::path& path, const base::Span& where, base::Sources& sources,
                 base::Diagnostics& diagnostics, shop::Machine& machine);

}  // namespace obrys::driver
