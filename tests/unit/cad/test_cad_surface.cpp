// Faces of CAD files as tools: closest points, sides, frames, joints, pieces, triangles, for every kind of surface.
#include "geometry/arc_chain.hpp"
#include "geometry/rounded_prism.hpp"
#include "geometry/simple_surfaces.hpp"
#include "unit/cad/cad_bodies.hpp"
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <ctime>

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<3> ANY(0, 0);

struct Body {
  std::string name;
  TopoDS_Shape shape;
  bool solid = true;
  double apart = 1e-9; ///< of faces at an edge
};

/// @param degree of splines; of degree 3 their curvature has kinks
std::vector<Body> bodies(int degree = 5) {
  return {{"ball", BRepPrimAPI_MakeSphere(5).Shape()},
          {"cylinder", BRepPrimAPI_MakeCylinder(3, 8).Shape()},
          {"cone", BRepPrimAPI_MakeCone(4, 1, 6).Shape()},
          {"tip", BRepPrimAPI_MakeCone(4, 0, 6).Shape()},
          {"ring", BRepPrimAPI_MakeTorus(6, 2).Shape()},
          {"rounded box", rounded_box(8, 6, 4, 1)},
          {"variable fillets", variable_box(), true, 5e-6},
          {"drilled cylinder", drilled_cylinder()},
          {"spline", spline_sheet(degree), false},
          {"turned", turned_spline(degree), false},
          {"part of a turn", turned_spline(degree, 2), false},
          {"swept", swept_spline(degree), false}};
}

CadSurface surface_of(const Body& body) {
  return from_step(body.shape, body.solid ? CadSelection() : with_side(false));
}

// Of faces only: within a solid the distance would be 0.
TopoDS_Compound faces_of_shape(const TopoDS_Shape& shape) {
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    BRep_Builder().Add(all, face.Current());
  return all;
}

double reference_distance(const TopoDS_Shape& faces, const Vector<3>& p) {
  return BRepExtrema_DistShapeShape(BRepBuilderAPI_MakeVertex(to_occ(p)).Shape(), faces).Value();
}

} // namespace

// OpenCASCADE's own search misses the nearest of several feet on a spline now and then; ours must lie on the faces then.
TEST(CadSurface, TheFootIsTheClosestPoint) {
  constexpr int points = 1000;
  for (const Body& body : bodies(3)) {
    SCOPED_TRACE(body.name);
    const CadSurface surface = surface_of(body);
    const TopoDS_Compound faces = faces_of_shape(body.shape);
    RandomPoints random;
    int nearer = 0;
    Param<3> hint = ANY;
    for (int i = 0; i < points; ++i) {
      const Vector<3> p = random.point(9);
      const SurfaceFoot<3> foot = surface.foot(p, hint);
      const double distance = (p - foot.place.y).norm(), expected = reference_distance(faces, p);
      ASSERT_NEAR(std::abs(foot.gap), distance, 1e-9) << i;
      ASSERT_LE(distance - expected, body.apart) << i << " at " << p.transpose();
      if (distance < expected - body.apart) {
        ++nearer;
        ASSERT_LE(reference_distance(faces, foot.place.y), body.apart) << "a place of the faces, " << i;
      }
      if (!foot.on_end)
        expect_close(Vector<3>(foot.place.y + foot.gap * surface.frame(foot.place).n), p, 1, 1e-9, "normal");
      hint = foot.place.hint;
    }
    EXPECT_LE(nearer, points / 50);
    std::cout << "  " << body.name << ": OpenCASCADE missed " << nearer << " of " << points << "\n";
  }
}

// The hint makes a search quick, and nothing else. Speed is told, not judged.
TEST(CadSurface, TheHintDoesNotMatter) {
  for (const Body& body : bodies()) {
    const CadSurface surface = surface_of(body);
    std::vector<SurfacePlace<3>> places = surface.samples(1000);
    std::vector<Vector<3>> points;
    RandomPoints random;
    for (const auto& place : places) points.push_back(place.y + random.point(0.1));
    std::vector<double> gap[2];
    double us[2];
    for (const bool warm : {false, true}) {
      const std::clock_t start = std::clock();
      for (std::size_t i = 0; i < points.size(); ++i)
        gap[warm].push_back(surface.foot(points[i], warm ? places[i].hint : ANY).gap);
      us[warm] = 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC /
                 static_cast<double>(points.size());
    }
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(gap[true][i], gap[false][i], body.apart) << i;
    std::cout << "  " << body.name << ": " << us[1] << " us near a known place, " << us[0]
              << " from anywhere\n";
  }
}

TEST(CadSurface, TheSideOfSolids) {
  for (const Body& body : bodies()) {
    if (!body.solid) continue;
    SCOPED_TRACE(body.name);
    CadSelection selection;
    const CadSurface outside = from_step(body.shape, selection);
    selection.inside = true;
    const CadSurface inside = from_step(body.shape, selection);
    EXPECT_TRUE(outside.closed());
    BRepClass3d_SolidClassifier classifier(body.shape);
    RandomPoints random;
    for (int i = 0; i < 300; ++i) {
      const Vector<3> p = random.point(7);
      const SurfaceFoot<3> foot = outside.foot(p, ANY);
      if (std::abs(foot.gap) < 1e-6) continue;
      classifier.Perform(to_occ(p), 1e-9);
      ASSERT_EQ(foot.gap > 0, classifier.State() == TopAbs_OUT) << p.transpose();
      if (!foot.on_end) {
        ASSERT_NEAR(inside.foot(p, ANY).gap, -foot.gap, 1e-12);
      }
    }
  }
}

TEST(CadSurface, MirroredAndInvertedSolids) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2({0, 0, 0}, {1, 2, 3}));
  const TopoDS_Shape mirrored = BRepBuilderAPI_Transform(rounded_box(8, 6, 4, 1), mirror, true).Shape();
  EXPECT_NEAR(from_step(mirrored).foot({0, 0, 0}, ANY).gap, -2, 1e-12);
  const TopoDS_Shape inverted = rounded_box(8, 6, 4, 1).Reversed();
  EXPECT_NEAR(read_surface(brep_text(inverted), ".brep").foot({0, 0, 9}, ANY).gap, 7, 1e-12);
}

// dy = E d(eta), dn = E B d(eta) (METHOD.md (2.4)), and foot and place belong together.
TEST(CadSurface, FrameAgainstDifferences) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    const CadSurface surface = surface_of(body);
    const auto places = smooth_places(surface, 60, 0.05);
    EXPECT_GE(places.size(), 20u);
    for (const auto& place : places) {
      const SurfaceFrame<3> frame = surface.frame(place);
      Tensor<3> axes;
      axes << frame.E, frame.n;
      expect_close(Tensor<3>(axes.transpose() * axes), Tensor<3>::Identity(), 1, 1e-14, "orthonormal");
      EXPECT_NEAR(axes.determinant(), 1, 1e-14);
      EXPECT_NEAR(surface.foot(place.y + 0.01 * frame.n, place.hint).gap, 0.01, 1e-12);
      for (int k = 0; k < 2; ++k) {
        const auto moved = [&](double t) { return surface.moved(place, t * Vector<2>::Unit(k)); };
        const auto y = [&](double t) -> Vector<3> { return moved(t).y; };
        const auto n = [&](double t) -> Vector<3> { return surface.frame(moved(t)).n; };
        expect_close(finite_difference(y, 0, 5e-4), Vector<3>(frame.E.col(k)), 1, 1e-7, "tangent");
        expect_close(finite_difference(n, 0, 5e-4), Vector<3>(frame.E * frame.B.col(k)), 1, 1e-7,
                     "curvature");
      }
    }
  }
}

// The same shapes by closed forms.
TEST(CadSurface, AsTheCoresOwnShapes) {
  const std::vector<Vector<2>> corners{{4, 3}, {-4, 3}, {-4, -3}, {4, -3}};
  const RoundedPrism box(std::make_shared<ArcChain>(corners, std::vector<double>(4, 1), true), AxisFrame(), 4,
                         1);
  const auto ball = sphere(5), ring = torus(6, 2);
  const std::vector<std::pair<const Surface<3>*, TopoDS_Shape>> pairs{
      {&box, rounded_box(8, 6, 4, 1)},
      {ball.get(), BRepPrimAPI_MakeSphere(5).Shape()},
      {ring.get(), BRepPrimAPI_MakeTorus(6, 2).Shape()}};
  RandomPoints random;
  for (const auto& [own, shape] : pairs) {
    const CadSurface read = from_step(shape);
    EXPECT_NEAR(read.tightest_radius(), own->tightest_radius(), 1e-12);
    for (const auto& place : own->samples(500)) {
      const Vector<3> p = place.y + random.point(0.2);
      const auto a = own->foot(p, ANY), b = read.foot(p, ANY);
      const auto in_space = [](const SurfaceFrame<3>& f) -> Tensor<3> { return f.E * f.B * f.E.transpose(); };
      EXPECT_NEAR(a.gap, b.gap, 1e-12);
      expect_close(b.place.y, a.place.y, 1, 1e-11, "foot");
      expect_close(read.frame(b.place).n, own->frame(a.place).n, 1, 1e-11, "normal");
      if (own == ball.get())
        expect_close(in_space(read.frame(b.place)), in_space(own->frame(a.place)), 1, 1e-11, "curvature");
    }
  }
}

// Splines that are no kind of their own: the shape of a rational spline is a ball's.
TEST(CadSurface, RationalSplines) {
  for (const TopoDS_Shape& shape :
       {BRepBuilderAPI_NurbsConvert(rounded_box(8, 6, 4, 1)).Shape(), rounded_box(8, 6, 4, 1)}) {
    const CadSurface surface = from_step(shape);
    EXPECT_NEAR(surface.foot({0, 0, 3}, ANY).gap, 1, 1e-12);
    EXPECT_NEAR(surface.foot({3 + 2, 2 + 2, 1 + 2}, ANY).gap, std::sqrt(12.) - 1, 1e-12) << "over a corner";
    EXPECT_NEAR(surface.foot({3 + 2, 0, 1 + 2}, ANY).gap, std::sqrt(8.) - 1, 1e-12) << "over an edge";
    EXPECT_NEAR(surface.tightest_radius(), 1, 1e-9);
    EXPECT_TRUE(surface.ends().empty());
  }
}

// Faces that have an edge each where they meet.
TEST(CadSurface, SeparateFacesAreSewn) {
  TopoDS_Compound loose;
  BRep_Builder().MakeCompound(loose);
  for (TopExp_Explorer face(rounded_box(8, 6, 4, 1), TopAbs_FACE); face.More(); face.Next())
    BRep_Builder().Add(loose, BRepBuilderAPI_Copy(face.Current()).Shape());
  const CadSurface surface = read_surface(brep_text(loose), ".brep");
  EXPECT_TRUE(surface.closed());
  EXPECT_TRUE(surface.ends().empty());
  EXPECT_EQ(surface.tags().size(), 26u);
  EXPECT_NEAR(surface.foot({0, 0, 3}, ANY).gap, 1, 1e-12);
  EXPECT_NEAR(surface.foot({5, 4, 3}, ANY).gap, std::sqrt(12.) - 1, 1e-9);
  const CadSurface half = read_surface(brep_text(loose), ".brep", named_faces({surface.tags()[0]}));
  EXPECT_EQ(half.ends().size(), 4u * CadSurface::RIM_PLACES);
}

TEST(CadSurface, PiecesAndEnds) {
  const CadSurface box = from_step(rounded_box(8, 6, 4, 1));
  EXPECT_EQ(box.tags().size(), 26u);
  EXPECT_TRUE(std::isinf(box.distance_to_end(box.foot({0, 0, 5}, ANY).place)));
  const auto top = box.foot({0, 0, 5}, ANY).place, beside = box.foot({1, 1, 5}, ANY).place,
             edge = box.foot({5, 0, 4}, ANY).place;
  EXPECT_EQ(box.piece(top), box.piece(beside));
  EXPECT_NE(box.piece(top), box.piece(edge));
  const double passage = box.passage(top, edge);
  EXPECT_NEAR(box.between(top, edge, passage).y[0], 3, 1e-6) << "where the flat top ends";
  // a ball in two halves is one piece
  const TopoDS_Shape half = BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, {0, 0, 1}), 5, 0, M_PI_2).Shape();
  const CadSurface dome = from_step(half);
  EXPECT_GT(dome.ends().size(), 0u) << "its edge is sharp";
  EXPECT_TRUE(dome.closed());
  EXPECT_NEAR(dome.distance_to_end(dome.foot({0, 0, 9}, ANY).place), 5 * std::sqrt(2.), 1e-9);
  const SurfaceFoot<3> rim = dome.foot({7, 0, -2}, ANY);
  EXPECT_TRUE(rim.on_end);
  EXPECT_NEAR(rim.gap, std::sqrt(8.), 1e-12);
}

TEST(CadSurface, UnitsOfLength) {
  CadSelection meters;
  meters.scale = 1e-3;
  const CadSurface ball = from_step(BRepPrimAPI_MakeSphere(5).Shape(), meters);
  EXPECT_NEAR(ball.foot({0, 0, 7e-3}, ANY).gap, 2e-3, 1e-15);
  EXPECT_NEAR(ball.tightest_radius(), 5e-3, 1e-15);
  EXPECT_NEAR(ball.length_scale(), 5e-3, 1e-9);
  EXPECT_NEAR(ball.frame(ball.foot({1, 2, 7e-3}, ANY).place).B(0, 0), 200, 1e-9);
}

TEST(CadSurface, SamplesOutlineAndTriangles) {
  const Eigen::AlignedBox3d window(Vector<3>(-5, -5, -5), Vector<3>(5, 5, 5));
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    const CadSurface surface = surface_of(body);
    ASSERT_EQ(surface.samples(300).size(), 300u);
    for (const auto& place : surface.samples(300)) ASSERT_NEAR(surface.foot(place.y, ANY).gap, 0, 1e-9);
    EXPECT_GE(surface.outline(50).size(), 50u);
    for (const auto& place : surface.outline(50)) ASSERT_NEAR(surface.foot(place.y, ANY).gap, 0, 1e-6);
    const SurfaceMesh mesh = surface.mesh(window);
    ASSERT_GE(mesh.triangles.size(), 2u);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 5) {
      const auto at = [&](int k) {
        return mesh.points[static_cast<std::size_t>(mesh.triangles[i][static_cast<std::size_t>(k)])];
      };
      const auto foot = surface.foot((at(0) + at(1) + at(2)) / 3, ANY);
      ASSERT_LE(std::abs(foot.gap), 1.5 * MESH_SAGITTA * 10);
      const Vector<3> area = (at(1) - at(0)).cross(at(2) - at(0));
      if (area.norm() > 1e-6) {
        ASSERT_GT(area.dot(surface.frame(foot.place).n), 0) << "towards the body";
      }
    }
  }
}
