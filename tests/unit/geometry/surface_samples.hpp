#pragma once
// Surfaces of space for the tests: every kind, both sides, about skew axes.
#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/extruded.hpp"
#include "geometry/plane_surface.hpp"
#include "geometry/revolved.hpp"
#include "geometry/rounded_prism.hpp"
#include "geometry/segment.hpp"
#include "geometry/simple_surfaces.hpp"
#include <random>
#include <string>

namespace burnish::test {

struct NamedSurface {
  std::string name;
  std::shared_ptr<const Surface<3>> surface;
};

/// A die with fillets that begins at a pole: flat, a corner of 0.8, a wall, a concave fillet, a flange.
inline std::shared_ptr<const ArcChain> punch() {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{5, 2.5}, {2.5, 2}, {2, 0}, {0, 0}},
                                    std::vector<double>{0, 0.4, 0.8, 0});
}
inline std::shared_ptr<const ArcChain> cam(bool inside = false) {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{1, 0}, {7, -1}, {8, 3}, {4.2, 2.2}, {2, 5}},
                                    std::vector<double>{0.5, 1.1, 0.6, 0.7, 0.9}, true, inside);
}

/// Of sides 4 and 3, about the origin.
inline std::shared_ptr<const ArcChain> square(double fillet) {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{2, 1.5}, {-2, 1.5}, {-2, -1.5}, {2, -1.5}},
                                    std::vector<double>(4, fillet), true);
}

inline AxisFrame skew_axis() {
  return axis_frame("test", Vector<3>(0.3, -1.1, 0.7), Vector<3>(1, 2, -2), Vector<3>(0, 1, 0.2));
}

/// About the axis of the frame.
inline std::vector<NamedSurface> surfaces(const AxisFrame& a) {
  const auto chip = std::make_shared<Segment>(Vector<2>(-1, 2), Vector<2>(3, 5));
  return {{"plane", std::make_shared<PlaneSurface>(a.point, a.base.col(2), 2.)},
          {"sphere", sphere(2.5, a)},
          {"hollow sphere", sphere(2.5, a, true)},
          {"cylinder", cylinder(1.5, 4, a)},
          {"hollow cylinder", cylinder(1.5, 4, a, true)},
          {"frustum", cone(2.5, 1, 2, a)},
          {"hollow frustum", cone(1, 2.5, 2, a, true)},
          {"nappe", cone(0, 2, 3, a)},
          {"torus", torus(3, 1.2, a)},
          {"hollow torus", torus(3, 1.2, a, true)},
          {"turned punch", std::make_shared<Revolved>(punch(), a)},
          {"turned cam", std::make_shared<Revolved>(cam(), a)},
          {"hollow turned cam", std::make_shared<Revolved>(cam(true), a)},
          {"roller", std::make_shared<Extruded>(std::make_shared<Circle>(2.), a, 5.)},
          {"hollow roller", std::make_shared<Extruded>(std::make_shared<Circle>(2., true), a, 5.)},
          {"plate", std::make_shared<Extruded>(chip, a, 4.)},
          {"swept cam", std::make_shared<Extruded>(cam(), a, 3.)},
          {"endless roller", std::make_shared<Extruded>(std::make_shared<Circle>(2.), a)},
          {"drum", std::make_shared<RoundedPrism>(std::make_shared<Circle>(1.5), a, 4., 0.4)},
          {"hollow drum", std::make_shared<RoundedPrism>(std::make_shared<Circle>(1.5), a, 4., 0.4, true)},
          {"box", std::make_shared<RoundedPrism>(square(0.4), a, 2.5, 0.4)},
          {"prism", std::make_shared<RoundedPrism>(cam(), a, 3., 0.3)},
          {"hollow prism", std::make_shared<RoundedPrism>(square(0.9), a, 2.5, 0.5, true)}};
}

/// The same numbers on every run.
class RandomPoints {
public:
  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(m_engine()) / static_cast<double>(std::mt19937::max());
  }
  Vector<3> point(double reach) {
    return {number(-reach, reach), number(-reach, reach), number(-reach, reach)};
  }

private:
  std::mt19937 m_engine{1};
};

/// Away from rims, apices and the joints of pieces, where the curvature jumps.
inline std::vector<SurfacePlace<3>> smooth_places(const Surface<3>& surface, int n, double margin) {
  std::vector<SurfacePlace<3>> places;
  for (const auto& place : surface.samples(n)) {
    const SurfaceFrame<3> frame = surface.frame(place);
    bool smooth = surface.distance_to_end(place) > margin;
    for (const double angle : {0., 1., 2., 3., 4., 5.}) {
      const Vector<3> beside = place.y + margin * frame.E * Vector<2>(std::cos(angle), std::sin(angle));
      smooth = smooth && surface.piece(surface.foot(beside, place.hint).place) == surface.piece(place);
    }
    if (smooth) places.push_back(place);
  }
  return places;
}

} // namespace burnish::test
