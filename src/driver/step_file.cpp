#include "driver/step_file.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "driver/loadable.hpp"
#include "driver/step_answer.hpp"
#include "mesh/solids.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

constexpr double share_of_tolerance = 0.2;
/// Of the deflection that is wanted, what Open CASCADE is asked for: on a ball it was up to 1.23 times what was asked.
constexpr double asked_for = 0.75;
constexpr double finest_deflection = 0.0005;  ///< mm; below it triangles grow without end and say nothing more
constexpr double turn_of_facets = 0.2;        ///< radians from one edge of a facet to the next
constexpr std::string_view begins = "ISO-10303-21", ends = "END-ISO-10303-21";
constexpr std::string_view or_stl = ", or give the body as STL";

/// Complaints about the file as a whole.
class Complaints {
public:
    Complaints(std::uint32_t file, base::Diagnostics& out) : file_(file), out_(out) {}

    std::nullopt_t refuse(std::string text, std::string remedy, std::string_view code = codes::mesh_file) {
        return refuse_at({file_, 0, 0}, std::move(text), std::move(remedy), code);
    }
    std::nullopt_t refuse_at(const base::Span& where, std::string text, std::string remedy,
                             std::string_view code = codes::mesh_file) {
        out_.add({base::Severity::error, code, where, std::move(text), std::move(remedy), {}, {}});
        return std::nullopt;
    }
    /// `line` counts from 1; 0: the file as a whole.
    std::nullopt_t refuse_line(std::string_view bytes, std::uint64_t line, std::string text, std::string remedy) {
        std::size_t begin = 0;
        for (std::uint64_t n = 1; n < line && begin < bytes.size(); ++n) {
            const std::size_t end = bytes.find('\n', begin);
            begin = end == std::string_view::npos ? bytes.size() : end + 1;
        }
        if (line == 0 || begin >= bytes.size() || bytes.size() > largest_quoted)
            return refuse(std::move(text) + (line == 0 ? "" : " (line " + std::to_string(line) + ")"),
                          std::move(remedy));
        const std::size_t end = std::min(bytes.find_first_of("\r\n", begin), bytes.size());
        return refuse_at({file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}, std::move(text),
                         std::move(remedy));
    }
    void warn(std::string_view code, base::Severity severity, std::string text, std::string remedy) {
        out_.add({severity, code, {file_, 0, 0}, std::move(text), std::move(remedy), {}, {}});
    }

private:
    std::uint32_t file_;
    base::Diagnostics& out_;
};

/// False after a complaint: what can be seen of a file without its module.
bool looks_whole(std::string_view bytes, Complaints& complaints) {
    constexpr std::string_view bom = "\xef\xbb\xbf";
    const std::string_view text = bytes.substr(bytes.substr(0, bom.size()) == bom ? bom.size() : 0);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        complaints.refuse("the STEP file is empty", {}, codes::file_empty);
    } else if (text.substr(first, begins.size()) != begins) {
        complaints.refuse(
            "this is no STEP file: it does not begin with " + std::string(begins),
            "export it as STEP (AP203, AP214 or AP242), not packed; the name of an STL file ends in .stl");
    } else if (text.rfind(ends) == std::string_view::npos) {
        complaints.refuse("the STEP file is cut off: there is no " + std::string(ends) + " at its end",
                          "export or copy it again");
    } else if (base::looks_binary(bytes)) {
        complaints.refuse("the STEP file is damaged: it holds bytes that are no text", "export or copy it again");
    } else {
        return true;
    }
    return false;
}

std::string folders() {
    std::string out;
    for (const auto& folder : module_folders()) out += (out.empty() ? "" : ", ") + folder.generic_string();
    return out.empty() ? "there is no folder of modules" : "libobrys-step.so is not in " + out;
}

std::string remedy_of(int outcome) {
    switch (outcome) {
        case mesh::obrys_step_no_solid: return "export the body as a solid, not as surfaces, wires or facets";
        case mesh::obrys_step_memory: return "ask for a coarser tolerance (--tolerance)" + std::string(or_stl);
        default: return "export it again, as AP203, AP214 or AP242" + std::string(or_stl);
    }
}

struct Work {
    std::uint32_t file;
    std::string_view bytes;
    std::string module;
    const Guard& guard;
    const base::Span& where;
};

/// Nothing, after a complaint, where the module could not be used, did not come to an end, or refuses the file.
std::optional<StepAnswer> answer_of(const Guarded& run, const Work& work, Complaints& complaints) {
    const std::string again = "export it again, as AP203, AP214 or AP242" + std::string(or_stl);
    switch (run.end) {
        case Guarded::End::crashed:
            return complaints.refuse("Open CASCADE, which reads STEP files, crashed on this one" +
                                         (run.signal == 0 ? "" : " (signal " + std::to_string(run.signal) + ")"),
                                     again);
        case Guarded::End::late:
            return complaints.refuse(
                "reading the STEP file was given up after " + base::shortest(work.guard.seconds) + " s",
                "ask for a coarser tolerance (--tolerance), or export it again" + std::string(or_stl));
        case Guarded::End::too_much:
            return complaints.refuse("the STEP file makes more triangles than there is memory for",
                                     remedy_of(mesh::obrys_step_memory));
        case Guarded::End::done: break;
    }
    auto answer = parse_answer(run.answer);
    if (!answer) return complaints.refuse("what Open CASCADE makes of the STEP file is no mesh", again);
    if (!answer->loading.empty())
        return complaints.refuse_at(
            work.where, "the module that reads STEP files cannot be used: " + answer->loading,
            "install Open CASCADE (Debian: libocct-data-exchange-7.6) and the obrys-step of this "
            "obrys" +
                std::string(or_stl));
    if (answer->result.outcome != mesh::obrys_step_ok)
        return complaints.refuse_line(work.bytes, answer->result.line, answer->problem,
                                      remedy_of(answer->result.outcome));
    return answer;
}

void remark_rest(const mesh::ObrysStepResult& result, Complaints& complaints) {
    const auto faces = [](std::uint64_t n) { return std::to_string(n) + (n == 1 ? " face" : " faces"); };
    if (result.faces_unmeshed > 0)
        complaints.warn(codes::mesh_not_closed, base::Severity::warning,
                        faces(result.faces_unmeshed) + " could not be made into triangles: there are holes",
                        "export it again" + std::string(or_stl));
    if (result.complaints > 0)
        complaints.warn(codes::assumption, base::Severity::note,
                        "of the STEP file " + std::to_string(result.complaints) +
                            (result.complaints == 1 ? " entry is" : " entries are") +
                            " not as Open CASCADE expects: what they say may be missing",
                        {});
    if (result.loose_faces > 0)
        complaints.warn(codes::assumption, base::Severity::note,
                        faces(result.loose_faces) + " that bound no solid left out", {});
}

std::optional<StepFile> solids_of(std::uint32_t file, const StepAnswer& answer, base::Diagnostics& out) {
    Complaints complaints(file, out);
    StepFile step;
    step.closed = answer.result.faces_unmeshed == 0;
    remark_rest(answer.result, complaints);
    for (const mesh::Mesh& soup : answer.solids) {
        mesh::Mesh solid = mesh::settled(file, soup, step.closed, out);
        if (!solid.empty()) step.solids.push_back(std::move(solid));
    }
    if (step.solids.empty()) return complaints.refuse("no body of the STEP file has a surface", remedy_of(0));
    return step;
}

struct Attempt {
    std::optional<StepFile> step;
    base::Diagnostics said;
    bool worth_another = false;  ///< the other way of making triangles may do better
};

Attempt try_once(const Work& work, const mesh::ObrysStepFineness& fineness) {
    const Guarded run =
        guarded(work.guard, [&](const Answer& answer) { ask_module(work.module, work.bytes, fineness, answer); });
    Attempt out;
    Complaints complaints(work.file, out.said);
    const auto answer = answer_of(run, work, complaints);
    if (answer) out.step = solids_of(work.file, *answer, out.said);
    out.worth_another = run.end == Guarded::End::crashed || (out.step && !out.step->closed);
    return out;
}

}  // namespace

double step_deflection(double tolerance) { return std::max(share_of_tolerance * tolerance, finest_deflection); }

std::optional<StepFile> read_step(std::uint32_t file, std::string_view bytes, double tolerance, const Guard& guard,
                                  base::Diagnostics& out, const base::Span& where) {
    Complaints complaints(file, out);
    if (!looks_whole(bytes, complaints)) return std::nullopt;
    const auto module = find_module("step");
    if (!module)
        return complaints.refuse_at(where, "STEP files need a module that is not installed: " + folders(),
                                    "install the package obrys-step, or build obrys where libocct-data-exchange-dev is "
                                    "installed" +
                                        std::string(or_stl));
    mesh::ObrysStepFineness fineness{asked_for * step_deflection(tolerance), turn_of_facets, 0};
    const Work work{file, bytes, module->string(), guard, where};
    Attempt attempt = try_once(work, fineness);
    if (attempt.worth_another) {
        fineness.other_way = 1;
        Attempt other = try_once(work, fineness);
        if (other.step && other.step->closed) attempt = std::move(other);
    }
    for (const base::Diagnostic& d : attempt.said.all()) out.add(d);
    return std::move(attempt.step);
}

}  // namespace obrys::driver
