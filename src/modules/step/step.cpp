#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "mesh/step_module.hpp"
#include "modules/step/read_shape.hpp"

namespace obrys::modules::step {

namespace {

std::uint64_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum what, TopAbs_ShapeEnum outside = TopAbs_SHAPE) {
    std::uint64_t n = 0;
    for (TopExp_Explorer e(shape, what, outside); e.More(); e.Next()) ++n;
    return n;
}

struct Triangles {
    std::vector<double> vertices;
    std::vector<std::uint32_t> corners;
    std::uint64_t faces_unmeshed = 0;
};

/// A face's triangles look along its surface's normal, which points out of the material unless the face is reversed; a
/// placement that mirrors turns them over as well.
void add_face(const TopoDS_Face& face, Triangles& to) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull() || mesh->NbTriangles() == 0) {
        ++to.faces_unmeshed;
        return;
    }
    const gp_Trsf placement = location.Transformation();
    const bool turn = (face.Orientation() == TopAbs_REVERSED) != placement.IsNegative();
    if (to.vertices.size() / 3 + static_cast<std::size_t>(mesh->NbNodes()) > UINT32_MAX)
        throw Refusal{mesh::obrys_step_memory, "a body makes more than 4 000 000 000 vertices"};
    const auto first = static_cast<std::uint32_t>(to.vertices.size() / 3);
    for (int i = 1; i <= mesh->NbNodes(); ++i) {
        const gp_Pnt p = mesh->Node(i).Transformed(placement);
        to.vertices.insert(to.vertices.end(), {p.X(), p.Y(), p.Z()});
    }
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        mesh->Triangle(i).Get(a, b, c);
        if (turn) std::swap(b, c);
        for (const int corner : {a, b, c}) to.corners.push_back(first + static_cast<std::uint32_t>(corner - 1));
    }
}

/// Delabella's triangulation is 2 to 10 times as fast as Watson's where a face has ten thousand triangles and more, and
/// nearer to the deflection asked for. One thread: the caller may have forked, and a pool's threads are not there then.
IMeshTools_Parameters parameters_of(const mesh::ObrysStepFineness& fineness) {
    IMeshTools_Parameters p;
    p.Deflection = fineness.deflection;
    p.Angle = fineness.angle;
    p.InParallel = false;
    p.MeshAlgo = fineness.other_way != 0 ? IMeshTools_MeshAlgoType_Watson : IMeshTools_MeshAlgoType_Delabella;
    return p;
}

void read(const char* bytes, std::size_t size, const mesh::ObrysStepFineness& fineness, const mesh::ObrysStepSink& sink,
          mesh::ObrysStepResult& result) {
    const ReadShape from = read_shape(bytes, size);
    const TopoDS_Shape& shape = from.shape;
    result.complaints = from.complaints;
    result.loose_faces = count(shape, TopAbs_FACE, TopAbs_SOLID);
    if (count(shape, TopAbs_SOLID) == 0)
        throw Refusal{mesh::obrys_step_no_solid,
                      "the STEP file holds no solid; faces that bound none: " + std::to_string(result.loose_faces)};
    const IMeshTools_Parameters parameters = parameters_of(fineness);
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
        const BRepMesh_IncrementalMesh mesher(solid.Current(), parameters);
        Triangles triangles;
        for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next())
            add_face(TopoDS::Face(face.Current()), triangles);
        result.faces_unmeshed += triangles.faces_unmeshed;
        sink.solid(sink.context, triangles.vertices.data(), triangles.vertices.size() / 3, triangles.corners.data(),
                   triangles.corners.size() / 3);
    }
}

void refuse(mesh::ObrysStepOutcome outcome, const std::string& text, const mesh::ObrysStepSink& sink,
            mesh::ObrysStepResult& result) {
    result.outcome = outcome;
    sink.problem(sink.context, text.data(), text.size());
}

}  // namespace

}  // namespace obrys::modules::step

using namespace obrys;

extern "C" {

__attribute__((visibility("default"))) int obrys_step_abi_version() { return mesh::obrys_step_abi; }

__attribute__((visibility("default"))) void obrys_step_read(const char* bytes, std::size_t size,
                                                            const mesh::ObrysStepFineness* fineness,
                                                            const mesh::ObrysStepSink* sink,
                                                            mesh::ObrysStepResult* result) {
    *result = {};
    try {
        modules::step::read(bytes, size, *fineness, *sink, *result);
    } catch (const modules::step::Refusal& r) {
        result->line = r.line;
        modules::step::refuse(r.outcome, r.text, *sink, *result);
    } catch (const std::bad_alloc&) {
        modules::step::refuse(mesh::obrys_step_memory, "the memory did not suffice for the STEP file", *sink, *result);
    } catch (const Standard_Failure& f) {
        const std::string what = f.GetMessageString() ? f.GetMessageString() : "";
        modules::step::refuse(mesh::obrys_step_failed, modules::step::with("Open CASCADE gave up", what), *sink,
                              *result);
    } catch (const std::exception& e) {
        modules::step::refuse(mesh::obrys_step_failed, modules::step::with("the module gave up", e.what()), *sink,
                              *result);
    } catch (...) {
        modules::step::refuse(mesh::obrys_step_failed, "the module gave up", *sink, *result);
    }
}
}
