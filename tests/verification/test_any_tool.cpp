// T2 (duality), T3 (invariance) and T4 (resultants) for every profile and every kind of coordinates: circle, arc chain,
// CAD curve; Cartesian, polar, formula.
#include "cad/occ/cad_curve.hpp"
#include "geometry/arc_chain.hpp"
#include "geometry/plane.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "support/any_tool.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const double R = 3;
const Vector<2> PIVOT(2.2, -3);

std::shared_ptr<const Profile<2>> circle() { return std::make_shared<Circle>(R); }
/// The same circle as four fillets that use up the sides of a square.
std::shared_ptr<const Profile<2>> circle_of_arcs() {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{R, R}, {-R, R}, {-R, -R}, {R, -R}},
                                    std::vector<double>(4, R), true);
}
/// The same circle from a STEP file of radius 15.
std::shared_ptr<const Profile<2>> circle_of_step() {
  CadSelection file;
  file.file = "tests/support/cad/circle.step";
  file.scale = R / 15;
  return std::make_shared<CadCurve>(file);
}
/// A cam whose outline is one closed B-spline, about 3 in radius.
std::shared_ptr<const Profile<2>> lobe() {
  CadSelection file;
  file.file = "tests/support/cad/lobe.step";
  file.scale = 0.3;
  return std::make_shared<CadCurve>(file);
}
/// The cam on the roller's path, at the height where it touches at the start.
AnyTool rolling_lobe() {
  const auto profile = lobe();
  const auto range = profile->range();
  double lowest = 0;
  for (int i = 0; i < 4000; ++i) {
    const Param<2> s = range.begin + i / 4000. * (range.end - range.begin);
    lowest = std::min(lowest, (plane_rotation(roller_path(0)[2]) * profile->evaluate(s).x).y());
  }
  return {profile, std::make_shared<Cartesian>(),
          [lowest](int k) {
            Vector<3> q = roller_path(k);
            q[1] += 1.5 - lowest - 4.5;
            return Eigen::VectorXd(q);
          },
          "y"};
}
/// A crowned punch: flat of width 0.8, fillets of radius 1.2.
std::shared_ptr<const Profile<2>> crowned() {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{1.6, 5}, {1.6, 0}, {-1.6, 0}, {-1.6, 5}},
                                    std::vector<double>{0, 1.2, 1.2, 0});
}

std::shared_ptr<const Coordinates<2>> by_formula(const std::string& names, const PlaneFormulas& formulas,
                                                 const std::map<std::string, double>& parameters = {}) {
  return std::make_shared<FormulaCoordinates<2>>("tool", coordinate_names(names), formulas, parameters);
}
AnyTool cartesian(std::shared_ptr<const Profile<2>> profile) {
  return {profile, std::make_shared<Cartesian>(), roller_path, "y"};
}
AnyTool polar(std::shared_ptr<const Profile<2>> profile) {
  return {profile, std::make_shared<Polar>(PIVOT), [](int k) { return polar_place(roller_path(k), PIVOT); },
          "r"};
}
AnyTool polar_by_formula(std::shared_ptr<const Profile<2>> profile) {
  AnyTool tool = polar(profile);
  tool.coordinates = by_formula("r, phi, theta", {"px + r*cos(phi)", "py + r*sin(phi)", "theta"},
                                {{"px", PIVOT.x()}, {"py", PIVOT.y()}});
  return tool;
}
/// A crowned punch on a crank with a connecting rod: one coordinate. The dead center below is at beta = 0.
AnyTool crank() {
  return {crowned(),
          by_formula("beta", {"2", "h - e*cos(beta) - sqrt(l^2 - e^2*sin(beta)^2)"},
                     {{"e", 0.5}, {"l", 2}, {"h", 3.772}}),
          [](int k) { return Eigen::VectorXd::Constant(1, -0.9 + 0.02 * k); }, "beta"};
}

} // namespace

TEST(AnyToolDuality, CircleOfArcs) {
  check_duality(cartesian(circle_of_arcs()), {0, 1});
  check_duality(polar(circle_of_arcs()), {0, 2});
}
TEST(AnyToolDuality, FormulaCoordinates) {
  for (const auto& loaded : std::vector<std::vector<int>>{{0}, {2}, {0, 1}, {0, 2}})
    check_duality(polar_by_formula(circle()), loaded);
}
TEST(AnyToolDuality, CadCurves) {
  check_duality(polar(circle_of_step()), {0, 2});
  check_duality(rolling_lobe(), {0, 1});
  check_duality(rolling_lobe(), {1, 2});
}
TEST(AnyToolDuality, CrankWithACrownedPunch) { check_duality(crank(), {0}); }

TEST(AnyToolInvariance, CircleAsArcs) { check_same(cartesian(circle()), cartesian(circle_of_arcs())); }
TEST(AnyToolInvariance, CircleFromCad) { check_same(cartesian(circle()), cartesian(circle_of_step())); }
TEST(AnyToolInvariance, PolarByFormula) {
  check_same(polar(circle()), polar_by_formula(circle()));
  check_same(cartesian(circle()), polar_by_formula(circle()));
}
// One coordinate drives position and turn together.
TEST(AnyToolInvariance, PathAsOneCoordinate) {
  AnyTool one = cartesian(circle()), three = one;
  one.coordinates =
      by_formula("k", {"1.7 + a*k", "4.51 - b*k", "0.1 - c*k"}, {{"a", 0.012}, {"b", 0.006}, {"c", 0.005}});
  one.path = [](int k) { return Eigen::VectorXd::Constant(1, k); };
  three.path = [](int k) { return Vector<3>(1.7 + 0.012 * k, 4.51 - 0.006 * k, 0.1 - 0.005 * k); };
  check_same(one, three);
}
