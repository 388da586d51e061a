// Slips that turn by much within a step (ALGORITHMS.md 16.9).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr Bounds SLIP_TURN{0.25};     // angle that half of the friction has turned by in a step [rad]
constexpr double SLIP_REVERSED = 2.4; // more than this has gone back, through sticking [rad]
constexpr double SLIP_CARRIED = 0.1;  // friction of a tool over its load: below, no direction counts

// The friction of a tool in a step, by the angles that the slips of its nodes have turned by.
struct TurnedFriction {
  double load = 0, friction = 0; // of all nodes [force]
  std::vector<std::pair<double, double>>
      turns; // angle [rad], friction [force]; of nodes that slid before, too
};

template <int Dim> class TurningSlip final : public ObserverOf<TurningSlip<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_tool, m_direction)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    if (Dim == 2) return;
    std::vector<TurnedFriction> all(step.model().tools.size());
    for (const auto& node : step.touching) add(step.contact.nodes[node.candidate], node, all);
    for (int tool = 0; tool < static_cast<int>(all.size()); ++tool)
      judge(step, tool, half_angle(all[tool]), findings);
    const int candidates = static_cast<int>(step.contact.nodes.size());
    m_tool.assign(candidates, -1);
    m_direction = Eigen::VectorXd::Zero(Dim * candidates);
    for (int i = 0; i < candidates; ++i) {
      const ContactNode<Dim>& node = step.contact.nodes[i];
      if (node.state != NodeState::SLIDING || node.slip_direction.isZero()) continue;
      m_tool[i] = node.tool;
      m_direction.template segment<Dim>(Dim * i) = node.slip_direction;
    }
  }

private:
  void add(const ContactNode<Dim>& now, const CheckedNode<Dim>& node,
           std::vector<TurnedFriction>& all) const {
    TurnedFriction& sum = all[now.tool];
    const double friction = node.force.part.T.norm();
    sum.load += node.force.F.norm();
    sum.friction += friction;
    if (m_tool.empty() || m_tool[node.candidate] != now.tool || now.state != NodeState::SLIDING) return;
    const Vector<Dim> before = m_direction.template segment<Dim>(Dim * node.candidate);
    const double angle = std::acos(std::clamp(before.dot(now.slip_direction), -1., 1.));
    if (!now.slip_direction.isZero() && angle < SLIP_REVERSED) sum.turns.push_back({angle, friction});
  }
  // Angle that half of the friction has turned by at least [rad].
  static double half_angle(TurnedFriction& sum) {
    if (!(sum.friction > SLIP_CARRIED * sum.load)) return 0;
    std::sort(sum.turns.rbegin(), sum.turns.rend());
    double turned = 0;
    for (const auto& [angle, friction] : sum.turns)
      if ((turned += friction) > 0.5 * sum.friction) return angle;
    return 0;
  }
  static void judge(const AcceptedStep<Dim>& step, int tool, double angle, FindingList& findings) {
    Finding* finding = findings.beyond("turning slip", step.tool_name(tool), angle, SLIP_TURN, step.t);
    if (!finding) return;
    finding->text =
        sentence("half of the friction of tool \"", step.tool_name(tool), "\" or more turns by ", angle,
                 " rad in the step to t = ", step.t,
                 ": where its way is curved its directions are off by half of that; shorter steps");
  }
  std::vector<int> m_tool;     // that a candidate slid on in the last step, or -1
  Eigen::VectorXd m_direction; // of those slips, in the frame of the tool [-]
};

} // namespace

BURNISH_OBSERVER(turning_slip, TurningSlip)

} // namespace burnish
