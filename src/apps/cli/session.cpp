#include "session.hpp"

#include <cstdio>

#include "driver/wording.hpp"

namespace obrys::cli {

void print_diagnostics(const driver::Session& s, base::Severity from) {
    for (base::Diagnostic d : s.diagnostics.all()) {
        if (d.severity < from) continue;
        d.text = driver::in_words_of(s.control, std::move(d.text));
        d.remedy = driver::in_words_of(s.control, std::move(d.remedy));
        std::fputs(base::render(d, s.sources).c_str(), stderr);
    }
}

bool may_write(const Arguments& a, const driver::Session& s) {
    std::vector<driver::fs::path> inputs = driver::inputs_of(s);
    // A baseline may be brought up to date.
    if (!a.baseline.empty() && a.baseline != a.write_baseline) inputs.emplace_back(a.baseline);
    const auto refused = driver::refusals(outputs_of(a), inputs, a.request.force);
    for (const std::string& why : refused) std::fprintf(stderr, "obrys: %s\n", why.c_str());
    return refused.empty();
}

bool open(const Arguments& a, const driver::Request& request, driver::Session& s) {
    if (driver::open(request, s)) return may_write(a, s);
    print_diagnostics(s, base::Severity::warning);
    return false;
}

/// Where obrys was called, or, for an input elsewhere, its folder.
static std::string root_of(const std::string& input) {
    std::error_code error;
    const std::string here = (driver::fs::current_path(error) / "").generic_string();
    const driver::fs::path path(input);
    if (error || (path.is_absolute() && !path.generic_string().starts_with(here)))
        return (driver::fs::absolute(path, error).parent_path() / "").generic_string();
    return here;
}

report::Subject subject_of(const driver::Session& s, const driver::Checked& c) {
    return {s.sources, c.result, c.setup, s.stacks, s.program, s.control, OBRYS_VERSION, {}, root_of(s.input)};
}

}  // namespace obrys::cli
