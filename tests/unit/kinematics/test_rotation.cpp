// Rotations of numbers: closed forms, derivatives, small and large arguments, singular places.
#include "formula/formula.hpp"
#include "kinematics/rotation.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

Eigen::VectorXd numbers(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Tensor<3> turn(const Vector<3>& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

template <int Dim> void check(const Rotation<Dim>& rotation, const Eigen::VectorXd& a, double step = 1e-3) {
  const RotationValue<Dim> value = rotation.at(a);
  ASSERT_EQ(value.first.size(), std::size_t(rotation.size()));
  expect_close(Tensor<Dim>(value.R.transpose() * value.R), Tensor<Dim>::Identity(), 1, 4e-15, "orthonormal");
  EXPECT_GT(value.R.determinant(), 0);
  for (int i = 0; i < rotation.size(); ++i) {
    const auto at = [&](double t) {
      Eigen::VectorXd moved = a;
      moved[i] = t;
      return rotation.at(moved);
    };
    expect_close(value.first[i], finite_difference([&](double t) { return at(t).R; }, a[i], step), 1, 1e-10,
                 "R_i");
    for (int j = 0; j < rotation.size(); ++j)
      expect_close(value.second[i][j],
                   finite_difference([&](double t) { return at(t).first[j]; }, a[i], step), 1, 1e-9, "R_ij");
    const Tensor<Dim> spin = value.first[i] * value.R.transpose();
    expect_close(Tensor<Dim>(spin + spin.transpose()), Tensor<Dim>::Zero(), 1, 1e-14, "skew");
  }
}

const Vector<3> X = Vector<3>::UnitX(), Y = Vector<3>::UnitY(), Z = Vector<3>::UnitZ();

} // namespace

TEST(Rotation, DerivativesAgainstDifferences) {
  for (const double angle : {0., 0.3, -4.}) check(AngleRotation(), numbers({angle}));
  check(AxisRotations({Z}), numbers({0.7}));
  for (const auto& a : {numbers({0, 0, 0}), numbers({0.4, 1.2, -0.6}), numbers({3, 0, 5})})
    check(AxisRotations({Z, X, Z}), a);
  check(AxisRotations({Vector<3>(1, 2, -2), Vector<3>(0, 0.1, 0.1), X, Y}), numbers({0.4, 1.2, -0.6, 2}));
  for (const auto& a : {numbers({0, 0, 0}), numbers({1e-9, 0, 2e-9}), numbers({1e-3, -1e-3, 2e-3}),
                        numbers({0.05, 0.08, -0.03}), numbers({0.5, 0.8, -0.3}), numbers({0.6, 0.8, 1e-9}),
                        numbers({0.6, -0.8, 0.02}), numbers({2, -1, 1.5}), numbers({0, M_PI, 0}),
                        numbers({4, 4, 2}), numbers({2 * M_PI, 0, 0})})
    check(VectorRotation(), a);
  check(QuaternionRotation("here"), numbers({1, 0, 0, 0}));
  check(QuaternionRotation("here"), numbers({0.3, -0.5, 0.8, 1.1}));
  check(QuaternionRotation("here"), numbers({0, 0, 2, 0}));
}

TEST(Rotation, ClosedForms) {
  expect_close(AxisRotations({Z, X, Z}).at(numbers({0.4, 1.2, -0.6})).R,
               Tensor<3>(turn(Z, 0.4) * turn(X, 1.2) * turn(Z, -0.6)), 1, 1e-15, "Euler's angles");
  expect_close(AxisRotations({}).at(numbers({})).R, Tensor<3>::Identity(), 1, 0, "none");
  for (const double length : {1e-12, 0.03, 0.99999, 1.00001, 3., 7.}) {
    const Vector<3> axis = Vector<3>(1, -2, 2) / 3;
    expect_close(VectorRotation().at(length * axis).R, turn(axis, length), 1, 2e-15, "rotation vector");
  }
  expect_close(QuaternionRotation("here").at(3 * numbers({std::cos(0.4), 0, 0, std::sin(0.4)})).R,
               turn(Z, 0.8), 1, 1e-15, "quaternion");
}

// At zero a rotation vector is a spin: R_k = e_k^, R_kl the mean of both orders.
TEST(Rotation, SmallVectorsAreSpins) {
  const RotationValue<3> value = VectorRotation().at(numbers({0, 0, 0}));
  for (int i = 0; i < 3; ++i) {
    const Tensor<3> L = cross_matrix(Vector<3>::Unit(i));
    EXPECT_EQ(value.first[i], L);
    for (int j = 0; j < 3; ++j) {
      const Tensor<3> M = cross_matrix(Vector<3>::Unit(j));
      EXPECT_EQ(value.second[i][j], Tensor<3>((L * M + M * L) / 2));
    }
  }
}

// The series and the closed form meet at |vector| = 1.
TEST(Rotation, SeriesAndClosedFormAgree) {
  const Vector<3> axis = Vector<3>(2, 1, -2) / 3;
  const RotationValue<3> a = VectorRotation().at((1 - 1e-15) * axis),
                         b = VectorRotation().at((1 + 1e-15) * axis);
  for (int i = 0; i < 3; ++i) {
    expect_close(a.first[i], b.first[i], 1, 1e-14, "R_i");
    for (int j = 0; j < 3; ++j) expect_close(a.second[i][j], b.second[i][j], 1, 1e-14, "R_ij");
  }
}

TEST(Rotation, WhereNumbersMoveNothing) {
  const RotationValue<3> full = VectorRotation().at(numbers({2 * M_PI, 0, 0}));
  expect_close(full.R, Tensor<3>::Identity(), 1, 1e-15, "a full turn");
  expect_close(full.first[0], cross_matrix(X), 1, 1e-15, "about the vector");
  for (const int across : {1, 2}) expect_close(full.first[across], Tensor<3>::Zero(), 1, 1e-15, "across it");
  const Eigen::VectorXd Q = numbers({0.3, -0.5, 0.8, 1.1});
  const RotationValue<3> value = QuaternionRotation("here").at(Q);
  Tensor<3> along = Tensor<3>::Zero();
  for (int i = 0; i < 4; ++i) along += Q[i] * value.first[i];
  expect_close(along, Tensor<3>::Zero(), 1, 1e-15, "along a quaternion");
  expect_invalid(
      [] {
        QuaternionRotation("rotation of tool \"ball\"").at(numbers({0, 0, 0, 0}));
      },
      "rotation of tool \"ball\": the quaternion has the length 0, expected a direction");
  EXPECT_THROW(QuaternionRotation("here").at(numbers({0, 1e-200, 0, 0})), FormulaDomainError);
}
