#pragma once
// CAD bodies for the tests, made by OpenCASCADE and read back from files.
#include "base/temporary.hpp"
#include "cad/occ/cad_surface.hpp"
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <STEPControl_Writer.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <iostream>
#include <sstream>

namespace burnish::test {

/// The text of a STEP file; empty if it could not be written.
inline std::string step_text(const TopoDS_Shape& shape) {
  const TemporaryFile file("", ".step");
  std::ostringstream printed;
  std::streambuf* const cout = std::cout.rdbuf(printed.rdbuf());
  STEPControl_Writer writer;
  const bool written = writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
                       writer.Write(file.path().c_str()) == IFSelect_RetDone;
  std::cout.rdbuf(cout);
  return written ? file_content(file.path()) : "";
}
inline std::string brep_text(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return text.str();
}

inline CadSurface read_surface(const std::string& text, const std::string& extension,
                               CadSelection selection = {}) {
  const TemporaryFile file(text, extension);
  selection.file = file.path();
  return CadSurface(selection);
}
inline CadSurface from_step(const TopoDS_Shape& shape, const CadSelection& selection = {}) {
  return read_surface(step_text(shape), ".step", selection);
}
inline CadSelection named_faces(const std::vector<int>& faces) {
  CadSelection selection;
  selection.faces = faces;
  return selection;
}
inline CadSelection with_side(bool inside) {
  CadSelection selection;
  selection.inside = inside;
  selection.side_given = true;
  return selection;
}

inline TopoDS_Shape rounded_box(double a, double b, double c, double fillet) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-a / 2, -b / 2, -c / 2), a, b, c).Shape();
  BRepFilletAPI_MakeFillet rounded(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next())
    rounded.Add(fillet, TopoDS::Edge(edge.Current()));
  return rounded.Shape();
}
/// One edge in each direction with a fillet that grows along it.
inline TopoDS_Shape variable_box() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-4, -3, -2), 8, 6, 4).Shape();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  BRepFilletAPI_MakeFillet rounded(box);
  for (int i = 1; i <= edges.Extent(); ++i) rounded.Add(0.5, 0.5 + 0.05 * (i % 3), TopoDS::Edge(edges(i)));
  return rounded.Shape();
}
/// Sharp edges: convex at the ends.
inline TopoDS_Shape drilled_cylinder() {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(5, 8).Shape(),
                     hole = BRepPrimAPI_MakeCylinder(2, 8).Shape();
  return BRepAlgoAPI_Cut(rod, hole).Shape();
}

/// Evenly spaced knots.
inline Handle(Geom_BSplineCurve) spline_curve(const std::vector<gp_Pnt>& poles, int degree) {
  const int n = static_cast<int>(poles.size()), spans = n - degree;
  TColgp_Array1OfPnt places(1, n);
  for (int i = 1; i <= n; ++i) places(i) = poles[static_cast<std::size_t>(i - 1)];
  TColStd_Array1OfReal knots(1, spans + 1);
  TColStd_Array1OfInteger times(1, spans + 1);
  for (int i = 1; i <= spans + 1; ++i) {
    knots(i) = i - 1;
    times(i) = i == 1 || i == spans + 1 ? degree + 1 : 1;
  }
  return new Geom_BSplineCurve(places, knots, times, degree);
}
/// 8 x 5 poles, bumpy; along v of degree 4.
inline TopoDS_Shape spline_sheet(int degree) {
  const int spans = 8 - degree;
  TColgp_Array2OfPnt poles(1, 8, 1, 5);
  for (int i = 1; i <= 8; ++i)
    for (int j = 1; j <= 5; ++j)
      poles(i, j) = gp_Pnt(1.5 * i - 6.75, 2. * j - 6, 1.5 * std::sin(1.1 * i) * std::cos(0.9 * j) + 0.1 * i);
  TColStd_Array1OfReal u(1, spans + 1), v(1, 2);
  TColStd_Array1OfInteger of_u(1, spans + 1), of_v(1, 2);
  for (int i = 1; i <= spans + 1; ++i) {
    u(i) = i - 1;
    of_u(i) = i == 1 || i == spans + 1 ? degree + 1 : 1;
  }
  v(1) = 0, v(2) = 1;
  of_v(1) = of_v(2) = 5;
  const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(poles, u, v, of_u, of_v, degree, 4);
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Shape();
}
inline TopoDS_Shape turned_spline(int degree, double angle = 2 * M_PI) {
  const auto curve =
      spline_curve({{0, 0, 4}, {2, 0, 4}, {3.5, 0, 2.5}, {2.2, 0, 1}, {3, 0, -1}, {4.5, 0, -2}}, degree);
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(curve).Shape(), gp_Ax1({0, 0, 0}, {0, 0, 1}), angle)
      .Shape();
}
inline TopoDS_Shape swept_spline(int degree) {
  const auto curve =
      spline_curve({{-5, 0, 0}, {-3, 2, 0}, {-1, -1.5, 0}, {1, 2.5, 0}, {3, 0, 0}, {5, 1, 0}}, degree);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeEdge(curve).Shape(), gp_Vec(0, 0, 6)).Shape();
}

} // namespace burnish::test
