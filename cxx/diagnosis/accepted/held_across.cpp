// Tools that slide along what supports hold: the friction there is not theirs (METHOD.md 3.7, ALGORITHMS.md 16.2).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr Bounds HELD_ACROSS{0.1}; // friction that is left out over the largest of the tool so far

template <int Dim> class HeldAcross final : public ObserverOf<HeldAcross<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_q, m_x, m_most)
  void begin(const AcceptedStep<Dim>& step, FindingList&) override { remember_places(step); }
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    if (step.model().constrained.empty()) return;
    const std::size_t tools = step.model().tools.size();
    m_most.resize(tools);
    std::vector<double> lost(tools, 0), friction(tools, 0);
    if (m_q.size() == step.contact.q.size() &&
        m_x.size() == Dim * static_cast<Eigen::Index>(step.contact.nodes.size())) {
      const std::vector<Pose<Dim>> before = step.model().poses(m_q);
      for (const auto& node : step.touching) {
        const int tool = step.contact.nodes[node.candidate].tool;
        const double left = left_out(step, node, before[tool]);
        lost[tool] += left;
        friction[tool] += node.force.part.T.norm() + left;
      }
    }
    for (std::size_t tool = 0; tool < tools; ++tool) {
      m_most[tool] = std::max(m_most[tool], friction[tool]);
      judge(step, static_cast<int>(tool), lost[tool], findings);
    }
    remember_places(step);
  }

private:
  void remember_places(const AcceptedStep<Dim>& step) {
    if (step.model().constrained.empty()) return;
    m_q = step.contact.q;
    const auto& candidates = step.model().candidates;
    m_x.resize(Dim * static_cast<Eigen::Index>(candidates.size()));
    for (std::size_t i = 0; i < candidates.size(); ++i)
      m_x.template segment<Dim>(Dim * static_cast<Eigen::Index>(i)) =
          step.body().position(step.u, candidates[i]);
  }
  // Friction across a node's given components, by its share of the slip of the step [force].
  double left_out(const AcceptedStep<Dim>& step, const CheckedNode<Dim>& node,
                  const Pose<Dim>& before) const {
    const ContactModel<Dim>& model = step.model();
    const int i = node.candidate;
    const ContactNode<Dim>& contact = step.contact.nodes[i];
    const TangentialLaw<Dim>& law = model.laws[contact.tool];
    if (!model.is_constrained(i) || law.frictionless() || model.is_weightless(i)) return 0;
    const Vector<Dim> old = model.tools[contact.tool]->point(before, contact.place).x;
    Vector<Dim> way = node.at.surface.x - old - (node.x - m_x.template segment<Dim>(Dim * i));
    for (int c = 0; c < Dim; ++c)
      if (!model.constrained[i][c]) way[c] = 0;
    const double across = (node.at.surface.E.transpose() * way).norm();
    const double along =
        (slip_space(model, i, node.at.surface) * slip_of(model, contact, node.at.surface.size)).norm();
    return across > 0 ? law.capacity(node.deciding) * across / std::hypot(across, along) : 0;
  }
  void judge(const AcceptedStep<Dim>& step, int tool, double lost, FindingList& findings) const {
    if (!(m_most[tool] > 0)) return;
    Finding* finding =
        findings.beyond("held across", step.tool_name(tool), lost / m_most[tool], HELD_ACROSS, step.t);
    if (!finding) return;
    finding->text = sentence(
        "tool \"", step.tool_name(tool), "\" slides, t = ", step.t,
        ", along components of nodes that are given, where it has no friction: its force "
        "lacks up to ",
        lost, ", ", lost / m_most[tool], " of its largest friction; hold the body where it is not touched");
  }
  Eigen::VectorXd m_q, m_x;   // of the last state: coordinates, places of the candidates [length]
  std::vector<double> m_most; // per tool: largest friction so far, with what is left out [force]
};

} // namespace

BURNISH_OBSERVER(held_across, HeldAcross)

} // namespace burnish
