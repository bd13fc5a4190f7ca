#include "obrys/check.hpp"

#include "check/group.hpp"
#include "obrys/shown.hpp"
#include "obrys/version.hpp"
#include "report/milling_report.hpp"
#include "report/report.hpp"

namespace obrys::api {

namespace {

Message message_of(const base::Sources& sources, const check::Note& note, Severity severity) {
    return {severity,    std::string(note.code),     note.text,
            note.remedy, shown(sources, note.where), shown(sources, note.stack)};
}

std::vector<Message> messages_of(const base::Sources& sources, const std::vector<check::Note>& notes,
                                 Severity severity) {
    std::vector<Message> all;
    for (const check::Note& note : notes) all.push_back(message_of(sources, note, severity));
    return all;
}

Finding finding_of(const base::Sources& sources, const check::Result& result, const check::Group& group) {
    const check::Finding& f = result.findings[group.worst];
    Finding out;
    out.message = {static_cast<Severity>(f.severity), std::string(f.code),    f.text, f.remedy,
                   shown(sources, f.where),           shown(sources, f.stack)};
    out.times = group.times;
    out.first_move = group.first_move;
    for (const check::Amount& a : f.amounts) out.amounts[std::string(a.key)] = a.value;
    return out;
}

check::Setup setup_of(const Image& image, const driver::Session& run, const Documents& documents) {
    check::Setup setup = image.inside().setup_for(run);
    if (!documents.html) return setup;
    setup.keep_moves = report::moves_on_page;
    if (setup.milling) setup.milling->surface = true, setup.milling->keep_moves = report::milled_moves_on_page;
    return setup;
}

}  // namespace

Checked check(const Image& image, const Inputs& inputs, const Documents& documents) {
    const auto session = session_of(image, inputs);
    const driver::Checked done = driver::check_against(*session, setup_of(image, *session, documents));
    const check::Result& r = done.result;
    Checked out;
    out.verdict = static_cast<Verdict>(r.verdict);
    for (const check::Group& group : check::groups_of(r))
        out.findings.push_back(finding_of(session->sources, r, group));
    out.unchecked = messages_of(session->sources, r.unchecked, Severity::error);
    out.assumptions = messages_of(session->sources, r.assumptions, Severity::note);
    out.moves = r.stats.moves;
    const report::Subject subject{session->sources, r,  done.setup, session->stacks, session->program, session->control,
                                  version(),        {}, {},         session->input};
    if (documents.json) out.json = report::to_json(subject);
    if (documents.text) out.text = report::to_text(subject);
    if (documents.html) out.html = report::page(subject);
    return out;
}

}  // namespace obrys::api
