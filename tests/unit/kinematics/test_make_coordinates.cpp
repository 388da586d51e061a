// The words of a script for coordinates: each kind in the plane and in space, names, and every message.
#include "kinematics/cartesian_in_space.hpp"
#include "kinematics/rotation.hpp"
#include "support/script_tool.hpp"
#include "unit/finite_difference.hpp"
#include "unit/kinematics/pose_derivatives.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

using Names = std::vector<std::string>;
template <int Dim>
std::shared_ptr<const Coordinates<Dim>> made(const std::string& kind, const Call& call = {}) {
  return make_coordinates<Dim>("ball", kind, call, {{"e", 0.3}});
}
template <int Dim> void refuses(const std::string& kind, const Call& call, const std::string& message) {
  expect_invalid([&] { made<Dim>(kind, call); }, message);
}
Eigen::VectorXd numbers(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}
Tensor<3> turn(const Vector<3>& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}
const Vector<3> X = Vector<3>::UnitX(), Y = Vector<3>::UnitY(), Z = Vector<3>::UnitZ();

} // namespace

TEST(MakeCoordinates, NamesOfEachKind) {
  EXPECT_EQ(made<2>("cartesian")->names(), (Names{"x", "y", "angle"}));
  EXPECT_EQ(made<2>("polar")->names(), (Names{"r", "phi", "theta"}));
  EXPECT_EQ(made<2>("a, b", Call().text("x", "a").text("y", "b"))->names(), (Names{"a", "b"}));
  EXPECT_EQ(made<3>("cartesian")->names(), (Names{"x", "y", "z", "spinx", "spiny", "spinz"}));
  EXPECT_EQ(made<3>("polar")->names(), (Names{"r", "phi", "z", "theta"}));
  EXPECT_EQ(made<3>("screw", Call().number("lead", 1))->names(), (Names{"phi"}));
  EXPECT_EQ(made<3>("a, b", Call().text("x", "a").text("y", "b").text("z", "0"))->names(), (Names{"a", "b"}));
  const auto cartesian = [](const std::string& rotation) {
    return made<3>("cartesian", Call().text("rotation", rotation))->names();
  };
  EXPECT_EQ(cartesian("z:phi x:theta z:psi"), (Names{"x", "y", "z", "phi", "theta", "psi"}));
  EXPECT_EQ(cartesian("vector: a, b, c"), (Names{"x", "y", "z", "a", "b", "c"}));
  EXPECT_EQ(cartesian("quaternion: w, a, b, c"), (Names{"x", "y", "z", "w", "a", "b", "c"}));
  EXPECT_EQ(cartesian("z:sin(phi)*pi y:2*tilt+phi*e"), (Names{"x", "y", "z", "phi", "tilt"}))
      << "e is a parameter";
  EXPECT_EQ(cartesian("z:x x:0.3"), (Names{"x", "y", "z"})) << "a turn that depends on the place";
  EXPECT_EQ(cartesian(""), (Names{"x", "y", "z"})) << "no turns";
}

TEST(MakeCoordinates, PosesInClosedForm) {
  const Pose<3> euler = made<3>("cartesian", Call().text("rotation", "z:phi x:theta z:psi"))
                            ->pose(numbers({1, 2, 3, 0.4, 1.2, -0.6}));
  expect_close(euler.R, Tensor<3>(turn(Z, 0.4) * turn(X, 1.2) * turn(Z, -0.6)), 1, 1e-15, "Euler's angles");
  expect_close(euler.origin, Vector<3>(1, 2, 3), 1, 0, "origin");
  const Call line = Call().list("pivot", {1, 0, 0}).list("axis", {0, 5, 0});
  const Pose<3> polar = made<3>("polar", line)->pose(numbers({2, M_PI / 2, 7, 0.3})); // z to y: y goes to -z
  expect_close(polar.origin, Vector<3>(1, 7, -2), 1, 1e-14, "origin");
  expect_close(polar.R, turn(Y, 0.3), 1, 1e-14, "R");
  const Pose<3> screw = made<3>("screw", Call(line).number("lead", 4))->pose(numbers({M_PI / 2}));
  expect_close(screw.origin, Vector<3>(1, 1, 1), 1, 1e-14, "origin");
  expect_close(screw.R, turn(Y, M_PI / 2), 1, 1e-14, "R");
}

TEST(MakeCoordinates, DerivativesOfEachKind) {
  for (const auto& call : coordinates_calls()) {
    SCOPED_TRACE(call.name);
    check_pose_derivatives(*coordinates_of(call), numbers(call.q));
  }
}

TEST(MakeCoordinatesErrors, InThePlane) {
  refuses<2>("spherical", {},
             "tool.coordinates: unknown kind \"spherical\", expected \"polar\", \"cartesian\", or names of "
             "coordinates with their formulas x= and y=");
  refuses<2>("polar", Call().list("pivot", {1, 2, 3}),
             "tool.coordinates: number of values in pivot = 3, expected 2: [x0,y0]");
  refuses<2>("polar", Call().text("x", "r"),
             "\"polar\" takes pivot=[x0,y0], not x=, which is a formula of coordinates named by the script");
  refuses<2>("cartesian", Call().text("y", "r"), "\"cartesian\" takes no more parameters, not y=");
  refuses<2>("cartesian", Call().list("pivot", {1, 2}), "\"cartesian\" takes no pivot=, only \"polar\" does");
  refuses<2>("b", Call().text("x", "b"), "coordinates \"b\" of tool \"ball\" lack the formula y=");
  refuses<2>("b", Call().text("x", "b").text("y", "0").list("pivot", {0, 0}),
             "\"b\" takes no pivot=, only \"polar\" does");
  refuses<2>("cartesian", Call().text("rotation", "z:a"),
             "tool \"ball\" is one of the plane and takes no rotation=, but angle=");
  refuses<2>("b", Call().text("x", "b").text("y", "0").text("z", "0"),
             "tool \"ball\" is one of the plane and takes no z=");
  refuses<2>("polar", Call().list("axis", {0, 0, 1}), "tool \"ball\" is one of the plane and takes no axis=");
}

TEST(MakeCoordinatesErrors, InSpace) {
  refuses<3>("spherical", {},
             "tool.coordinates: unknown kind \"spherical\", expected \"polar\", \"cartesian\", \"screw\", or "
             "names of coordinates with their formulas x=, y= and z=");
  refuses<3>("polar", Call().list("pivot", {1, 2}), "number of values in pivot = 2, expected 3: [x0,y0,z0]");
  refuses<3>("polar", Call().list("pivot", {1, std::nan(""), 2}), "tool.coordinates: pivot = ");
  refuses<3>("polar", Call().list("axis", {1, 2}), "number of values in axis = 2, expected 3: [x,y,z]");
  refuses<3>("polar", Call().list("axis", {0, 0, 0}), "tool.coordinates: direction of the axis = 0 0 0");
  refuses<3>("polar", Call().number("lead", 1), "\"polar\" takes no lead=, only \"screw\" does");
  refuses<3>("cartesian", Call().list("axis", {0, 0, 1}),
             "\"cartesian\" takes no axis=, only \"polar\" and \"screw\" do");
  refuses<3>("cartesian", Call().text("z", "0"), "\"cartesian\" takes rotation=, not z=, which is a formula");
  refuses<3>("cartesian", Call().text("angle", "0"),
             "tool \"ball\" is one of space and takes no angle=, but rotation=");
  refuses<3>("screw", {}, "\"screw\" of tool \"ball\" lacks lead=, the way along the axis of a full turn");
  refuses<3>("screw", Call().number("lead", std::nan("")), "Screw: lead = ");
  refuses<3>("b", Call().text("x", "b").text("y", "0"),
             "coordinates \"b\" of tool \"ball\" lack the formula z=");
  refuses<3>("cartesian", Call().text("rotation", "phi"), "rotation of tool \"ball\" \"phi\": no axis");
  refuses<3>("cartesian", Call().text("rotation", "w:phi"),
             "rotation of tool \"ball\" \"w:phi\": unknown axis");
  refuses<3>("cartesian", Call().text("rotation", "z:phi+"), "rotation about z of tool \"ball\" \"phi+\"");
  refuses<3>("cartesian", Call().text("rotation", "z:foo(phi)"), "unknown function \"foo\"");
  refuses<3>("cartesian", Call().text("rotation", "vector: a, b"), "a vector of 2 numbers");
}

TEST(MakeCoordinatesErrors, AQuaternionOfLengthZero) {
  const auto quaternion = made<3>("cartesian", Call().text("rotation", "quaternion: w, a, b, c"));
  expect_invalid([&] { quaternion->pose(Eigen::VectorXd::Zero(7)); },
                 "rotation of tool \"ball\": the quaternion has the length 0, expected a direction; place "
                 "its first number at 1");
  expect_close(quaternion->pose(numbers({0, 0, 0, 1, 0, 0, 0})).R, Tensor<3>::Identity(), 1, 0,
               "no rotation");
}

// The reference turns along: many turns about all axes, and no pose in which a spin moves less.
TEST(TurningSpins, NoPoseIsSingular) {
  const CartesianInSpace spins;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
  Tensor<3> R = Tensor<3>::Identity();
  for (int i = 0; i < 200; ++i) {
    Eigen::VectorXd next = q;
    const Vector<3> v(0.3 * std::sin(0.1 * i), 0.2, 0.25 * std::cos(0.07 * i));
    next.tail<3>() += v;
    R = turn(v, v.norm()) * R;
    expect_close(spins.pose(next).R, R, 1, 1e-13, "turns one after the other");
    spins.refer_to(spins.reference_at(next));
    q = next;
    const Pose<3> pose = spins.pose(q);
    expect_close(pose.R, R, 1, 1e-13, "the pose stays");
    for (std::size_t k = 0; k < 3; ++k) { // moments about axes fixed in space
      const Tensor<3> spin = pose.R_q[3 + k] * pose.R.transpose();
      expect_close(spin, cross_matrix(Vector<3>::Unit(static_cast<int>(k))), 1, 1e-14, "axis");
    }
  }
  EXPECT_GT(q.tail<3>().norm(), 6 * M_PI);
}

TEST(TurningSpins, TurnsAboutOneAxisAddUp) {
  const CartesianInSpace spins;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
  for (int i = 0; i < 50; ++i) {
    q[4] += 0.4;
    spins.refer_to(spins.reference_at(q));
  }
  expect_close(spins.pose(q).R, turn(Y, 20), 1, 1e-13, "R");
}

TEST(TurningSpins, AReferenceIsPutBack) {
  const CartesianInSpace spins;
  const Eigen::VectorXd q = numbers({1, 2, 3, 0.4, -0.8, 1.1}), r = numbers({1, 2, 3, 0.5, -0.5, 1.3});
  const Eigen::VectorXd start = spins.reference();
  const Tensor<3> R = spins.pose(r).R;
  spins.refer_to(spins.reference_at(q));
  check_pose_derivatives(spins, r);
  EXPECT_GT((spins.pose(r).R - R).norm(), 1e-3) << "turns do not commute";
  spins.refer_to(start);
  EXPECT_EQ(spins.pose(r).R, R);
  expect_invalid([&] { spins.refer_to(numbers({1})); },
                 "CartesianInSpace::refer_to: size of the reference = 1, expected 7");
  EXPECT_EQ(made<2>("polar")->reference().size(), 0);
}
