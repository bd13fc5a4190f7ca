// Any bytes are taken as a post, and, behind a line `--- stream`, as the stream that is written by it.
#include <cstdlib>
#include <string>

#include "cl/text.hpp"
#include "write/writer.hpp"

using namespace obrys;

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::string mark = "\n--- stream\n";
    const std::size_t at = std::min(text.find(mark), text.size());
    base::Sources sources;
    base::Diagnostics diagnostics;
    const std::optional<write::Post> post =
        write::read_post(sources.add("post.toml", text.substr(0, at)), sources, diagnostics);
    for (const base::Diagnostic& d : diagnostics.all()) static_cast<void>(base::render(d, sources));
    require(post || diagnostics.has_errors());
    if (!post || at + mark.size() > text.size()) return 0;
    const std::uint32_t stream = sources.add("stream", text.substr(at + mark.size()));
    write::Output output;
    output.text = [&](std::string_view line) { require(line.ends_with(post->line_end)); };
    output.note = [](const write::Note& n) { require(!n.what.empty()); };
    write::Writer writer(*post, "P", output);
    cl::read_text(
        sources, stream, [&](const cl::Record& record) { writer.take(record); }, diagnostics);
    writer.finish();
    return 0;
}
