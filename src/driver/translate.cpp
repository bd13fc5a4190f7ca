#include "driver/translate.hpp"

#include "base/codes.hpp"
#include "driver/control.hpp"
#include "driver/files.hpp"
#include "shop/nearest.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

/// Names that a call may mean, in the order in which they are tried.
std::vector<std::string> candidates(const std::string& name, shop::MachineKind kind) {
    if (kind == shop::MachineKind::lathe) return {name + "-lathe", name};
    return {name};
}

/// A post whose control is none that can be read: what is written by it could not be run.
std::optional<write::Post> checked(std::optional<write::Post> post, std::uint32_t file, Session& s) {
    if (!post || post->control.empty() || find_control(post->control) != nullptr) return post;
    complain(s.diagnostics, codes::job_value, {file, 0, 0}, "there is no control \"" + post->control + '"',
             shop::words_remedy(post->control, controls(), "controls that can be read"));
    return std::nullopt;
}

}  // namespace

std::optional<write::Post> find_post(const std::string& name, Session& s) {
    if (name.ends_with(".toml")) {
        const std::optional<std::uint32_t> file = load(*s.storage, name, s.sources, s.diagnostics);
        return file ? checked(write::read_post(*file, s.sources, s.diagnostics), *file, s) : std::nullopt;
    }
    const std::string& wanted = name == "same" ? s.control : name;
    for (const std::string& candidate : candidates(wanted, s.job.machine.kind))
        if (const write::ShippedPost* post = write::shipped_post(candidate)) {
            const std::uint32_t file = s.sources.add(candidate + ".toml", std::string(post->text));
            return write::read_post(file, s.sources, s.diagnostics);
        }
    complain(s.diagnostics, codes::file_missing, nowhere, "there is no post called '" + name + "'",
             "name one of: " + shop::joined(write::shipped_post_names()) + ", or a file (.toml)");
    return std::nullopt;
}

Translated translate(Session& session, const write::Post& post, const std::string& name, double same_place,
                     const std::function<void(write::Note)>& note) {
    Translated out;
    out.path = compare::Path(same_place);
    write::Output output;
    output.text = [&](std::string_view text) { out.text += text; };
    output.note = note;
    write::Writer writer(post, name, output);
    static_cast<void>(interpret(session, [&](const cl::Record& record) {
        writer.take(record);
        out.path.take(record);
    }));
    writer.finish();
    return out;
}

std::unique_ptr<Proof> prove(const Translated& translated, const write::Post& post, Request request, const Session& of,
                             const compare::Tolerance& tolerance) {
    if (find_control(post.control) == nullptr) return nullptr;
    auto proof = std::make_unique<Proof>();
    request.text = translated.text;
    request.control = post.control;
    request.set.clear();
    if (request.machine.empty() && of.job.machine.more_axes)  // nobody has named it
        request.machine = of.job.machine.kind == shop::MachineKind::lathe ? "lathe-generic" : "mill-generic";
    Session& s = proof->session;
    if (!open(request, s)) return proof;
    compare::Path path(tolerance.length);
    static_cast<void>(interpret(s, [&](const cl::Record& record) { path.take(record); }));
    proof->result = compare::compare(translated.path, path, tolerance);
    return proof;
}

}  // namespace obrys::driver
