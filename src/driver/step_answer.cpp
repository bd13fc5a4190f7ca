#include "driver/step_answer.hpp"

#ifndef _WIN32
#include <dlfcn.h>
#endif

#include <array>
#include <cmath>
#include <cstring>

namespace obrys::driver {

namespace {

/// The answer is a row of parts: what it is, two sizes, and the bytes these stand for, as this machine has them.
enum class Part : std::uint64_t { solid = 1, problem, loading, result };
using Head = std::array<std::uint64_t, 3>;

constexpr double largest_coordinate = 1e9;  ///< mm: 1000 km, as of STL files

std::string_view raw(const void* bytes, std::size_t size) { return {static_cast<const char*>(bytes), size}; }

void begin(const Answer& answer, Part part, std::size_t first, std::size_t second = 0) {
    const Head head{static_cast<std::uint64_t>(part), first, second};
    answer(raw(head.data(), sizeof head));
}

void tell(const Answer& answer, Part part, std::string_view text) {
    begin(answer, part, text.size());
    answer(text);
}

const Answer& answer_of(void* context) { return *static_cast<const Answer*>(context); }

void take_solid(void* context, const double* vertices, std::size_t vertex_count, const std::uint32_t* triangles,
                std::size_t triangle_count) {
    begin(answer_of(context), Part::solid, vertex_count, triangle_count);
    answer_of(context)(raw(vertices, vertex_count * 3 * sizeof *vertices));
    answer_of(context)(raw(triangles, triangle_count * 3 * sizeof *triangles));
}

void take_problem(void* context, const char* text, std::size_t size) {
    tell(answer_of(context), Part::problem, {text, size});
}

/// Takes the answer to pieces; false from where it is cut off.
class Pieces {
public:
    explicit Pieces(std::string_view all) : rest_(all) {}

    [[nodiscard]] bool at_end() const { return rest_.empty(); }

    /// `count` values of a plain type.
    template <class T>
    bool take(T* to, std::uint64_t count) {
        if (count > rest_.size() / sizeof(T)) return false;
        const std::size_t size = static_cast<std::size_t>(count) * sizeof(T);
        if (size > 0) std::memcpy(to, rest_.data(), size);
        rest_.remove_prefix(size);
        return true;
    }
    [[nodiscard]] std::size_t left() const { return rest_.size(); }

private:
    std::string_view rest_;
};

bool read_text(Pieces& pieces, std::uint64_t size, std::string& to) {
    if (size > pieces.left()) return false;
    to.resize(static_cast<std::size_t>(size));
    return pieces.take(to.data(), size);
}

bool read_solid(Pieces& pieces, const Head& head, mesh::Mesh& to) {
    static_assert(sizeof(geom::Vec3) == 3 * sizeof(double) && sizeof(mesh::Triangle) == 3 * sizeof(std::uint32_t));
    if (head[1] > pieces.left() / sizeof(geom::Vec3) || head[2] > pieces.left() / sizeof(mesh::Triangle)) return false;
    to.vertices.resize(static_cast<std::size_t>(head[1]));
    to.triangles.resize(static_cast<std::size_t>(head[2]));
    if (!pieces.take(to.vertices.data(), head[1]) || !pieces.take(to.triangles.data(), head[2])) return false;
    for (const geom::Vec3& v : to.vertices)
        for (const double c : {v.x, v.y, v.z})
            if (!(std::abs(c) <= largest_coordinate)) return false;
    for (const mesh::Triangle& t : to.triangles)
        for (const std::uint32_t corner : t)
            if (corner >= to.vertices.size()) return false;
    return true;
}

}  // namespace

#ifdef _WIN32
void ask_module(const std::string&, std::string_view, const mesh::ObrysStepFineness&, const Answer& answer) {
    tell(answer, Part::loading, "modules are not loaded on this system");
}
#else
void ask_module(const std::string& module, std::string_view bytes, const mesh::ObrysStepFineness& fineness,
                const Answer& answer) {
    void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        const char* why = dlerror();
        return tell(answer, Part::loading, why != nullptr ? why : module.c_str());
    }
    // POSIX says that the pointers of dlsym are those of functions, too.
    const auto abi = reinterpret_cast<mesh::ObrysStepAbi>(dlsym(library, mesh::step_abi_symbol));
    const auto read = reinterpret_cast<mesh::ObrysStepRead>(dlsym(library, mesh::step_read_symbol));
    if (abi == nullptr || read == nullptr || abi() != mesh::obrys_step_abi)
        return tell(answer, Part::loading, module + " belongs to another version of obrys");
    Answer to = answer;
    const mesh::ObrysStepSink sink{&to, take_solid, take_problem};
    mesh::ObrysStepResult result{};
    read(bytes.data(), bytes.size(), &fineness, &sink, &result);
    tell(answer, Part::result, raw(&result, sizeof result));
}
#endif

std::optional<StepAnswer> parse_answer(std::string_view answer) {
    Pieces pieces(answer);
    StepAnswer out;
    bool whole = false;
    while (!pieces.at_end()) {
        Head head{};
        if (!pieces.take(head.data(), head.size())) return std::nullopt;
        bool good = false;
        switch (static_cast<Part>(head[0])) {
            case Part::solid: good = read_solid(pieces, head, out.solids.emplace_back()); break;
            case Part::problem: good = read_text(pieces, head[1], out.problem); break;
            case Part::loading: good = whole = read_text(pieces, head[1], out.loading); break;
            case Part::result: good = whole = head[1] == sizeof out.result && pieces.take(&out.result, 1); break;
        }
        if (!good) return std::nullopt;
    }
    return whole ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace obrys::driver
