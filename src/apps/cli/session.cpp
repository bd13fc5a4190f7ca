#include "session.hpp"

#include <cstdio>

#include "driver/wording.hpp"

namespace obrys::cli {

void print_diagnostics(const driver::Session& s, base::Severity from) {
    const bool offset_numbers = s.main != nullptr && s.main->traits->edge_is_offset_number;
    for (base::Diagnostic d : s.diagnostics.all()) {
        if (d.severity < from) continue;
        driver::reword(d.text, d.remedy, s.control, offset_numbers);
        std::fputs(base::render(d, s.sources).c_str(), stderr);
    }
}

void print_diagnostics(const driver::cutting::Texts& texts) {
    for (const base::Diagnostic& d : texts.diagnostics.all())
        std::fputs(base::render(d, texts.sources).c_str(), stderr);
}

bool may_write(const Arguments& a, const std::vector<driver::fs::path>& inputs) {
    const auto refused = driver::refusals(outputs_of(a), inputs, a.request.force);
    for (const std::string& why : refused) std::fprintf(stderr, "obrys: %s\n", why.c_str());
    return refused.empty();
}

bool may_write(const Arguments& a, const driver::Session& s) {
    std::vector<driver::fs::path> inputs = driver::inputs_of(s);
    inputs.insert(inputs.end(), a.inputs.begin(), a.inputs.end());  // those of a call share its outputs
    // A baseline may be brought up to date.
    if (!a.baseline.empty() && a.baseline != a.write_baseline) inputs.emplace_back(a.baseline);
    return may_write(a, inputs);
}

driver::Request with_outputs(const Arguments& a) {
    driver::Request request = a.request;
    request.inputs = a.inputs;
    for (const driver::Wanted& w : outputs_of(a))
        if (!driver::is_standard_output(w.path)) request.outputs.push_back(w.path);
    return request;
}

bool open(const Arguments& a, driver::Session& s) {
    const driver::Request request = with_outputs(a);
    if (driver::open(request, s)) return may_write(a, s);
    print_diagnostics(s, base::Severity::warning);
    return false;
}

namespace {

using driver::fs::path;

std::string folder_text(const path& folder) { return (folder / "").generic_string(); }

/// Where obrys was called, or, for an input elsewhere, its folder; or the folder above them in which everything that
/// was read lies.
std::string root_of(const driver::Session& s, const path& here) {
    const auto whole = [&](const std::string& name) { return (here / name).lexically_normal(); };
    const path input = whole(s.input);
    path root = input.generic_string().starts_with(folder_text(here)) ? here : input.parent_path();
    for (std::uint32_t i = 0; i < s.sources.size(); ++i) {
        const std::string file = whole(s.sources[i].name).generic_string();
        while (root.has_relative_path() && !file.starts_with(folder_text(root))) root = root.parent_path();
    }
    return folder_text(root);
}

}  // namespace

report::Subject subject_of(const driver::Session& s, const driver::Checked& c) {
    std::error_code error;
    const path here = driver::fs::current_path(error);
    return {s.sources,     c.result, c.setup,          s.stacks, s.program,        s.control,
            OBRYS_VERSION, {},       root_of(s, here), s.input,  folder_text(here)};
}

}  // namespace obrys::cli
