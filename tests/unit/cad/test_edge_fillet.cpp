// Sharp edges between named faces of CAD bodies: the refusal tells the fillet that fits. Known: the widths of the faces.
#include "cad/occ/corner_fillet.hpp"
#include "cad/occ/edge_fillet.hpp"
#include "unit/cad/cad_bodies.hpp"
#include "unit/cad/cad_samples.hpp"
#include "unit/finite_difference.hpp"
#include <BRepAlgoAPI_Fuse.hxx>
#include <numeric>

using namespace burnish;
using namespace burnish::test;

namespace {

TopoDS_Edge edge_between(const TopoDS_Face& a, const TopoDS_Face& b) {
  TopTools_IndexedMapOfShape of_a, of_b;
  TopExp::MapShapes(a, TopAbs_EDGE, of_a);
  TopExp::MapShapes(b, TopAbs_EDGE, of_b);
  for (int i = 1; i <= of_a.Extent(); ++i)
    if (of_b.Contains(of_a(i))) return TopoDS::Edge(of_a(i));
  return {};
}

FilletRadii radii(const TopoDS_Shape& body, int a, int b) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(body, TopAbs_FACE, faces);
  const TopoDS_Face first = TopoDS::Face(faces(a)), second = TopoDS::Face(faces(b));
  return radii_that_fit(body, {edge_between(first, second)}, {first, second}, 100);
}

TopoDS_Shape boss_on_a_plate() {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -4), 20, 20, 4).Shape();
  return BRepAlgoAPI_Fuse(plate, BRepPrimAPI_MakeCylinder(3, 6).Shape()).Shape();
}

double corner(const std::string& points, const std::string& curves) {
  const TemporaryFile file(points + curves + "\n", ".geo");
  CadSelection selection;
  selection.file = file.path();
  const auto pieces = read_curves(selection);
  return radii_that_fit(pieces[0], pieces.back()).most;
}

} // namespace

TEST(EdgeFillet, TheLargestLeavesBothFaces) {
  // a face of the width 2 is used up by the radius 2
  EXPECT_DOUBLE_EQ(radii(BRepPrimAPI_MakeBox(2, 3, 4).Shape(), 1, 3).most, 1.99);
  EXPECT_DOUBLE_EQ(radii(BRepPrimAPI_MakeBox(2, 3, 4).Shape(), 1, 3).proposed, 0.4);
  EXPECT_DOUBLE_EQ(radii(BRepPrimAPI_MakeBox(2000, 3000, 4000).Shape(), 1, 3).most, 100)
      << "no more than the size";
  // the cap of a rod: its radius, then it is a dome
  EXPECT_DOUBLE_EQ(radii(BRepPrimAPI_MakeCylinder(5, 8).Shape(), 1, 2).most, 4.99);
  EXPECT_DOUBLE_EQ(radii(BRepPrimAPI_MakeCylinder(5, 8).Shape(), 1, 2).proposed, 1);
  // the foot of a cone: the radius of its base times the tangent of half its angle
  const double foot = 4 * std::tan(std::atan2(6, 2) / 2);
  EXPECT_NEAR(radii(BRepPrimAPI_MakeCone(4, 2, 6).Shape(), 1, 3).most, foot, 0.01);
  // an edge of another body: none
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(5, 8).Shape(), box = BRepPrimAPI_MakeBox(2, 3, 4).Shape();
  const FilletRadii none =
      radii_that_fit(box, {TopoDS::Edge(TopExp_Explorer(rod, TopAbs_EDGE).Current())}, {}, 9);
  EXPECT_TRUE(none.known);
  EXPECT_EQ(none.most, 0);
  // an end of a tube of the thickness 3
  EXPECT_DOUBLE_EQ(radii(drilled_cylinder(), 1, 2).most, 2.99);
}

TEST(EdgeFillet, IsToldWithThePlace) {
  const auto refused = [](const TopoDS_Shape& shape, const std::vector<int>& faces, const std::string& text,
                          double scale = 1) {
    CadSelection selection = named_faces(faces);
    selection.scale = scale;
    SCOPED_TRACE(text);
    expect_invalid([&] { from_step(shape, selection); }, text);
  };
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 3, 4).Shape();
  refused(box, {1, 3}, "; round it with a fillet in the CAD system: radius 0.4, at most 1.99; or name only");
  refused(box, {1, 3}, ": radius 0.0004, at most 0.00199; or name only one of them", 1e-3);
  // three edges that meet in a corner, of faces of the widths 2, 3, 4
  refused(box, {1, 3, 5}, "CAD system: radius 0.4, at most 1.99 at all 3 edges of named faces; or name");
  refused(box, {1, 2, 3, 4, 5, 6}, ": radius 0.2, at most 0.999 at all 12 edges of named faces; or name");
  // towards the body: the height of the boss
  refused(boss_on_a_plate(), {3, 7},
          ", 0); round it with a fillet in the CAD system: radius 1, at most 5.99; or");
}

// What is told for all edges of a box is a tool.
TEST(EdgeFillet, RoundedBodiesAreTools) {
  std::vector<int> all(26);
  std::iota(all.begin(), all.end(), 1);
  EXPECT_TRUE(from_step(rounded_box(2, 3, 4, 0.999), named_faces(all)).closed());
}

// Of the plane, told to three digits. Known: closed forms.
TEST(EdgeFillet, CornersOfThePlane) {
  const std::string points = "Point(1) = {-5, 0, 0}; Point(2) = {0, 0, 0}; Point(3) = {-1, Sqrt(3), 0};"
                             "Point(4) = {-3, 0, 0}; Point(5) = {-3, 3, 0}; Point(6) = {-3, -3, 0};"
                             "Point(7) = {3, 0, 0}; Point(8) = {3, 3, 0};";
  // a turn of 120 degrees, sides of 5 and 2: the tangents of the fillet are as long as the shorter one
  const double sides = corner(points, "Line(1) = {1, 2}; Line(2) = {2, 3};");
  EXPECT_LE(sides, 2 / std::sqrt(3.) + 1e-9);
  EXPECT_GE(sides, 2 / std::sqrt(3.) - 0.0101);
  // into a quarter of a circle of the radius 3 that comes back over the line: until it touches its end, as drawn or mirrored
  for (const char* end : {"5", "6"}) {
    const double within = corner(points, std::string("Line(1) = {1, 2}; Circle(2) = {2, 4, ") + end + "};");
    EXPECT_LE(within, 1.5 + 1e-9);
    EXPECT_GE(within, 1.4899);
  }
  // from outside, a circle that bends away: tangent where (3 - x)^2 + r^2 = (3 + r)^2, the line ends at x = -5
  const double outside = corner(points, "Line(1) = {1, 2}; Circle(2) = {2, 7, 8};");
  EXPECT_LE(outside, 55 / 6. + 1e-9);
  EXPECT_GE(outside, 55 / 6. - 0.0101);
  // a spline along the same line
  EXPECT_NEAR(corner(points, "Bezier(1) = {1, 4, 2}; Line(2) = {2, 3};"), sides, 1e-12);
}
