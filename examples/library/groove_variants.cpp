/// How deep may the layers of the grooving subprogram be (R11 of examples/groove)? The program is read once, from
/// memory, and then checked with one value after the other.
///
/// usage: groove_variants FOLDER-OF-THE-GROOVE
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "obrys/check.hpp"
#include "obrys/run.hpp"
#include "obrys/version.hpp"

namespace api = obrys::api;

namespace {

std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

const char* name(api::Verdict v) {
    return v == api::Verdict::clean ? "clean" : v == api::Verdict::findings ? "findings" : "not fully checked";
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) return 2;
    api::Workspace workspace = api::Workspace::in_memory();
    for (const auto& entry : std::filesystem::directory_iterator(words[1]))
        workspace.put(entry.path().filename().string(), content(entry.path()));

    const api::Image image = workspace.prepare("groove.job.toml");
    for (const api::Message& m : image.messages())
        if (m.severity == api::Severity::error)
            std::printf("%s:%u: %s\n", m.where.file.c_str(), m.where.line, m.text.c_str());
    if (!image.usable()) return 2;
    std::printf("obrys %s, %s\n", api::version(), image.control().c_str());

    double feed_length = 0;
    api::run(image, [&](const api::Move& m) {
        if (!m.rapid && m.kind == api::MoveKind::straight)
            feed_length += std::abs(m.to[0] - m.from[0]) + std::abs(m.to[2] - m.from[2]);
    });
    std::printf("feed along X and Z: %.0f mm\n", feed_length);

    for (const double infeed : {1.0, 2.0, 4.0}) {
        api::Inputs inputs;
        inputs.set["R11"] = infeed;
        const api::Checked result = api::check(image, inputs);
        std::printf("R11=%g mm: %s, %llu moves, %zu findings\n", infeed, name(result.verdict),
                    static_cast<unsigned long long>(result.moves), result.findings.size());
    }
}
