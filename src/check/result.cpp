#include "check/result.hpp"

namespace obrys::check {

std::string_view name(Verdict v) {
    switch (v) {
        case Verdict::clean: return "clean";
        case Verdict::findings: return "findings";
        case Verdict::not_fully_checked: return "not-fully-checked";
    }
    return "not-fully-checked";
}

int exit_code(Verdict v) {
    switch (v) {
        case Verdict::clean: return 0;
        case Verdict::findings: return 1;
        case Verdict::not_fully_checked: return 3;
    }
    return 3;
}

Verdict verdict_of(const Result& r) {
    if (!r.unchecked.empty()) return Verdict::not_fully_checked;
    return r.findings.empty() ? Verdict::clean : Verdict::findings;
}

}  // namespace obrys::check
