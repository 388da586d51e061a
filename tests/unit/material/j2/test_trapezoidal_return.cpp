// The trapezoidal return by itself: end on the surface, exactness, order. Its tangent: test_point_tangent.cpp.
#include "material/formula_hardening.hpp"
#include "material/j2/trapezoidal_return.hpp"
#include "unit/material/j2/point_walk.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Of METHOD.md (1.34) with a law that bends.
J2Parameters bending_material() {
  J2Parameters material = example_material();
  material.hardening = formula_hardening("193e6*(1 + ep/0.002)^0.2", false, "test");
  return material;
}

/// s and ep after the deviator of the strain has gone an arc of 1.2 rad in n straight parts, from the surface.
std::array<double, 3> arc(const J2Parameters& material, int n) {
  const Stress<2> first = {1, -1, 0, 0}, second = {0, 0, 0, 1};
  const double radius = 4 * material.yield_stress(0).value;
  const auto place = [&](double angle) -> Stress<2> {
    return radius * (std::sin(angle) * first + (1 - std::cos(angle)) * second);
  };
  Stress<2> s = on_surface(material, first, 0);
  double ep = 0;
  for (int k = 0; k < n; ++k) {
    const Stress<2> D = place(1.2 * (k + 1) / n) - place(1.2 * k / n);
    trapezoidal_return<2>(material, D, s, ep);
  }
  return {s[0] / radius, s[3] / radius, ep};
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace

TEST(TrapezoidalReturn, EqualsTheBackwardReturnOnARadialPath) {
  for (const J2Parameters& material : {example_material(), example_material(1.93e8, 0), bending_material()})
    for (double start : {0.0, 0.4, 1.0}) {
      Stress<2> s = start * on_surface(material, {1, -0.3, -0.7, 0.6}, 0.01);
      const Stress<2> D = 1.7 * on_surface(material, {1, -0.3, -0.7, 0.6}, 0.01);
      Stress<2> backward = s + D;
      double ep = 0.01, backward_ep = 0.01;
      const double x = trapezoidal_return<2>(material, D, s, ep).increment;
      EXPECT_GT(x, 0);
      EXPECT_NEAR(x, radial_return<2>(material, backward, backward_ep), 1e-15);
      EXPECT_NEAR(ep, backward_ep, 1e-15);
      expect_close(s, backward, material.yield_stress(0).value, 1e-14, "deviator");
    }
}

TEST(TrapezoidalReturn, EndsOnTheSurface) {
  for (const J2Parameters& material : {example_material(), example_material(1.93e8, 0), bending_material()})
    for (double fraction : {0.2, 1.0, 1 + 1e-12}) // of the yield stress at the start
      for (double angle = 0; angle < 3.1; angle += 0.3) {
        Stress<2> s = fraction * on_surface(material, {1, -1, 0, 0}, 0.02);
        Stress<2> D = 3 * on_surface(material, {std::cos(angle), -std::cos(angle), 0, std::sin(angle)}, 0.02);
        double ep = 0.02;
        const double x = trapezoidal_return<2>(material, D, s, ep).increment;
        EXPECT_GT(x, 0);
        EXPECT_DOUBLE_EQ(ep, 0.02 + x);
        EXPECT_NEAR(equivalent<2>(s) / material.yield_stress(ep).value, 1, 1e-13) << angle;
      }
}

TEST(TrapezoidalReturn, InsideIsElastic) {
  const J2Parameters material = example_material();
  Stress<2> s = on_surface(material, {1, -1, 0, 0}, 0.02), D = -0.5 * s, end = s + D;
  double ep = 0.02;
  EXPECT_EQ(trapezoidal_return<2>(material, D, s, ep).increment, 0);
  EXPECT_EQ(s, end);
  EXPECT_EQ(ep, 0.02);
}

TEST(TrapezoidalReturn, IsSecondOrderOnAnArc) {
  for (const J2Parameters& material : {example_material(), example_material(1.93e8, 0), bending_material()}) {
    const auto exact = arc(material, 20000);
    for (int n : {10, 20, 40}) {
      const double coarse = distance(arc(material, n), exact), fine = distance(arc(material, 2 * n), exact);
      EXPECT_NEAR(coarse / fine, 4, 0.4) << n << " parts";
    }
    EXPECT_LT(distance(arc(material, 20), exact), 2e-3);
  }
}
