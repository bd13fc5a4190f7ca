#include "obrys/translate.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "driver/translate.hpp"
#include "obrys/shown.hpp"

namespace obrys::api {

Translated translate(const Image& image, const std::string& post_name, double tolerance, const Inputs& inputs) {
    const auto session = session_of(image, inputs);
    Translated out;
    if (const auto post = driver::find_post(post_name, *session)) {
        driver::TranslateOptions options;
        options.name = driver::fs::path(session->program).stem().string();
        compare::Tolerance within;
        within.length = tolerance;
        auto [written, proved] = driver::translate(*session, *post, image.inside().request(), options, within);
        out.proof = static_cast<Proof>(proved.proof);
        if (driver::exit_code_of_translation(*session) == 3) out.proof = Proof::not_compared;
        const auto& said = session->diagnostics.all();
        const bool lost = std::any_of(said.begin(), said.end(),
                                      [](const base::Diagnostic& d) { return d.code == base::codes::not_written; });
        if (out.proof == Proof::same && lost) out.proof = Proof::differs;
        if (proved.run != nullptr && proved.run_complains) out.messages = shown(*proved.run);
        proved.run.reset();  // which shares the text
        out.text = std::move(*written.text);
    }
    std::vector<Message> own = shown(*session);
    out.messages.insert(out.messages.begin(), own.begin(), own.end());
    return out;
}

}  // namespace obrys::api
