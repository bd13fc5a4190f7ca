// Bodies made with Open CASCADE, which shapes.cpp describes: step_samples <shape> <MM|INCH|M> prints the STEP file.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <unistd.h>

namespace obrys::step_test {

namespace {

const double pi = std::acos(-1.0);

TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
}

TopoDS_Shape bore(double x, double y, double z0, double z1, double radius) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z0), gp_Dir(0, 0, 1)), radius, z1 - z0).Shape();
}

/// Rounds the vertical edges at which `wanted(x, y)`.
template <class Wanted>
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, Wanted&& wanted) {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (TopExp_Explorer e(shape, TopAbs_EDGE); e.More(); e.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(e.Current());
        const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
        if (std::hypot(a.X() - b.X(), a.Y() - b.Y()) < 1e-9 && wanted(a.X(), a.Y())) fillet.Add(radius, edge);
    }
    return fillet.Shape();
}

TopoDS_Shape soft() {
    const TopoDS_Shape sharp = box(0, 0, 0, 30, 20, 10);
    BRepFilletAPI_MakeFillet fillet(sharp);
    for (TopExp_Explorer e(sharp, TopAbs_EDGE); e.More(); e.Next()) fillet.Add(3, TopoDS::Edge(e.Current()));
    return fillet.Shape();
}

TopoDS_Shape block() {
    const TopoDS_Shape round =
        rounded(box(0, 0, -20, 60, 40, 0), 5, [](double x, double y) { return x > 59 && y > 39; });
    return BRepAlgoAPI_Cut(round, bore(20, 20, -30, 10, 6)).Shape();
}

/// What examples/plate/PLATE.H leaves.
TopoDS_Shape plate() {
    const TopoDS_Shape island = rounded(box(10, 10, -12, 90, 60, 0), 8, [](double, double) { return true; });
    TopoDS_Shape out = BRepAlgoAPI_Fuse(box(0, 0, -25, 100, 70, -8), island).Shape();
    for (const double x : {25.0, 75.0})
        for (const double y : {25.0, 45.0}) out = BRepAlgoAPI_Cut(out, bore(x, y, -30, 5, 4)).Shape();
    return out;
}

TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes) {
    TopoDS_Compound out;
    BRep_Builder builder;
    builder.MakeCompound(out);
    for (const TopoDS_Shape& s : shapes) builder.Add(out, s);
    return out;
}

TopoDS_Shape turned() {
    const TopoDS_Shape one = box(0, 0, 0, 30, 20, 10);
    gp_Trsf turn, shift;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), pi / 2);
    shift.SetTranslation(gp_Vec(-10, 0, 0));
    return together({one, one.Moved(TopLoc_Location(shift * turn))});
}

TopoDS_Shape made(const std::string& name) {
    if (name == "block") return block();
    if (name == "ball") return BRepPrimAPI_MakeSphere(gp_Pnt(1, 2, 3), 10).Shape();
    if (name == "cone") return BRepPrimAPI_MakeCone(10, 0, 30).Shape();
    if (name == "ring") return BRepPrimAPI_MakeTorus(10, 3).Shape();
    if (name == "hollow")
        return BRepAlgoAPI_Cut(box(-10, -10, -10, 10, 10, 10), BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 8).Shape())
            .Shape();
    if (name == "soft") return soft();
    if (name == "plate") return plate();
    if (name == "apart") return together({box(0, 0, 0, 10, 10, 10), box(20, 0, 0, 30, 10, 10)});
    if (name == "touching") return together({box(0, 0, 0, 10, 10, 10), box(10, 0, 0, 30, 10, 10)});
    if (name == "turned") return turned();
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 50), gp_Dir(0, 0, 1)), 0, 10, 0, 10).Shape();
    if (name == "shell") return face;
    if (name == "mixed") return together({box(0, 0, 0, 10, 10, 10), face});
    throw std::runtime_error("no shape is called " + name);
}

std::filesystem::path scratch_file() {
    return std::filesystem::temp_directory_path() / ("obrys-step-" + std::to_string(getpid()) + ".step");
}

std::string step_text(const std::string& shape, const std::string& unit) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Controller::Init();  // makes the settings that follow known
    Interface_Static::SetCVal("write.step.unit", unit.c_str());
    Interface_Static::SetIVal("write.step.assembly", shape == "turned" ? 1 : 0);
    STEPControl_Writer writer;  // takes the unit as it is now
    if (writer.Transfer(made(shape), STEPControl_AsIs) != IFSelect_RetDone)
        throw std::runtime_error("Open CASCADE does not make STEP of " + shape);
    const std::filesystem::path file = scratch_file();
    if (writer.Write(file.string().c_str()) != IFSelect_RetDone)
        throw std::runtime_error("Open CASCADE does not write " + file.string());
    std::ifstream in(file, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(in)), {});
    in.close();
    std::filesystem::remove(file);
    return text;
}

}  // namespace
}  // namespace obrys::step_test

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        std::cout << obrys::step_test::step_text(argv[1], argv[2]);
        return 0;
    } catch (const std::exception& e) {
        std::cerr << e.what() << '\n';
        return 1;
    }
}
