/// obrys check.

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#ifndef _WIN32
#include <unistd.h>
#endif

#include "base/codes.hpp"
#include "check/result.hpp"
#include "commands.hpp"
#include "driver/files.hpp"
#include "milled.hpp"
#include "progress.hpp"
#include "report/baseline.hpp"
#include "report/milling_report.hpp"
#include "report/report.hpp"
#include "session.hpp"

namespace obrys::cli {

namespace {

bool standard_output_is_terminal() {
#ifdef _WIN32
    return false;
#else
    return isatty(1) != 0;
#endif
}

std::string document(const Arguments& a, const report::Subject& subject) {
    if (a.format == "json") return report::to_json(subject, a.all);
    if (a.format == "sarif") return report::to_sarif(subject, a.all);
    const bool colours =
        a.colours && a.output.empty() && standard_output_is_terminal() && std::getenv("NO_COLOR") == nullptr;
    return report::to_text(subject, {colours, !a.no_list, a.all, a.quiet});
}

/// Whether a finding is one of those that --fail-on names, and new.
bool counts(const Arguments& a, const check::Result& r) {
    if (!check::finds_new(r)) return false;
    if (a.fail_on.empty() || r.findings_dropped > 0) return true;
    const std::vector<check::Group> groups = check::groups_of(r);
    return std::any_of(groups.begin(), groups.end(), [&](const check::Group& g) {
        const check::Finding& f = r.findings[g.worst];
        return !g.known && std::any_of(a.fail_on.begin(), a.fail_on.end(), [&](const std::string& word) {
            return word == f.code || base::is_this_or_worse(f.severity, word);
        });
    });
}

int exit_code(const Arguments& a, const check::Result& r) {
    const int code = check::exit_code(r.verdict);
    return code == 1 && !counts(a, r) ? 0 : code;
}

/// What one input came to.
struct Outcome {
    int exit = 2;
    bool refused = false;  ///< the outputs may not be written
    std::string document;
    std::vector<std::string> baseline;
};

Outcome unreadable(const Arguments& a, const std::string& input, const driver::Session& s) {
    Outcome o;
    if (a.inputs.size() == 1) return o;  // standard error says it all
    const report::Unreadable r{input, s.diagnostics.all()};
    if (a.format == "json") o.document = report::unreadable_json(r);
    if (a.format == "sarif") o.document = report::unreadable_sarif(r);
    return o;
}

bool write_beside(const Arguments& a, driver::Session& s, const driver::Checked& checked,
                  const report::Subject& subject) {
    bool written = true;
    if (!a.html.empty()) written = deliver(a.html, report::page(subject)) && written;
    if (!a.svg.empty() && !draws_milling(a, checked)) written = deliver(a.svg, report::to_svg(subject)) && written;
    written = write_surface(a, s, checked) && written;
    return write_engagement(a, subject) && written && !s.files->failed();
}

std::string folder_of(const std::string& file) {
    std::error_code error;
    return (driver::fs::absolute(file, error).lexically_normal().parent_path() / "").generic_string();
}

Outcome check_one(const Arguments& a, const std::string& input, const std::optional<report::Baseline>& baseline) {
    driver::Session s;
    driver::Request request = with_outputs(a);
    request.input = input;
    const Outcome refused{2, true, {}, {}};
    if (!driver::open(request, s)) {
        print_diagnostics(s, base::Severity::warning);
        return may_write(a, s) ? unreadable(a, input, s) : refused;
    }
    if (!may_write(a, s)) return refused;
    const bool pictures = !a.html.empty() || !a.svg.empty();
    driver::MillingRequest milling = a.milling;
    milling.surface = wants_surface(a) || pictures;
    milling.keep_moves = a.html.empty() ? 0 : report::milled_moves_on_page;
    driver::Checked checked;
    {
        Progress progress;
        checked = driver::check_program(s, pictures ? report::moves_on_page : 0, milling,
                                        [&](std::uint64_t moves) { progress.show(moves); });
    }
    if (driver::refused(s)) {
        print_diagnostics(s, base::Severity::warning);
        return may_write(a, s) ? unreadable(a, input, s) : refused;
    }
    const report::Subject subject = subject_of(s, checked);
    if (baseline) report::mark_known(subject, *baseline, folder_of(a.baseline), checked.result);
    if (!may_write(a, s)) return refused;  // what was called meanwhile is an input as well
    Outcome o{exit_code(a, checked.result), false, document(a, subject), {}};
    if (!a.write_baseline.empty()) o.baseline = report::baseline_entries(subject, folder_of(a.write_baseline));
    if (!write_beside(a, s, checked, subject)) o.exit = 2;
    return o;
}

/// 2: could not be read; then what was not fully checked; then findings.
int worse(int a, int b) {
    const auto rank = [](int code) { return code == 2 ? 4 : code; };
    return rank(a) > rank(b) ? a : b;
}

/// Reads and writes of one input have a name each; several inputs would write over each other.
bool one_input_only(const Arguments& a) {
    for (const driver::Wanted& w : outputs_of(a)) {
        if (w.option == "--output" || w.option == "--write-baseline") continue;
        std::fprintf(stderr, "obrys: %s is one file, and there are %zu inputs\n  check them one by one\n",
                     w.option.c_str(), a.inputs.size());
        return false;
    }
    return true;
}

bool load_baseline(const Arguments& a, std::optional<report::Baseline>& baseline) {
    if (a.baseline.empty()) return true;
    base::Diagnostics diagnostics;
    const auto text = driver::load_bytes(*driver::disk(), a.baseline, diagnostics);
    for (const base::Diagnostic& d : diagnostics.all()) std::fprintf(stderr, "obrys: --baseline: %s\n", d.text.c_str());
    if (!text) return false;
    baseline = report::read_baseline(*text);
    if (!baseline)
        std::fprintf(
            stderr,
            "obrys: --baseline: %s was not written by --write-baseline of this version\n  write it anew, after "
            "a look at its findings\n",
            a.baseline.c_str());
    return baseline.has_value();
}

std::string joined(const Arguments& a, const std::vector<std::string>& documents) {
    if (documents.size() == 1) return documents.front();
    if (a.format == "sarif") return report::joined_sarif(documents);
    std::string out = a.format == "json" ? "[\n" : "";
    for (std::size_t i = 0; i < documents.size(); ++i)
        out += (i == 0 ? "" : a.format == "json" ? ",\n" : "\n") + documents[i];
    return out + (a.format == "json" ? "]\n" : "");
}

}  // namespace

int check(const Arguments& a) {
    std::optional<report::Baseline> baseline;
    if (!load_baseline(a, baseline) || (a.inputs.size() > 1 && !one_input_only(a))) return 2;
    int exit = 0;
    bool first = true;
    std::vector<std::string> documents, known;
    for (const std::string& input : a.inputs) {
        Outcome o = check_one(a, input, baseline);
        if (o.refused) return 2;
        exit = first ? o.exit : worse(exit, o.exit);
        first = false;
        if (!o.document.empty()) documents.push_back(std::move(o.document));
        std::move(o.baseline.begin(), o.baseline.end(), std::back_inserter(known));
    }
    if (documents.empty()) return exit;
    bool written = deliver(a.output, joined(a, documents));
    if (!a.write_baseline.empty()) written = deliver(a.write_baseline, report::to_baseline(known)) && written;
    return written ? exit : 2;
}

}  // namespace obrys::cli
