// A coordinate under motion that turns its tool by half a radian and more in a step: degrees for radians (ALGORITHMS.md 16.7).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr Bounds TURN{0.5}; // of a tool in a step [rad]

template <int Dim> class TurningCheck final : public ObserverOf<TurningCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_q)
  void begin(const AcceptedStep<Dim>& step, FindingList&) override {
    if (m_q.size() == 0) m_q = step.contact.q;
  }
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    if (!step.prescribed) return;
    const auto poses = step.model().poses(step.contact.q);
    for (int k = 0; k < static_cast<int>(m_q.size()); ++k) {
      const int tool = step.model().tool_of(k);
      const double rate = poses[tool].R_q[k - step.model().first[tool]].norm() / std::sqrt(2.); // of a turn
      const double turn = rate * std::abs(step.contact.q[k] - m_q[k]);
      if (!step.prescribed->is_motion[k]) continue;
      Finding* finding = findings.beyond("turning", step.model().coordinate(k), turn, TURN, step.t);
      if (finding)
        finding->text = sentence(step.model().coordinate(k), " turns its tool by ", turn,
                                 " rad in the step to t = ", step.t, ": angles are in rad; in degrees?");
    }
    m_q = step.contact.q;
  }

private:
  Eigen::VectorXd m_q; // at the end of the last step
};

} // namespace

BURNISH_OBSERVER(turning_check, TurningCheck)

} // namespace burnish
