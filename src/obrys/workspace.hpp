#pragma once
/// The door to everything: texts go into a workspace, a prepared program comes out, which is then run, checked or
/// translated as often as wanted (run.hpp, check.hpp, translate.hpp). These headers name types of the standard library
/// only and keep their meaning within a major version (version.hpp); what lies below them may change.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace obrys::driver {
class Image;
class Memory;
}  // namespace obrys::driver

namespace obrys::api {

/// A place in a text. Lines and columns count from 1; 0: no place.
struct Place {
    std::string file;
    std::uint32_t line = 0, column = 0;
};

enum class Severity : std::uint8_t { note, warning, error };

/// Something to be told to the programmer.
struct Message {
    Severity severity = Severity::error;
    std::string code;    ///< stable, lower-case: docs/diagnostics.md
    std::string text;    ///< what is wrong, in the words of the programmer's control
    std::string remedy;  ///< what to do about it; may be empty
    Place where;
    std::vector<Place> called_from;  ///< call sites, innermost first
};

/// What a command line says, of every run of the prepared program. What is left empty is as the job says, else as
/// obrys finds it.
struct Options {
    std::string control;                     ///< "sinumerik-840d"; names: controls()
    std::string machine;                     ///< a shipped one or a machine file
    std::vector<std::string> search, tools;  ///< folders of called programs; tool tables
    std::map<std::string, double> set;       ///< {"R3", 150}: replaces every constant that the program assigns to it
    std::vector<int> skip;                   ///< block skip levels that are on
    std::optional<double> tolerance;         ///< of the milling simulation, mm
};

/// What one run has for itself, above the options.
struct Inputs {
    std::map<std::string, double> set;
    std::vector<int> skip;
};

/// A program with its job, machine, tools and everything it calls by name, read and resolved. It never changes, copies
/// are the same one, and threads may run it at once. Later changes of the workspace do not reach it. What no name in
/// the text tells (programs called by a computed name, tables, and all that a translation's proof reads) is read when
/// it is wanted: over the disk as it is by then.
class Image {
public:
    /// False: there is nothing that could be run; messages() say why.
    [[nodiscard]] bool usable() const;
    /// What reading it complained about; of called programs, what the run says that calls them.
    [[nodiscard]] std::vector<Message> messages() const;
    [[nodiscard]] std::string control() const;  ///< empty where it is not known
    [[nodiscard]] std::string program() const;  ///< path of the main program

    /// Of this library alone.
    explicit Image(std::shared_ptr<const driver::Image> of);
    [[nodiscard]] const driver::Image& inside() const { return *image_; }

private:
    std::shared_ptr<const driver::Image> image_;
};

/// Texts by their paths. Paths are relative to one another as in a folder ("subs/STEP.SPF"); bodies (STL, STEP) are
/// texts, too.
class Workspace {
public:
    /// Holds what is put into it and nothing else: no file of the machine is read.
    [[nodiscard]] static Workspace in_memory();
    /// What is put into it stands in front of the files of the disk: an editor's unsaved texts.
    [[nodiscard]] static Workspace over_disk();

    /// Adds a text, or replaces it.
    void put(const std::string& path, std::string bytes);
    /// False where none was put there. The disk's own file is seen again.
    bool remove(const std::string& path);

    /// Reads `input`, a program or a job file (.toml), and all that belongs to it.
    [[nodiscard]] Image prepare(const std::string& input, const Options& options = {}) const;

private:
    explicit Workspace(std::shared_ptr<driver::Memory> memory);
    std::shared_ptr<driver::Memory> memory_;
};

/// Names of the controls whose programs can be read.
[[nodiscard]] std::vector<std::string> controls();

}  // namespace obrys::api
