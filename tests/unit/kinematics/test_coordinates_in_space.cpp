// Coordinates of space: derivatives of the pose, what is conjugate to them, formulas of rotations, carriers, errors.
#include "kinematics/cartesian_in_space.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "kinematics/polar_in_space.hpp"
#include "kinematics/screw.hpp"
#include "unit/kinematics/pose_derivatives.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

struct NamedCoordinates {
  std::string name;
  std::shared_ptr<const Coordinates<3>> coordinates;
  std::vector<std::vector<double>> places;
};

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

AxisFrame skew_axis() { return axis_frame("test", {0.3, -1.1, 0.7}, {1, 2, -2}, {0, 1, 0.2}); }

std::shared_ptr<const FormulaCoordinates<3>> formulas(const std::string& names,
                                                      const SpaceFormulas& formulas) {
  return std::make_shared<FormulaCoordinates<3>>(
      "crank", coordinate_names(names), formulas,
      std::map<std::string, double>{{"e", 0.3}, {"l", 1}, {"zero", 0}});
}

const SpaceFormulas EULER{"x", "y", "z", "z:phi x:theta z:psi"};
const char* const SIX = "x, y, z, phi, theta, psi";

std::vector<NamedCoordinates> all() {
  return {
      {"cartesian",
       std::make_shared<CartesianInSpace>(),
       {{0, 0, 0, 0, 0, 0}, {1, -2, 3, 0.5, -1, 2}, {0, 1, 0, 1e-3, 0, -2e-3}, {0, 0, 0, 4, 3, 1}}},
      {"polar",
       std::make_shared<PolarInSpace>(skew_axis()),
       {{1.5, 0.4, -2, 3}, {0.8, -2, 0, 0}, {0, 1, 1, 1}}},
      {"screw", std::make_shared<Screw>(skew_axis(), 2.5), {{0}, {0.7}, {-9}}},
      {"Euler's angles", formulas(SIX, EULER), {{1, 2, 3, 0.4, 1.2, -0.6}, {0, 0, 0, 0.3, 0.01, 0}}},
      {"one angle drives two axes",
       formulas("s, phi", {"s", "0", "s*phi", "[1 1 e]:phi + s/2 y:-phi*s"}),
       {{0.4, 1.2}, {0, 0}}},
      {"rotation vector",
       formulas("a, b", {"a", "b", "a*b", "vector: a, sin(b), atan2(a, 1+b)"}),
       {{0.4, 1.2}}},
      {"quaternion",
       formulas("w, a, b, c", {"a*w", "0", "c", "quaternion: w, a, b, c"}),
       {{1, 0, 0, 0}, {0.3, -0.5, 0.8, 1.1}}},
      {"crank with tilt",
       formulas("beta", {"e*cos(beta)+sqrt(l^2-e^2*sin(beta)^2)", "0", "0", "y:asin(e/l*sin(beta)) x:beta"}),
       {{0}, {0.9}, {-2}}}};
}

/// Of the change of the rotation with coordinate k: R_k = axis_k^ R.
Vector<3> axis_of(const Pose<3>& pose, std::size_t k) {
  const Tensor<3> spin = pose.R_q[k] * pose.R.transpose();
  return {spin(2, 1), spin(0, 2), spin(1, 0)};
}

void expect_same_pose(const Pose<3>& a, const Pose<3>& b) {
  expect_close(a.origin, b.origin, 1, 1e-14, "origin");
  expect_close(a.R, b.R, 1, 1e-14, "R");
  for (std::size_t k = 0; k < a.R_q.size(); ++k) {
    expect_close(a.origin_q[k], b.origin_q[k], 1, 1e-14, "origin_q");
    expect_close(a.R_q[k], b.R_q[k], 1, 1e-14, "R_q");
    for (std::size_t l = 0; l < a.R_q.size(); ++l) {
      expect_close(a.origin_qq[k][l], b.origin_qq[k][l], 1, 1e-14, "origin_qq");
      expect_close(a.R_qq[k][l], b.R_qq[k][l], 1, 1e-14, "R_qq");
    }
  }
}

} // namespace

TEST(CoordinatesInSpace, DerivativesAgainstDifferences) {
  for (const auto& [name, coordinates, places] : all()) {
    SCOPED_TRACE(name);
    for (const auto& place : places) check_pose_derivatives(*coordinates, vector_of(place));
  }
}

// METHOD.md (2.14): the sum over X_k . F of forces anywhere on the tool is origin_k . f + axis_k . M, to rounding of the terms.
TEST(CoordinatesInSpace, ForcesConjugateToThem) {
  const Vector<3> places[] = {{1, 0.5, -2}, {-0.3, 2, 1}, {0.7, -1, 0.2}};
  const Vector<3> forces[] = {{3, -1, 2}, {0.5, 2, -1}, {-4, 1, 0.3}};
  for (const auto& [name, coordinates, q] : all())
    for (const auto& at : q) {
      const Pose<3> pose = coordinates->pose(vector_of(at));
      for (std::size_t k = 0; k < pose.R_q.size(); ++k) {
        Vector<3> f(0, 0, 0), M(0, 0, 0);
        double Q = 0, size = 0;
        for (int i = 0; i < 3; ++i) {
          f += forces[i];
          M += (pose.R * places[i]).cross(forces[i]);
          Q += forces[i].dot(pose.origin_q[k] + pose.R_q[k] * places[i]);
          size += forces[i].norm() * (pose.origin_q[k].norm() + axis_of(pose, k).norm() * places[i].norm());
        }
        EXPECT_NEAR(Q, pose.origin_q[k].dot(f) + axis_of(pose, k).dot(M), 1e-14 * size) << name << " " << k;
      }
    }
}

TEST(CoordinatesInSpace, AxesOfASpin) {
  const auto axes = [](const Vector<3>& spin) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q.tail<3>() = spin;
    const Pose<3> pose = CartesianInSpace().pose(q);
    Tensor<3> columns;
    for (std::size_t k = 0; k < 3; ++k) columns.col(static_cast<Eigen::Index>(k)) = axis_of(pose, 3 + k);
    return columns;
  };
  EXPECT_EQ(axes({0, 0, 0}), Tensor<3>(Tensor<3>::Identity()));
  const double spin = 0.8, half = std::sin(spin / 2) / (spin / 2);
  const Tensor<3> about_z = axes({0, 0, spin});
  expect_close(Vector<3>(about_z.col(2)), Vector<3>(0, 0, 1), 1, 1e-15, "about its own axis");
  expect_close(Vector<3>(about_z.col(0)), Vector<3>(half * std::cos(spin / 2), half * std::sin(spin / 2), 0),
               1, 1e-15, "half the way");
  const Vector<3> any(0.5, -1, 2);
  expect_close(Vector<3>(axes(any) * any), any, 1, 1e-14, "spin . Q_spin = spin . M");
  EXPECT_NEAR(axes({0, 0, 2 * M_PI}).leftCols<2>().norm(), 0, 1e-15) << "nothing but its own axis";
}

TEST(CoordinatesInSpace, ReadyMadeOnesByFormula) {
  const AxisFrame z_axis;
  const auto polar = formulas("r, phi, z, theta", {"r*cos(phi)", "r*sin(phi)", "z", "z:theta"});
  EXPECT_EQ(polar->names(), PolarInSpace(z_axis).names());
  expect_same_pose(polar->pose(vector_of({1.5, 0.4, -2, 3})),
                   PolarInSpace(z_axis).pose(vector_of({1.5, 0.4, -2, 3})));
  const auto spins = formulas("x, y, z, spinx, spiny, spinz", {"x", "y", "z", "vector: spinx, spiny, spinz"});
  const Eigen::VectorXd q = vector_of({1, -2, 3, 0.5, -1, 2});
  expect_same_pose(spins->pose(q), CartesianInSpace().pose(q));
  expect_same_pose(formulas("phi", {"0", "0", "2.5*phi/(2*pi)", "z:phi"})->pose(vector_of({0.7})),
                   Screw(z_axis, 2.5).pose(vector_of({0.7})));
  const Pose<3> still = formulas("s", {"s", "0", "0"})->pose(vector_of({2}));
  expect_close(still.R, Tensor<3>::Identity(), 1, 0, "no rotation");
}

// A point of a screw goes along its helix, one of the axis along the axis.
TEST(CoordinatesInSpace, AScrewKeepsItsAxis) {
  const AxisFrame axis = skew_axis();
  const Screw screw(axis, 2.5);
  const auto moved = [&](const Vector<3>& y, double phi) {
    const Pose<3> pose = screw.pose(vector_of({phi}));
    return axis.local(pose.origin + pose.R * y);
  };
  expect_close(moved(axis.global({0, 0, 1}), 3), Vector<3>(0, 0, 1 + 7.5 / (2 * M_PI)), 1, 1e-15, "axis");
  expect_close(moved(axis.global({2, 0, 0}), M_PI_2), Vector<3>(0, 2, 2.5 / 4), 1, 1e-15, "helix");
  expect_close(moved({1, 2, 3}, 0), axis.local({1, 2, 3}), 1, 1e-15, "start");
}

TEST(CoordinatesInSpace, Carriers) {
  const RigidMotion<3> advance = Screw(skew_axis(), 2.5).carrier(vector_of({0.3}), vector_of({0.3 + M_PI}));
  expect_close(advance.R, Tensor<3>::Identity(), 1, 0, "a screw's carrier does not turn");
  expect_close(advance.d, Vector<3>(1.25 * skew_axis().base.col(2)), 1, 1e-15, "it goes along the axis");
  const PolarInSpace polar(skew_axis());
  const Eigen::VectorXd from = vector_of({1.5, 0.4, -2, 3}), to = vector_of({1.5, 0.9, -1.6, 8});
  const RigidMotion<3> carrier = polar.carrier(from, to);
  expect_close(carrier(polar.pose(from).origin), polar.pose(to).origin, 1, 1e-15, "origin");
  expect_close(carrier(polar.axis().point), polar.axis().global({0, 0, 0.4}), 1, 1e-15, "axis");
  const auto six = formulas(SIX, EULER);
  const RigidMotion<3> shift = six->carrier(vector_of({0, 0, 0, 1, 2, 3}), vector_of({1, 2, 3, 0, 0, 0}));
  expect_close(shift.d, Vector<3>(1, 2, 3), 1, 1e-15, "translation");
  EXPECT_EQ(shift.R, Tensor<3>(Tensor<3>::Identity()));
}

TEST(CoordinatesInSpace, RotationsThatAreRefused) {
  const auto refuse = [](const std::string& rotation, const std::string& text) {
    SCOPED_TRACE(rotation);
    expect_invalid([&] { formulas("phi, a", {"phi", "a", "0", rotation}); }, text);
  };
  const std::string where = "rotation of tool \"crank\" ";
  refuse("phi", where + "\"phi\": no axis, expected such as \"z:phi x:theta z:psi\"");
  refuse("w:phi", where + "\"w:phi\": unknown axis \"w\", expected");
  refuse(":phi", "unknown axis \"\"");
  refuse("z:phi * x:a", "rotation about z of tool \"crank\" \"phi *\": the formula ends too early");
  refuse("z:phi up:a", "unknown axis \"up\"");
  refuse("z: x:a", "rotation about z of tool \"crank\" \"\": the formula is empty");
  refuse("[0 0]:phi", "axis [0 0] of 2 numbers");
  refuse("[0 0 zero]:phi", "axis [0 0 zero] of length 0");
  refuse("[0 0 phi]:phi",
         "axis [0 0 phi] of rotation of tool \"crank\" \"phi\": at character 1: unknown name");
  refuse("z:phi 1 1 0]:a", "unknown axis \"0]\"");
  refuse("vector: phi, a", where + "\"vector: phi, a\": a vector of 2 numbers, expected such as");
  refuse("vector: phi, , a", "vector b of tool \"crank\" \"\": the formula is empty");
  refuse("quaternion: phi, a, atan2(1, a)", "a quaternion of 3 numbers");
  refuse("z:phi x:b", "rotation about x of tool \"crank\" \"b\": at character 1: unknown name \"b\"");
  expect_invalid(
      [] {
        formulas("phi, a", {"0", "0", "0", "z:phi y:zero*a"});
      },
      "coordinate \"a\" moves nothing: x = \"0\", y = \"0\", z = \"0\", rotation about z = \"phi\", rotation "
      "about y = \"zero*a\"");
}

TEST(CoordinatesInSpace, PosesThatAreRefused) {
  const auto quaternion = formulas("w, a", {"0", "0", "0", "quaternion: w, a, w*a, 0"});
  EXPECT_THROW(quaternion->pose(vector_of({0, 0})), FormulaDomainError);
  expect_invalid(
      [&] {
        quaternion->pose(vector_of({0, 0}));
      },
      "rotation of tool \"crank\": the quaternion has the length 0");
  expect_invalid([&] { quaternion->pose(vector_of({0})); }, "size of q = 1, expected 2 (w, a)");
  expect_invalid(
      [] {
        CartesianInSpace().pose(vector_of({0, 0, 0}));
      },
      "CartesianInSpace::pose: size of q = 3, expected 6 (x, y, z, spinx, spiny, spinz)");
  expect_invalid(
      [] {
        PolarInSpace().pose(vector_of({0, 0, std::nan(""), 0}));
      },
      "PolarInSpace::pose: z = nan");
  expect_invalid([] { Screw({}, 1).pose(vector_of({})); }, "Screw::pose: size of q = 0, expected 1 (phi)");
  expect_invalid([] { Screw({}, INFINITY); }, "Screw: lead = inf, expected a finite number");
  expect_invalid(
      [] {
        formulas("s", {"s", "0", "0", "z:1/s"})->pose(vector_of({0}));
      },
      "rotation about z of tool \"crank\" \"1/s\": 1/0 is no finite real number, at s = 0");
}
