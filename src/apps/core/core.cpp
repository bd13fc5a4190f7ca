/// The doors for JavaScript: functions of C over numbers and texts. What is handed out stays until the next call.

#include <cstddef>
#include <exception>
#include <memory>
#include <string>

#include "obrys/check.hpp"

namespace {

namespace api = obrys::api;

struct Workspace {
    api::Workspace files = api::Workspace::in_memory();
    std::string answer;
    int status = 0;  ///< of the last answer
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

/// Checks a program or job: the report of docs/report-json.md; lines of plain text where it cannot be used at all
/// (obrys_status 1) or where memory or time ended the work (2).
const char* obrys_check(Workspace* w, const char* input) {
    w->answer.clear();
    w->status = 0;
    try {
        const api::Image image = w->files.prepare(input);
        if (image.usable()) {
            w->answer = api::check(image, {}, {true, false, false}).json;
        } else {
            w->status = 1;
            for (const api::Message& m : image.messages())
                w->answer += m.text + (m.remedy.empty() ? "" : " (" + m.remedy + ")") + "\n";
        }
    } catch (const std::exception& error) {
        w->status = 2;
        w->answer = error.what();
    }
    return w->answer.c_str();
}
int obrys_status(const Workspace* w) { return w->status; }
}
