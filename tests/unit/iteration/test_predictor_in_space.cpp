// The last increment is carried along with a tool that turns about any axis of space.
#include "iteration/predictor.hpp"
#include "kinematics/polar_in_space.hpp"
#include "support/space_scene.hpp"

using namespace burnish;
using namespace burnish::test;

// Away from the axis, e (I - a a')(X - c): it looks the same to what turns about the axis. The increment of a place comes from
// behind it by the turn of this step, and turns by the mean of both steps' turns.
TEST(PredictorInSpace, IncrementTurnsAboutTheAxis) {
  const AxisFrame axis = axis_frame("test", Vector<3>(0.2, -3, 1), {1, 2, -1});
  const Vector<3> a = axis.base.col(2);
  SpaceScene scene({6, 6, 4}, sphere(0.5), std::make_shared<PolarInSpace>(axis), 0.3);
  const double before = 0.02, now = 0.06;
  scene.place(numbers({50, 1.6, 0, 0})); // clear of the block
  scene.start();
  const ContactSetup<3>& setup = *scene.setup;
  ContactState<3> state;
  state.nodes.resize(setup.candidates().size());
  state.q = numbers({50, 1.6, 0, 0});
  StepHistory<3> history;
  history.dt = 1;
  history.own = false;
  history.dq = numbers({0, before, 0, 0});
  history.q_old = state.q - history.dq;
  history.du.resize(scene.u.size());
  const auto from_axis = [&](const Vector<3>& x) {
    return Vector<3>((Tensor<3>::Identity() - a * a.transpose()) * (x - axis.point));
  };
  for (int n = 0; n < scene.mesh.num_nodes; ++n)
    history.du.segment<3>(3 * n) = 1e-7 * from_axis(scene.mesh.node(n));
  const auto result =
      Predictor<3>(setup.mesh(), setup.model(), setup.body())
          .predict({{1, 1, 1, 1}, numbers({50, 1.6 + now, 0, 0})}, state, scene.u, history, 1, {});
  int carried = 0;
  const Tensor<3> back = turn_about(a, -now), turn = turn_about(a, 0.5 * (before + now));
  for (int n = 0; n < scene.mesh.num_nodes; ++n) {
    const Vector<3> X = scene.mesh.node(n), behind = axis.point + back * (X - axis.point);
    const bool inside =
        (behind.array().abs() < Eigen::Array3d(1, 1, 1)).all() && behind[2] < 0 && behind[2] > -1;
    if (!inside || setup.body().fixed[3 * n]) continue;
    ++carried;
    const Vector<3> expected = turn * Vector<3>(1e-7 * from_axis(behind));
    EXPECT_LE((result.u.segment<3>(3 * n) - expected).norm(), 1e-12) << "node " << n; // of 3e-7
  }
  EXPECT_GE(carried, 40);
}
