#pragma once
/// The programs of a run: the main one and those it calls, found by name and read when first needed.

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.hpp"
#include "driver/control.hpp"
#include "driver/files.hpp"
#include "driver/folders.hpp"
#include "program/unit.hpp"

namespace obrys::driver {

class Programs {
public:
    Programs(const Control& control, base::Sources& sources, base::Diagnostics& diagnostics,
             std::shared_ptr<Folders> listings = std::make_shared<Folders>())
        : control_(control), sources_(sources), diagnostics_(&diagnostics), listings_(std::move(listings)) {}

    /// For a further run of what `prepared` has read, which must outlive it and must not change any more: shares its
    /// programs, and reads what is wanted besides into sources and names of its own.
    Programs(const Programs& prepared, base::Sources& sources, base::Diagnostics& diagnostics);
    Programs(const Programs&) = delete;
    Programs& operator=(const Programs&) = delete;
    ~Programs() = default;

    /// The machine that the programs are for, where somebody has named it; must outlive the reading.
    void set_machine(const shop::Machine* machine) { machine_ = machine; }
    /// What is read from now on has its remarks.
    void keep_remarks() { keeps_remarks_ = true; }
    /// Folder in which called programs are looked for, in the order of the calls of this function.
    void add_folder(const fs::path& folder);
    /// Reads a program that is already among the sources; the first unit of an archive is the main one.
    const program::Unit* read(std::uint32_t file);
    /// The program of that name (upper case; with a suffix, or without), read from its folder when first asked for; or
    /// null. Where no file has the suffix of the call, one of the same name is taken.
    const program::Unit* find(std::string_view name);
    /// Reads what the programs that were read call by name, and what these call, so that no run has to. They are found
    /// by name, and what is wrong with them is said, when a run calls them: as if they were read then.
    void read_called();
    /// Programs read so far that stand in a file, in the order of its text.
    [[nodiscard]] std::vector<const program::Unit*> of_file(std::uint32_t file) const;
    /// Reads a text that the program itself makes as a program without a name.
    const program::Unit* read_text(const std::string& text);
    /// Reads a backup of the control's variables that is already among the sources; it is no program to be called.
    void read_backup(std::uint32_t file);
    /// Reads the definition files of the folders, where the control has such.
    void read_definitions();

    /// The folders and the endings of files, as part of a sentence: "the folder of the program or sub (.ngc, .nc)".
    [[nodiscard]] std::string searched() const;
    [[nodiscard]] const std::vector<const program::Unit*>& definitions() const { return definitions_; }
    [[nodiscard]] const std::vector<const program::Unit*>& backups() const { return backups_; }
    /// All programs and definitions that were read so far.
    [[nodiscard]] const std::vector<std::shared_ptr<const program::Unit>>& units() const { return units_; }
    [[nodiscard]] program::Names& names() { return names_; }

private:
    /// A text that was read, and what is wrong with it.
    struct Read {
        std::vector<std::shared_ptr<const program::Unit>> units;
        std::vector<base::Diagnostic> said;
    };
    [[nodiscard]] std::vector<std::shared_ptr<const program::Unit>> units_of(std::uint32_t file);
    /// Makes units known by their names; the first one.
    const program::Unit* enter(std::vector<std::shared_ptr<const program::Unit>> units);
    /// The file's first program: read, or read ahead; null after a complaint. The units of the file are known then.
    const program::Unit* read_file(const fs::path& path);
    [[nodiscard]] std::optional<std::uint32_t> load_program(const fs::path& path);
    /// The files that `find` would read for a name, whatever is known by then.
    [[nodiscard]] std::vector<fs::path> files_of(const std::string& name) const;
    /// The program of that name, from the file that Control::file_stem says, or from one of its own name.
    const program::Unit* find_in_file(const std::string& key);
    /// Behind the loading of `full`: another file of its folder differs in small and capital letters alone.
    void say_twin(std::uint32_t file, const std::string& full);
    /// The file of that name in the first folder that has one.
    [[nodiscard]] const fs::path* file_of(const std::string& name) const;
    void read_definition(const fs::path& path);

    const Control& control_;
    base::Sources& sources_;
    base::Diagnostics* diagnostics_;
    const shop::Machine* machine_ = nullptr;
    bool keeps_remarks_ = false;
    program::Names names_;
    std::vector<std::shared_ptr<const program::Unit>> units_;
    std::vector<const program::Unit*> definitions_, backups_;
    std::vector<std::shared_ptr<const program::Unit>> backup_units_;
    std::unordered_map<std::string, const program::Unit*> by_name_;
    std::shared_ptr<Folders> listings_;
    std::vector<std::shared_ptr<const ProgramIndex>> found_;       ///< of the folders, in their order
    std::unordered_map<std::string, const program::Unit*> texts_;  ///< those that the program made
    std::vector<std::string> folders_;
    std::map<fs::path, Read> ahead_;  ///< what was read ahead and is not known by name yet
};

}  // namespace obrys::driver
