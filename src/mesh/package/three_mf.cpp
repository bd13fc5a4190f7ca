#include <zip.h>

#include <array>
#include <charconv>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "base/library/shared_library.hpp"
#include "base/number.hpp"
#include "mesh/package/three_mf.hpp"

namespace obrys::mesh::package {

namespace {

constexpr std::string_view content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";
constexpr std::string_view relations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";

void append_number(std::string& out, std::size_t n) {
    std::array<char, 24> buffer;
    out.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), n).ptr);
}

void append_hex(std::string& out, std::uint8_t value) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    out += digits[value >> 4U];
    out += digits[value & 15U];
}

void append_materials(std::string& out, Palette palette) {
    out += "<basematerials id=\"1\">";
    for (std::size_t i = 0; i < palette.size(); ++i) {
        out += "<base name=\"";
        append_number(out, i);
        out += "\" displaycolor=\"#";
        for (const std::uint8_t c : {palette[i].red, palette[i].green, palette[i].blue}) append_hex(out, c);
        out += "\"/>";
    }
    out += "</basematerials>\n";
}

void append_vertices(std::string& out, const Mesh& m) {
    out += "<vertices>\n";
    for (const geom::Vec3& v : m.vertices) {
        out += "<vertex x=\"";
        base::append_fixed(out, v.x, 6);
        out += "\" y=\"";
        base::append_fixed(out, v.y, 6);
        out += "\" z=\"";
        base::append_fixed(out, v.z, 6);
        out += "\"/>\n";
    }
    out += "</vertices>\n";
}

void append_triangles(std::string& out, const Mesh& m, std::size_t colours) {
    constexpr std::array<std::string_view, 3> names{"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
    out += "<triangles>\n";
    for (std::size_t i = 0; i < m.triangles.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out += names[c];
            append_number(out, m.triangles[i][c]);
        }
        const std::size_t colour = std::min<std::size_t>(m.tag(i), colours == 0 ? 0 : colours - 1);
        if (colour > 0) {
            out += "\" pid=\"1\" p1=\"";
            append_number(out, colour);
        }
        out += "\"/>\n";
    }
    out += "</triangles>\n";
}

std::string model(const Mesh& m, Palette palette) {
    std::string out = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">obrys</metadata>
<resources>
)";
    out.reserve(60 * (m.vertices.size() + m.triangles.size()) + 1000);
    const bool has_body = !m.empty();
    if (has_body && !palette.empty()) append_materials(out, palette);
    if (has_body) {
        out +=
            palette.empty() ? "<object id=\"2\" type=\"model\">" : R"(<object id="2" type="model" pid="1" pindex="0">)";
        out += "<mesh>\n";
        append_vertices(out, m);
        append_triangles(out, m, palette.size());
        out += "</mesh></object>\n";
    }
    out += "</resources>\n<build>";
    if (has_body) out += "<item objectid=\"2\"/>";
    return out + "</build>\n</model>\n";
}

/// libzip's functions, loaded with the first archive.
#define OBRYS_ZIP_FUNCTIONS(X) \
    X(close)                   \
    X(discard)                 \
    X(error_fini)              \
    X(error_init)              \
    X(file_add)                \
    X(file_set_dostime)        \
    X(open_from_source)        \
    X(set_file_compression)    \
    X(source_buffer)           \
    X(source_buffer_create)    \
    X(source_close)            \
    X(source_free)             \
    X(source_keep)             \
    X(source_open)             \
    X(source_read)             \
    X(source_stat)

struct Zip {
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): a name for each of the header's
#define OBRYS_ZIP_FUNCTION(name) decltype(&::zip_##name) name = nullptr;
    OBRYS_ZIP_FUNCTIONS(OBRYS_ZIP_FUNCTION)
#undef OBRYS_ZIP_FUNCTION
};

Zip load_zip() {
    const base::library::SharedLibrary library(OBRYS_ZIP_LIBRARY);
    Zip out;
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): a name for each of the header's
#define OBRYS_ZIP_FUNCTION(name) library.find(out.name, "zip_" #name);
    OBRYS_ZIP_FUNCTIONS(OBRYS_ZIP_FUNCTION)
#undef OBRYS_ZIP_FUNCTION
    return out;
}

const Zip& zip() {
    static const Zip loaded = load_zip();
    return loaded;
}

/// An archive in memory.
class Archive {
public:
    Archive() {
        zip().error_init(&error_);
        bytes_ = zip().source_buffer_create(nullptr, 0, 0, &error_);
        if (bytes_ == nullptr) fail();
        zip().source_keep(bytes_);
        archive_ = zip().open_from_source(bytes_, ZIP_TRUNCATE, &error_);
        if (archive_ == nullptr) fail();
    }
    ~Archive() {
        if (archive_ != nullptr) zip().discard(archive_);
        if (bytes_ != nullptr) zip().source_free(bytes_);
        zip().error_fini(&error_);
    }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    /// `content` must stay until `finish`.
    void add(const char* name, std::string_view content) {
        zip_source_t* source = zip().source_buffer(archive_, content.data(), content.size(), 0);
        if (source == nullptr) fail();
        const zip_int64_t added = zip().file_add(archive_, name, source, ZIP_FL_ENC_UTF_8);
        if (added < 0) {
            zip().source_free(source);
            fail();
        }
        const auto index = static_cast<zip_uint64_t>(added);
        // 1980-01-01, so that the same mesh gives the same bytes; little compression, which costs most of the time.
        zip().file_set_dostime(archive_, index, 0, 33, 0);
        zip().set_file_compression(archive_, index, ZIP_CM_DEFLATE, 3);
    }

    [[nodiscard]] std::string finish() {
        if (zip().close(archive_) != 0) fail();
        archive_ = nullptr;
        zip_stat_t about;
        if (zip().source_open(bytes_) != 0 || zip().source_stat(bytes_, &about) != 0) fail();
        std::string out(static_cast<std::size_t>(about.size), '\0');
        if (zip().source_read(bytes_, out.data(), out.size()) != static_cast<zip_int64_t>(out.size())) fail();
        zip().source_close(bytes_);
        return out;
    }

private:
    [[noreturn]] static void fail() { throw std::runtime_error("3MF: the zip archive could not be made"); }

    zip_error_t error_{};
    zip_source_t* bytes_ = nullptr;
    zip_t* archive_ = nullptr;
};

}  // namespace

std::string write_3mf(const Mesh& m, Palette palette) {
    const std::string body = model(m, palette);
    Archive archive;
    archive.add("[Content_Types].xml", content_types);
    archive.add("_rels/.rels", relations);
    archive.add("3D/3dmodel.model", body);
    return archive.finish();
}

}  // namespace obrys::mesh::package
