// Coordinates by formula: mechanisms against finite differences and closed forms, polar by formula, errors.
#include "kinematics/cartesian.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "kinematics/polar.hpp"
#include "unit/kinematics/pose_derivatives.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

struct Mechanism {
  const char* name;
  const char* coordinates;
  PlaneFormulas formulas;
  std::map<std::string, double> parameters;
  std::vector<std::vector<double>> places;
};

const Mechanism MECHANISMS[] = {
    {"crank with connecting rod",
     "beta",
     {"e*cos(beta)+sqrt(l^2-e^2*sin(beta)^2)", "0", "0"},
     {{"e", 0.3}, {"l", 1}},
     {{0}, {0.4}, {2.5}, {-1}}},
    {"eccentric", // a disk turns about a point beside its center
     "beta",
     {"e*cos(beta)", "e*sin(beta)+h", "beta"},
     {{"e", 0.3}, {"h", -2}},
     {{0}, {1}, {4}}},
    {"screw", // of the plane: turns as it goes forward
     "s",
     {"s*cos(alpha)", "s*sin(alpha)", "2*pi*s/pitch"},
     {{"alpha", 0.3}, {"pitch", 5}},
     {{0}, {0.7}, {-1.2}}},
    {"rolling on a circle", // the center on radius a + b, rolling without slip on a fixed circle of radius a
     "phi",
     {"(a+b)*cos(phi)", "(a+b)*sin(phi)", "phi*(1+a/b)"},
     {{"a", 0.7}, {"b", 0.4}},
     {{0}, {1}, {-2}}},
    {"linkage of two bars",
     "alpha, gamma, theta",
     {"a*cos(alpha)+b*cos(alpha+gamma)", "a*sin(alpha)+b*sin(alpha+gamma)", "alpha+gamma+theta"},
     {{"a", 0.8}, {"b", 0.5}},
     {{0, 0, 0}, {0.3, 1.1, -0.4}, {2, -1, 1}}},
    {"polar with a pivot that moves",
     "r, phi, theta, s",
     {"v*s+r*cos(phi)", "r*sin(phi)+s^2/2", "theta+s*phi"},
     {{"v", 1.5}},
     {{1, 0, 0, 0}, {0.8, 0.4, -1, 0.6}}},
    {"follower by logarithm and arc tangent",
     "p, q_1",
     {"log(1+p^2)/2", "exp(-q_1)*tanh(p)", "atan2(q_1, 1+p)"},
     {},
     {{0.3, 0.2}, {1.2, -0.5}}}};

FormulaCoordinates<2> made(const Mechanism& m) {
  return FormulaCoordinates<2>(m.name, coordinate_names(m.coordinates), m.formulas, m.parameters);
}

FormulaCoordinates<2> crank(const std::vector<std::string>& names, const PlaneFormulas& formulas) {
  return FormulaCoordinates<2>("crank", names, formulas, {{"e", 0.01}, {"h", 1}, {"zero", 0}});
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void expect_same_pose(const Pose<2>& a, const Pose<2>& b, double tolerance) {
  expect_close(a.origin, b.origin, 1, tolerance, "origin");
  expect_close(a.R, b.R, 1, tolerance, "R");
  for (std::size_t k = 0; k < a.R_q.size(); ++k) {
    expect_close(a.origin_q[k], b.origin_q[k], 1, tolerance, "origin_q");
    expect_close(a.R_q[k], b.R_q[k], 1, tolerance, "R_q");
    for (std::size_t l = 0; l < a.R_q.size(); ++l) {
      expect_close(a.origin_qq[k][l], b.origin_qq[k][l], 1, tolerance, "origin_qq");
      expect_close(a.R_qq[k][l], b.R_qq[k][l], 1, tolerance, "R_qq");
    }
  }
}

} // namespace

TEST(FormulaCoordinates, DerivativesAgainstFiniteDifferences) {
  for (const Mechanism& mechanism : MECHANISMS) {
    SCOPED_TRACE(mechanism.name);
    const FormulaCoordinates<2> coordinates = made(mechanism);
    for (const auto& place : mechanism.places) check_pose_derivatives(coordinates, vector_of(place));
  }
}

TEST(FormulaCoordinates, CrankByHand) { // slider-crank: x, dx/dbeta and d2x/dbeta2 at beta = 0 and pi/2
  const FormulaCoordinates<2> slider = made(MECHANISMS[0]);
  EXPECT_EQ(slider.names(), std::vector<std::string>{"beta"});
  const Pose<2> dead_center = slider.pose(Eigen::VectorXd::Zero(1));
  EXPECT_NEAR(dead_center.origin.x(), 1.3, 1e-15);
  EXPECT_NEAR(dead_center.origin_q[0].x(), 0, 1e-15);
  EXPECT_NEAR(dead_center.origin_qq[0][0].x(), -0.3 - 0.09, 1e-15); // -e - e^2/l
  const Pose<2> upright = slider.pose(Eigen::VectorXd::Constant(1, M_PI_2));
  EXPECT_NEAR(upright.origin.x(), std::sqrt(1 - 0.09), 1e-15);
  EXPECT_NEAR(upright.origin_q[0].x(), -0.3, 1e-15);
}

TEST(FormulaCoordinates, SameAsPolarAndCartesian) {
  const Polar polar({0.4, -0.7});
  const FormulaCoordinates<2> by_formula("roller", {"r", "phi", "theta"},
                                         {"x0+r*cos(phi)", "y0+r*sin(phi)", "theta"},
                                         {{"x0", 0.4}, {"y0", -0.7}});
  EXPECT_EQ(by_formula.names(), polar.names());
  const FormulaCoordinates<2> plain("roller", {"x", "y", "angle"}, {"x", "y", "angle"});
  for (const Eigen::Vector3d& q : {Eigen::Vector3d(1, 0, 0), {1.5, 0.3, -2}, {0.8, -4, 9}, {0, 1, 1}}) {
    expect_same_pose(by_formula.pose(q), polar.pose(q), 1e-14);
    expect_same_pose(plain.pose(q), Cartesian().pose(q), 1e-14);
  }
}

TEST(FormulaCoordinates, CarrierIsTheTranslation) {
  const RigidMotion<2> carrier =
      crank({"beta"}, {"e*cos(beta)", "h*beta"}).carrier(vector_of({0}), vector_of({M_PI}));
  expect_close(carrier.d, Vector<2>(-0.02, M_PI), 1, 1e-15, "translation");
  expect_close(carrier.R, Tensor<2>::Identity(), 1, 0, "R");
}

TEST(FormulaCoordinates, SameInMetersAndMillimeters) {
  const Mechanism m = MECHANISMS[0];
  const FormulaCoordinates<2> in_mm("crank", {"beta"}, m.formulas, {{"e", 300}, {"l", 1000}});
  for (const auto& place : m.places) {
    const Pose<2> a = made(m).pose(vector_of(place)), b = in_mm.pose(vector_of(place));
    expect_close(1000 * a.origin, b.origin, 1000, 1e-15, "origin");
    expect_close(1000 * a.origin_q[0], b.origin_q[0], 1000, 1e-15, "origin_beta");
    expect_close(1000 * a.origin_qq[0][0], b.origin_qq[0][0], 1000, 1e-15, "origin_beta,beta");
  }
}

TEST(FormulaCoordinates, ListsOfNames) {
  EXPECT_EQ(coordinate_names(" r,phi ,\ttheta"), (std::vector<std::string>{"r", "phi", "theta"}));
  EXPECT_EQ(coordinate_names("beta"), std::vector<std::string>{"beta"});
  for (const char* list : {"", " ", "r,,phi", "r,", ",r"})
    expect_invalid([&] { coordinate_names(list); }, "\"" + std::string(list) + "\" has an empty name");
}

TEST(FormulaCoordinates, RefuseBadInput) {
  expect_invalid([] { crank({}, {"1", "2"}); }, "coordinates of tool \"crank\": no names");
  expect_invalid([] { crank({"b", "b"}, {"b", "0"}); }, "tool \"crank\": name \"b\" occurs twice");
  expect_invalid([] { crank({"e"}, {"e", "0"}); }, "tool \"crank\": name \"e\" occurs twice");
  expect_invalid([] { crank({"1b"}, {"e", "0"}); }, "name \"1b\" is no identifier");
  expect_invalid([] { crank({"sin"}, {"e", "0"}); }, "name \"sin\" is taken by a function");
  expect_invalid(
      [] {
        crank({"b"}, {"e*cos(beta)", "0"});
      },
      "x of tool \"crank\" \"e*cos(beta)\": at character 7: unknown name \"beta\"");
  expect_invalid(
      [] {
        crank({"b"}, {"b", "2*(b"});
      },
      "y of tool \"crank\" \"2*(b\": the formula ends too early");
  expect_invalid([] { crank({"b"}, {"b", "0", ""}); }, "angle of tool \"crank\" \"\": the formula is empty");
  expect_invalid(
      [] {
        crank({"a", "b"}, {"a", "2*a", "zero*b"});
      },
      "tool \"crank\": coordinate \"b\" moves nothing: x = \"a\", y = \"2*a\", angle = \"zero*b\"");
  const FormulaCoordinates<2> good = crank({"b"}, {"e/b", "0"}), root = crank({"b"}, {"b^(3/2)", "0"});
  expect_invalid([&] { good.pose(vector_of({1, 2})); }, "size of q = 2, expected 1 (b)");
  expect_invalid([&] { good.pose(vector_of({std::nan("")})); }, "b = nan, expected a finite number");
  expect_invalid([&] { good.pose(vector_of({0})); },
                 "x of tool \"crank\" \"e/b\": 1/0 is no finite real number, at b = 0");
  expect_invalid([&] { root.pose(vector_of({0})); }, "x of tool \"crank\" \"b^(3/2)\", derivative by b and "
                                                     "b: (0)^(-0.5) is no finite real number, at b = 0");
}
