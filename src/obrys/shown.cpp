#include "obrys/shown.hpp"

#include <stdexcept>

#include "base/text.hpp"
#include "driver/wording.hpp"

namespace obrys::api {

Place shown(const base::Sources& sources, const base::Span& where) {
    if (where.file >= sources.size()) return {};
    const base::Position p = sources.position(where);
    return {base::as_utf8(sources[where.file].name), p.line, p.column};
}

std::vector<Place> shown(const base::Sources& sources, const std::vector<base::Span>& sites) {
    std::vector<Place> places;
    places.reserve(sites.size());
    for (const base::Span& site : sites) places.push_back(shown(sources, site));
    return places;
}

std::vector<Message> shown(const driver::Session& session) {
    const bool offset_numbers = session.main != nullptr && session.main->traits->edge_is_offset_number;
    std::vector<Message> messages;
    for (base::Diagnostic d : session.diagnostics.all()) {
        driver::reword(d.text, d.remedy, session.control, offset_numbers);
        messages.push_back({static_cast<Severity>(d.severity), std::string(d.code), std::move(d.text),
                            std::move(d.remedy), shown(session.sources, d.where), shown(session.sources, d.stack)});
    }
    return messages;
}

driver::Inputs inside(const Inputs& inputs) {
    driver::Inputs out;
    for (const auto& [name, value] : inputs.set) out.set.push_back({base::to_upper(name), value, driver::nowhere});
    out.skip = inputs.skip;
    return out;
}

std::unique_ptr<driver::Session> session_of(const Image& image, const Inputs& inputs) {
    if (!image.usable()) throw std::invalid_argument("the image is not usable: its messages say why");
    return image.inside().run(inside(inputs));
}

}  // namespace obrys::api
