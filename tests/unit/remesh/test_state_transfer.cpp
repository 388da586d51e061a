// The state of a workpiece on a mesh of its deformed body: Cauchy stress and back stress linear in space are carried over
// as they are, also where the body has turned; nothing is outside the yield surface, no plastic strain negative.
#include "material/j2/law.hpp"
#include "material/stress_algebra.hpp"
#include "remesh/state_transfer.hpp"
#include "support/structured_mesh.hpp"
#include "unit/finite_difference.hpp"
#include "workpiece/point_fields.hpp"
#include <cmath>

using namespace burnish;
using namespace burnish::test;

namespace {

const double ANGLE = 0.5, STRETCH = 1.2;

J2Parameters hardening_material(bool kinematic = false) {
  J2Parameters material = J2Parameters::from_shear(80, 0.3, 1, 2);
  if (kinematic) material.kinematic = {3, 0};
  return material;
}
Tensor<2> motion() { return plane_rotation(ANGLE) * Vector<2>(STRETCH, 1 / STRETCH).asDiagonal(); }
Discretization<2> moved_block(int nx, int ny) {
  return structured_mesh(nx, ny, 2, [](double a, double b) { return Vector<2>(motion() * Vector<2>(a, b)); })
      .space;
}

// The block stretched and turned, with fields of the present place at its points.
template <class Stresses, class Strain>
void deform(Workpiece<2>& body, const Stresses& cauchy, const Strain& ep, char plastic) {
  const Discretization<2>& mesh = body.discretization();
  WorkpieceState<2> state = body.state_old();
  const int internal = body.law().internal_variables().size();
  for (int a = 0; a < mesh.num_nodes; ++a)
    state.displacement.segment<2>(2 * a) = (motion() - Tensor<2>::Identity()) * mesh.node(a);
  for (int p = 0; p < mesh.num_points(); ++p) {
    const Vector<2> x = motion() * Eigen::Map<const Vector<2>>(&mesh.point[2 * p]);
    Eigen::Map<RowMajorTensor<2>>(&state.F[5 * p]) = motion();
    Eigen::Map<Stress<2>>(&state.stress[4 * p]) = cauchy(x); // J = 1
    state.internal[internal * p] = ep(x);
    if (internal > 1) Eigen::Map<Stress<2>>(&state.internal[internal * p + 1]) = 0.1 * deviator<2>(cauchy(x));
    state.plastic[p] = plastic;
  }
  state.dt = 0.25;
  body.set_state(state);
}
Stress<2> linear_stress(const Vector<2>& x) {
  return {0.1 + 0.2 * x[0], -0.1 * x[1], 0.05, 0.1 * x[0] - 0.2 * x[1]};
}
double linear_strain(const Vector<2>& x) { return 3 + x[0] - 0.5 * x[1]; }

struct Bodies {
  Workpiece<2> old, fresh;
  explicit Bodies(const J2Parameters& material)
      : old(block_mesh(6, 6, 2, 1, 1).space, j2_law<2>(material)),
        fresh(moved_block(7, 5), j2_law<2>(material)) {}
  TransferredState<2> carried() {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(fresh.discretization().num_dofs());
    return transferred(old, fresh, zero, {});
  }
};

} // namespace

TEST(StateTransfer, LinearFieldsOfThePresentPlaceAreExact) {
  Bodies bodies(hardening_material(true));
  deform(bodies.old, linear_stress, linear_strain, 0);
  const TransferredState<2> now = bodies.carried();
  const Discretization<2>& mesh = bodies.fresh.discretization();
  double error = 0;
  for (int p = 0; p < mesh.num_points(); ++p) {
    const Vector<2> x = Eigen::Map<const Vector<2>>(&mesh.point[2 * p]);
    const Stress<2> s = linear_stress(x);
    error = std::max(error, (Eigen::Map<const Stress<2>>(&now.workpiece.stress[4 * p]) - s).norm());
    error = std::max(error, std::abs(now.workpiece.internal[5 * p] - linear_strain(x)));
    error = std::max(
        error,
        (Eigen::Map<const Stress<2>>(&now.workpiece.internal[5 * p + 1]) - 0.1 * deviator<2>(s)).norm());
  }
  EXPECT_LT(error, 1e-11);
  EXPECT_EQ(now.workpiece.dt, 0.25);
  EXPECT_TRUE(now.workpiece.displacement.isZero(0));
  EXPECT_NO_THROW(bodies.fresh.set_state(now.workpiece));
}

TEST(StateTransfer, NothingIsOutsideTheYieldSurfaceAndFlowingPointsAreOnIt) {
  Bodies bodies(hardening_material());
  const auto strain = [](const Vector<2>& x) { return x[0] > 0.3 ? 0.5 * (x[0] - 0.3) : 0.; };
  const auto on_surface = [&](const Vector<2>& x) {
    const double q = 1 + 2 * strain(x), a = 4 * x[1];
    return Stress<2>(Stress<2>{q / std::sqrt(3.) * std::cos(a), -q / std::sqrt(3.) * std::cos(a), 0,
                               q / std::sqrt(3.) * std::sin(a)} +
                     Stress<2>{5, 5, 5, 0});
  };
  deform(bodies.old, on_surface, strain, 1);
  EXPECT_LT(largest_yield_distance(bodies.old), 1e-12);
  bodies.fresh.set_state(bodies.carried().workpiece);
  const Eigen::VectorXd distance = yield_distance_field(bodies.fresh);
  EXPECT_LT(distance.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GE(internal_field(bodies.fresh, "plastic_strain_eq").minCoeff(), 0);
}

TEST(StateTransfer, AnotherBodyAndSmallStrainsAreRefused) {
  Bodies bodies(hardening_material());
  deform(bodies.old, linear_stress, linear_strain, 0);
  Workpiece<2> larger(block_mesh(6, 6, 2, 1.3, 1.3).space, j2_law<2>(hardening_material()));
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(larger.discretization().num_dofs());
  expect_invalid([&] { transferred(bodies.old, larger, zero, {}); },
                 "remesh: the new mesh has the volume 1.69");
  J2Parameters small = hardening_material();
  small.rate = CorotationalRate::SMALL_STRAIN;
  Bodies linear(small);
  expect_invalid([&] { linear.carried(); }, "strain=\"small\"");
}

TEST(StateTransfer, IntegritiesStayWithinTheirRange) {
  Bodies bodies(hardening_material());
  bodies.old.track_integrity();
  WorkpieceState<2> state = bodies.old.state_old();
  for (std::size_t p = 0; p < state.integrity.size(); ++p)
    state.integrity[p] = state.integrity_goal[p] = bodies.old.discretization().point[2 * p] < 0.5 ? 0.2 : 1;
  bodies.old.set_state(state);
  deform(bodies.old, linear_stress, linear_strain, 0);
  const TransferredState<2> now = bodies.carried();
  for (const double w : now.workpiece.integrity) EXPECT_TRUE(w >= 0.2 && w <= 1) << w;
  EXPECT_NO_THROW(bodies.fresh.set_state(now.workpiece));
}
