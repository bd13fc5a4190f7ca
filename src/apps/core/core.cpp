/// The doors for JavaScript: functions of C over numbers and texts. What is handed out stays until the next call.

#include <cstddef>
#include <memory>
#include <string>

#include "obrys/check.hpp"

namespace {

namespace api = obrys::api;

struct Workspace {
    api::Workspace files = api::Workspace::in_memory();
    std::string answer;
};

}  // namespace

extern "C" {

Workspace* obrys_new() { return std::make_unique<Workspace>().release(); }
void obrys_delete(Workspace* w) { std::unique_ptr<Workspace>{w}.reset(); }

/// Adds or replaces a file.
void obrys_put(Workspace* w, const char* path, const char* bytes, std::size_t size) {
    w->files.put(path, std::string(bytes, size));
}
int obrys_remove(Workspace* w, const char* path) { return w->files.remove(path) ? 1 : 0; }

/// Checks a program or job: the report of docs/report-json.md; lines of plain text where it cannot be used at all.
const char* obrys_check(Workspace* w, const char* input) {
    const api::Image image = w->files.prepare(input);
    w->answer.clear();
    if (image.usable()) {
        w->answer = api::check(image, {}, {true, false, false}).json;
    } else {
        for (const api::Message& m : image.messages())
            w->answer += m.text + (m.remedy.empty() ? "" : " (" + m.remedy + ")") + "\n";
    }
    return w->answer.c_str();
}
}
