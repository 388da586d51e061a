// At every accepted step, the nodal contact forces balance what the program applies to the tool,
//   sum_n X_k . F_n = Q_k,
// to the run's residual tolerance; with implicit and with event stepping, at 1e-4 (the default) and at 1e-8.
#include "support/rolling.hpp"
#include <iostream>

using namespace burnish;
using namespace burnish::test;

namespace {

/// Watches a run of the rolling example; sums up contact forces without the core's own balance.
class Resultants {
public:
  Resultants(Rolling& rolling, double tolerance) : m_rolling(rolling), m_tolerance(tolerance) {}
  /// @param t end of the accepted step
  void check(double t) {
    const Vector<3> force = sum_forces();
    m_largest_load = std::max(m_largest_load, m_load);
    const double allowed = m_tolerance * m_largest_load;
    expect(std::abs(force[0] + m_rolling.force * t), allowed, "Q_r", t);
    expect(std::abs(force[2] - m_rolling.moment * t) / 15e-3, allowed, "Q_theta / R", t);
    const Vector<3> told = m_rolling.scene.tool->generalized_force();
    // the nodes lie on the tool but for the square of the last offset, below the gap tolerance
    const double offset = std::max(1e-9, 1e-3 * m_tolerance);
    EXPECT_LE((told - force).norm(), offset * force.norm()) << "the force that the tool reports";
    ++m_steps;
  }
  double worst() const { return m_worst; } ///< largest error over the allowed one
  int steps() const { return m_steps; }

private:
  /// In the step that ended: a node that touches now was free, one that leaves now was in contact.
  static bool pressed(NodeState now) {
    return now == NodeState::SLIDING || now == NodeState::STICKING || now == NodeState::LEAVING;
  }
  /// X_r = e(phi), X_phi = r e'(phi) and X_theta = (x - center) turned, written down from METHOD.md 2.3.
  Vector<3> sum_forces() {
    const auto& contact = m_rolling.scene.contact();
    const Eigen::VectorXd q = m_rolling.scene.tool->q();
    const Vector<2> e = plane_direction(q[1]);
    Vector<3> sum = Vector<3>::Zero();
    m_load = 0;
    for (std::size_t i = 0; i < contact.setup().candidates().size(); ++i) {
      if (!pressed(contact.accepted().contact.nodes[i].state)) continue;
      const int node = contact.setup().candidates()[i];
      const Vector<2> F = contact.accepted().R.segment<2>(2 * node);
      const Vector<2> x = contact.setup().body().position(m_rolling.scene.u, node); // METHOD.md 3.18
      sum += Vector<3>(e.dot(F), q[0] * left_of(e).dot(F), left_of(x - q[0] * e).dot(F));
      m_load += F.norm();
    }
    return sum;
  }
  void expect(double error, double allowed, const char* what, double t) {
    m_worst = std::max(m_worst, error / allowed);
    EXPECT_LE(error, allowed) << what << " at t = " << t;
  }

  Rolling& m_rolling;
  double m_tolerance, m_load = 0, m_largest_load = 0, m_worst = 0;
  int m_steps = 0;
};

void check_resultants(Scheme scheme, double tolerance) {
  IterationOptions options;
  options.tolerance = tolerance;
  Rolling rolling(24, 5, options);
  Resultants resultants(rolling, tolerance);
  double t_end_of_step = 0;
  const ProgramAt program = [&, set = rolling.program()](double t) { set(t_end_of_step = t); };
  StepperOptions stepping;
  stepping.scheme = scheme;
  Stepper<2> stepper(rolling.scene.contact(), rolling.scene.body, rolling.scene.diagnosis,
                     Rolling::control(1, 0.02), stepping);
  const Task end = run(rolling.scene, stepper, program, [&] { resultants.check(t_end_of_step); });
  ASSERT_EQ(end, Task::FINISHED) << stepper.reason();
  EXPECT_EQ(resultants.steps(), stepper.counts().scheme.pieces);
  if (scheme == Scheme::IMPLICIT) {
    EXPECT_EQ(resultants.steps(), stepper.counts().steps);
  }
  EXPECT_GE(resultants.steps(), 50);
  EXPECT_GE(resultants.worst(), 1e-6) << "no run of this length is exact: the test would show nothing";
  std::cout << "resultants: tolerance " << tolerance << ", " << resultants.steps()
            << " steps, largest error / allowed " << resultants.worst() << "\n";
}

} // namespace

TEST(Resultants, Implicit) { check_resultants(Scheme::IMPLICIT, 1e-4); }
TEST(Resultants, ImplicitTight) { check_resultants(Scheme::IMPLICIT, 1e-8); }
TEST(Resultants, Event) { check_resultants(Scheme::EVENT, 1e-4); }
TEST(Resultants, EventTight) { check_resultants(Scheme::EVENT, 1e-8); }
