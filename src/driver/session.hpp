#pragma once
/// What a command works on: the job with everything it names, loaded and resolved.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "cl/stacks.hpp"
#include "driver/programs.hpp"
#include "driver/shop_files.hpp"
#include "interp/flow/machine.hpp"
#include "interp/interp.hpp"
#include "shop/job.hpp"

namespace obrys::driver {

/// The command line, as far as it concerns what is run.
struct Request {
    std::string input;                ///< a program, or a job file (.toml)
    std::string program;              ///< with a job: in the place of its own, which may be of another control
    std::string control, machine;     ///< empty: as the job says, else found from the content
    std::vector<std::string> set;     ///< "R3=150"
    std::vector<std::string> search;  ///< folders
    std::vector<int> skip;            ///< block skip levels that are on
    std::string prints;               ///< folder for what programs print; empty: as the job says, else nowhere
    bool prints_nowhere = false;      ///< whatever the job says
    bool for_these_values = false;   ///< the answer is for this run alone: programs whose calls it passes by are no gap
    std::optional<bool> diameter;    ///< X words are diameters at the start
    std::vector<std::string> tools;  ///< tool tables, besides those of the job
    std::string configuration;       ///< of a LinuxCNC machine (.ini)
    std::string stored;              ///< its parameter file (.var)
    std::optional<shop::Scope> scope;  ///< else as the job says
    bool force = false;                ///< files that are there may be replaced
    std::vector<std::string> outputs;  ///< files that the call writes itself: no program prints into them
    std::vector<std::string> inputs;   ///< all of the call: nor into these
    std::shared_ptr<Folders> folders = std::make_shared<Folders>();  ///< of all inputs of a call
    /// Stands in the place of the program's file: what would be written beside it. What is given or set for that
    /// program's variables does not count for it.
    std::shared_ptr<const std::string> text{};
    shop::GivenValues given{};   ///< of `text`: in the place of [variables] of the job
    bool homes_at_zero = false;  ///< as Environment says it
    bool stand_alone = false;    ///< run as LinuxCNC's interpreter by itself runs it, from the machine's zero
    bool keeps_remarks = false;  ///< what the programmer has written for people goes into the stream
};

struct Session {
    Session() = default;
    /// For a further run of what another session has opened, which then must not change any more: shares its texts and
    /// programs and has everything else for itself.
    explicit Session(std::shared_ptr<const Session> opened);
    Session(const Session&) = delete;  // its programs point into it
    Session& operator=(const Session&) = delete;

    std::shared_ptr<const Session> shares;  ///< null: it has read all itself
    std::shared_ptr<const Storage> storage = disk();
    base::Sources sources;
    base::Diagnostics diagnostics;
    shop::Job job;
    std::string program;  ///< path of the main program, as shown
    std::string input;    ///< job file or program: names in the job count from its folder
    std::string control;
    std::unique_ptr<Programs> programs;
    std::unique_ptr<ShopFiles> files;
    const program::Unit* main = nullptr;
    std::optional<geom::Region> part, allowance;
    bool right_face = false;  ///< check::Setup::right_face
    cl::CallStacks stacks;
    std::map<std::uint32_t, double> stored;       ///< numbered parameters that the control holds
    std::map<std::string, std::string> settings;  ///< of the control, "SECTION/KEY" in capitals
    double machine_unit = 1;                      ///< mm of a length of 1 in its tables
    bool has_stored = false;
    bool spindle_goes_on = false;   ///< through a tool change, as the configuration says
    bool stand_alone = false;       ///< as the request says
    bool for_these_values = false;  ///< as the request says
    bool homes_at_zero = false;     ///< as Environment says it
    bool has_job = false;
    std::uint32_t looked_ahead_in_vain = 0;  ///< for tests, as Environment says it
    bool unusable = false;                   ///< a file that the job names is not what it should be
};

/// Loads job, machine, tools and main program, and resolves the contours. False where the input cannot be used at all
/// (exit code 2); what is wrong stands in the session's diagnostics.
bool open(const Request& request, Session& session);

/// What the interpreter needs of a session, which must outlive it and stay where it is.
class EnvironmentOf {
    std::function<const program::Unit*(std::string_view)> find_;
    std::function<const program::Unit*(const std::string&)> read_text_;

public:
    explicit EnvironmentOf(Session& session);
    EnvironmentOf(const EnvironmentOf&) = delete;
    EnvironmentOf& operator=(const EnvironmentOf&) = delete;
    const interp::Environment environment;
};

/// The main program interpreted to `sink`, step by step; both must outlive it.
class Interpretation {
public:
    Interpretation(Session& session, cl::Sink sink, std::optional<interp::Listener> listener = {});
    /// Makes the next statement; false where the run has ended.
    bool step() { return machine_.step(); }
    /// Once, behind the last step: what is left of the stream, and what only the whole run tells.
    interp::Outcome finish();

private:
    Session& session_;
    EnvironmentOf parts_;
    interp::Machine machine_;
};

/// Interprets the main program to `sink`; `listener` hears what the control is told.
interp::Outcome interpret(Session& session, cl::Sink sink, std::optional<interp::Listener> listener = {});

/// What the job or the command line says cannot be used, which only the run could tell (exit code 2).
[[nodiscard]] bool refused(const Session& session);

/// Of a run alone: 2 refused, 3 something was not understood or run, 1 the control would stop or something else is
/// wrong.
[[nodiscard]] int exit_code_of_run(const Session& session);
/// The same of a program that is translated: what no run of it comes to is said, and is nothing that is not compared.
[[nodiscard]] int exit_code_of_translation(const Session& session);
/// mm: the control of the program takes coordinates in such steps; 0: as they are written.
[[nodiscard]] double increment_of(const Session& session);

/// Lines of the main program's text that hold `%` alone, two at most; 0 where it does not begin with one.
[[nodiscard]] int percent_lines(const Session& session);

/// Names of the controls whose programs can be read.
[[nodiscard]] std::vector<std::string> controls();

}  // namespace obrys::driver
