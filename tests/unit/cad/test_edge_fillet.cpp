// Sharp edges between named faces of CAD bodies: the refusal tells the fillet that fits. Known: the widths of the faces.
#include "cad/occ/edge_fillet.hpp"
#include "unit/cad/cad_bodies.hpp"
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
