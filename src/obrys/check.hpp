#pragma once
/// Runs a prepared program, simulates it, and holds it to part, stock, clamps, machine and tools.

#include "obrys/workspace.hpp"

namespace obrys::api {

enum class Verdict : std::uint8_t {
    clean,              ///< everything was run and checked, nothing was found
    findings,           ///< everything was run and checked
    not_fully_checked,  ///< something was not understood, run or simulated; there may be findings as well
};

/// One cause; its worst move speaks for it.
struct Finding {
    Message message;
    std::uint64_t times = 1;                  ///< moves of this cause
    std::optional<std::uint64_t> first_move;  ///< as Move::index counts; none: it is no move's
    std::map<std::string, double> amounts;    ///< "depth_mm", "area_mm2": docs/report-json.md
};

/// Documents that are wanted besides.
struct Documents {
    bool json = false;  ///< docs/report-json.md
    bool text = false;  ///< as the command line prints it
    bool html = false;  ///< a page that needs no network
};

struct Checked {
    Verdict verdict = Verdict::not_fully_checked;
    std::vector<Finding> findings;
    std::vector<Message> unchecked;    ///< why it is not fully checked
    std::vector<Message> assumptions;  ///< what was taken for granted
    std::uint64_t moves = 0;
    std::string json, text, html;
};

/// Throws std::invalid_argument where the image is not usable. Values for what no program of the run uses (Inputs::set,
/// Options::set) make it not fully checked, and are named there.
[[nodiscard]] Checked check(const Image& image, const Inputs& inputs = {}, const Documents& documents = {});

}  // namespace obrys::api
