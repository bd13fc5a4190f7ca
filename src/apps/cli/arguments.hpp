#pragma once
/// The command line: what it asks for. CLI11 stays in arguments.cpp.

#include <string>
#include <vector>

#include "cutting_arguments.hpp"
#include "driver/keep.hpp"
#include "driver/milling_job.hpp"
#include "driver/output_file.hpp"
#include "driver/session.hpp"
#include "format/heidenhain/format.hpp"
#include "make_arguments.hpp"
#include "post_arguments.hpp"

namespace obrys::cli {

enum class Command : int {
    none,
    check,
    run,
    plot,
    fmt,
    translate,
    compare,
    sheet,
    time,
    calibrate,
    data,
    cost,
    blade,
    force,
    make,
    post,
    version
};

struct Arguments {
    Command command = Command::none;
    driver::Request request;
    std::vector<std::string> inputs;   ///< of check and sheet: one or several
    std::vector<std::string> fail_on;  ///< of check: codes and severities; empty: every finding
    std::string baseline;              ///< of check: file of known findings
    std::string write_baseline;
    std::string format = "text";
    bool format_given = false;                    ///< of sheet: else the name of the output says it
    std::string output;                           ///< empty: standard output
    std::string html, svg;                        ///< of check: also write these; svg of plot: the picture
    std::string stl, three_mf, gltf;              ///< of check: the milled surface
    std::string plan_view, projections, picture;  ///< of check: its pictures, .svg or .png
    std::string engagement;                       ///< of check: table of the milling moves, .csv or .json
    driver::MillingRequest milling;               ///< of check
    double interpolation = 0;                     ///< of plot: basic length unit, mm; 0: none given
    bool quiet = false;       ///< of run: counts only; of check: verdict, findings, what was not checked
    bool parameters = false;  ///< of run: numbered parameters at the end
    bool colours = true;
    bool all = false;                ///< of check: what every move of a finding did
    bool no_list = false;            ///< of check: leave out what has no effect on the verdict
    std::vector<std::string> files;  ///< of fmt
    format::heidenhain::Options style;
    PostArguments post;
    MakeArguments make;
    CuttingArguments cutting;
    std::string to;                     ///< of translate and calibrate: a post or a control
    bool keep = false;                  ///< of translate: statement by statement
    int sets = 3;                       ///< of translate --keep: how many sets of other values are run
    std::string ledger;                 ///< of translate: written (.json, .html, else text); of compare: read
    bool into_folder = false;           ///< of translate: `output` is one, whose files are known later
    bool accept_loss = false;           ///< of translate: write also what lacks something
    std::vector<std::string> variants;  ///< of time: "tolerance=0.01,0.05"
    std::size_t lines = 10;             ///< of time: how many of the slowest
    bool advise = false;                ///< of time: on the tolerance
    bool test_program = false;          ///< of calibrate: written, by the post `to`
    double size = 100, feed = 6000;     ///< of it: mm, mm/min
    std::string since;                  ///< of sheet: an older one (.json)
    bool job = false;                   ///< of sheet: all programs together, too
    std::vector<std::string> map;       ///< of compare: "R3=Q3"
    std::string other;                  ///< of compare: what `request.input` is held against
    std::string control_a, control_b;   ///< of compare: of one of both alone
    std::string job_file;               ///< of compare: for both programs
    double chord = 0;                   ///< of translate, mm: curves without words as straight lines; 0: refused
    double same_place = 1e-4;           ///< of compare, mm
    bool in_place = false;              ///< of fmt: write the files
    bool only_check = false;            ///< of fmt: say what would change
    int exit = -1;  ///< 0 … : the program ends here with this code (help was printed, or the call is wrong)
};

[[nodiscard]] Arguments parse(int argc, char** argv);

/// The files that the call writes, with their options.
[[nodiscard]] std::vector<driver::Wanted> outputs_of(const Arguments& a);

}  // namespace obrys::cli
