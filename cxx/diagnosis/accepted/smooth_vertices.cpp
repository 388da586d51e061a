// Normal force at vertices of quadratic faces, which have no friction (ALGORITHMS.md 16.2).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr Bounds SMOOTH{0.1}; // normal force at vertices without friction over that of all nodes of the tool

// A tool where it has carried most so far.
struct SmoothShare {
  double load = 0, share = 0; // normal force of all nodes [force]; part of it at vertices [-]
  double t = 0;
  BURNISH_FIELDS(load, share, t)
};

template <int Dim> class SmoothVertices final : public ObserverOf<SmoothVertices<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_most)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    if (step.model().weightless.empty()) return;
    m_most.resize(step.model().tools.size());
    for (int tool = 0; tool < static_cast<int>(m_most.size()); ++tool) {
      if (step.model().laws[tool].frictionless()) continue;
      const SmoothShare now = share_of(step, tool);
      if (now.load > m_most[tool].load) m_most[tool] = now;
      if (step.last) judge(step, tool, findings);
    }
  }

private:
  static SmoothShare share_of(const AcceptedStep<Dim>& step, int tool) {
    double all = 0, smooth = 0;
    for (const auto& node : step.touching) {
      const ContactNode<Dim>& contact = step.contact.nodes[node.candidate];
      if (contact.tool != tool) continue;
      const double N = std::abs(node.force.part.N);
      all += N;
      if (step.model().is_weightless(node.candidate) && !contact.bears && !contact.has_ties) smooth += N;
    }
    return {all, all > 0 ? smooth / all : 0, step.t};
  }
  void judge(const AcceptedStep<Dim>& step, int tool, FindingList& findings) const {
    const SmoothShare& most = m_most[tool];
    Finding* finding = findings.beyond("smooth vertices", step.tool_name(tool), most.share, SMOOTH, most.t);
    if (!finding) return;
    finding->text = sentence(
        "vertices of the surface, which have no friction, take ", most.share,
        " of the normal force of tool \"", step.tool_name(tool), "\" where it carries most, t = ", most.t,
        ": its friction is less by that; refine the surface there, or tie edges (tied=true of rcContact)");
  }
  std::vector<SmoothShare> m_most; // per tool
};

} // namespace

BURNISH_OBSERVER(smooth_vertices, SmoothVertices)

} // namespace burnish
