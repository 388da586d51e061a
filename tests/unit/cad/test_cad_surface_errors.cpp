// Faces of CAD files that no tool can be made of: which, where, and what to do; damaged files are errors, never the end.
#include "unit/cad/cad_bodies.hpp"
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <random>

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<3> ANY(0, 0);

void refuses(const TopoDS_Shape& shape, const CadSelection& selection, const std::string& message) {
  SCOPED_TRACE(message);
  expect_invalid([&] { from_step(shape, selection); }, message);
}

// The box without its last face.
TopoDS_Shape open_box() {
  TopoDS_Shell shell;
  BRep_Builder().MakeShell(shell);
  TopExp_Explorer face(BRepPrimAPI_MakeBox(2, 3, 4).Shape(), TopAbs_FACE);
  for (int i = 0; i < 5; ++i, face.Next()) BRep_Builder().Add(shell, face.Current());
  return shell;
}

} // namespace

TEST(CadSurfaceErrors, SharpEdges) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 3, 4).Shape();
  refuses(box, named_faces({1, 3}),
          "CadSurface: faces 1 and 3 meet at a sharp edge of 90 degrees at (0, 0, ");
  refuses(box, named_faces({1, 3}),
          "; round it with a fillet in the CAD system: radius 0.4, at most 1.99; or name only one of them");
  EXPECT_NO_THROW(from_step(box, named_faces({1, 2}))) << "opposite faces";
  refuses(BRepPrimAPI_MakeCone(4, 0, 6).Shape(), named_faces({1}),
          "face 1 has a tip without normal at (0, 0, 6)");
  // without names the surface ends there
  const CadSurface ended = from_step(box);
  EXPECT_EQ(ended.ends().size(), 12u * CadSurface::RIM_PLACES);
  const SurfaceFoot<3> off = ended.foot({1, 6, 8}, ANY);
  EXPECT_TRUE(off.on_end);
  EXPECT_NEAR(off.gap, 5, 1e-12);
  EXPECT_NEAR(ended.distance_to_end(ended.foot({1, 1, 9}, ANY).place), 1, 1e-12);
  // a hollow corner: points of the body have a normal everywhere
  CadSelection inside;
  inside.inside = true;
  const CadSurface room = from_step(box, inside);
  EXPECT_FALSE(room.foot({0.1, 0.1, 2}, ANY).on_end);
  EXPECT_NEAR(room.foot({0.1, 0.2, 2}, ANY).gap, 0.1, 1e-14);
  EXPECT_NEAR(room.foot({1, 6, 8}, ANY).gap, -5, 1e-12);
}

TEST(CadSurfaceErrors, FacesWithoutSide) {
  refuses(spline_sheet(3), {}, "face 1 of \"");
  refuses(spline_sheet(3), {}, "\" has no side of its own: it is not in a closed shell. Its normal at (");
  refuses(spline_sheet(3), {}, "): give inside = false for a body there, true for one on the other side");
  const CadSurface above = from_step(spline_sheet(3), with_side(false)),
                   below = from_step(spline_sheet(3), with_side(true));
  EXPECT_NEAR(above.foot({0, 0, 5}, ANY).gap, -below.foot({0, 0, 5}, ANY).gap, 1e-12);
  EXPECT_GT(std::abs(above.foot({0, 0, 5}, ANY).gap), 1);
  EXPECT_FALSE(above.closed());
  refuses(open_box(), {}, "has no side of its own");
  EXPECT_FALSE(from_step(open_box(), with_side(false)).closed());
}

TEST(CadSurfaceErrors, NumbersOfFaces) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 3, 4).Shape();
  refuses(box, named_faces({7}), "has no face 7, its faces are 1 to 6");
  refuses(box, named_faces({0}), "has no face 0");
  refuses(box, named_faces({2, 2}), "face 2 is given twice");
  refuses(BRepPrimAPI_MakeSphere(1).Shape(), named_faces({2}), "has no face 2, its only one is 1");
  refuses(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Shape(), {}, ": no faces in it");
  CadSelection scaled;
  scaled.scale = -1;
  refuses(box, scaled, "CadSurface: scale = -1, expected a finite number > 0");
  expect_invalid([] { read_surface("Point(1) = {0, 0, 0};\n", ".geo"); },
                 "faces are taken from .step, .stp and .brep files; let gmsh write one");
}

TEST(CadSurfaceErrors, ThreeFacesAtAnEdge) {
  const TopoDS_Edge common = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 2));
  TopoDS_Compound fan;
  BRep_Builder().MakeCompound(fan);
  for (const gp_Vec& along : {gp_Vec(1, 0, 0), gp_Vec(0, 1, 0), gp_Vec(-1, -1, 0)})
    BRep_Builder().Add(fan, BRepPrimAPI_MakePrism(common, along).Shape());
  expect_invalid([&] { read_surface(brep_text(fan), ".brep", with_side(false)); },
                 "faces 1, 2 and 3 meet at one edge, at (0, 0, 0); name the faces of one surface");
  EXPECT_NO_THROW(read_surface(brep_text(fan), ".brep", [] {
    CadSelection one = named_faces({2});
    one.side_given = true;
    return one;
  }()));
}

TEST(CadSurfaceErrors, PlaceAndHintMustBeFinite) {
  const CadSurface ball = from_step(BRepPrimAPI_MakeSphere(1).Shape());
  expect_invalid([&] { ball.foot({0, NAN, 0}, ANY); }, "CadSurface::foot: p = ");
  expect_invalid([&] { ball.foot({0, 0, 2}, {NAN, 0}); }, "CadSurface::foot: hint = ");
  EXPECT_NEAR(ball.foot({0, 0, 2}, {-1e9, 1e9}).gap, 1, 1e-14) << "a hint of another surface";
}

// Bytes, numbers and lines that are others, missing ends: an error, or a surface that still answers.
TEST(CadSurfaceErrors, DamagedFiles) {
  const TopoDS_Shape box = rounded_box(8, 6, 4, 1);
  std::mt19937 random(3);
  for (const auto& [whole, extension] :
       {std::make_pair(step_text(box), ".step"), std::make_pair(brep_text(box), ".brep")}) {
    int refused = 0;
    for (int i = 0; i < 60; ++i) {
      std::string text = whole;
      const std::size_t at = 200 + random() % (text.size() - 200);
      const std::size_t digit = text.find_first_of("0123456789", at);
      if (i % 3 == 0) text[at] = static_cast<char>(32 + random() % 90);
      if (i % 3 == 1 && digit != std::string::npos) text.replace(digit, 1, i % 2 ? "1e300" : "-7");
      if (i % 3 == 2) text.resize(at);
      try {
        const CadSurface surface = read_surface(text, extension);
        EXPECT_TRUE(std::isfinite(surface.foot({5, 4, 3}, ANY).gap)) << extension << " " << i;
      } catch (const std::invalid_argument&) {
        ++refused;
      }
    }
    EXPECT_GE(refused, 20) << "those cut short at least, " << extension;
    EXPECT_NEAR(read_surface(whole, extension).foot({0, 0, 9}, ANY).gap, 7, 1e-12)
        << "the whole one after them";
  }
}
