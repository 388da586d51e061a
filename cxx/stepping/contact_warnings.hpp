#pragma once
// What a scene asks for beyond what it can give: reported once each, the run goes on.
#include "base/findings.hpp"
#include "stepping/contact_setup.hpp"

namespace burnish {

template <int Dim> class ContactWarnings {
public:
  /// All findings of the run: those of this class, severity WARNING, and those of its self-checks (cxx/checks).
  FindingList& findings() { return m_findings; }
  const FindingList& findings() const { return m_findings; }
  const std::vector<Finding>& list() const { return m_findings.list(); }

  /// Tools curved tighter than the spacing of the candidates.
  void check_curvature(const ContactSetup<Dim>& setup);
  /// Nodes in contact with one tool that another tool reaches for too, and elements that touch two tools.
  void check_conflicts(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                       const Eigen::VectorXd& u, double t);
  /// Contact at an end of an open tool, beyond which the surface of the body goes on: a sharp edge.
  void check_ends(const ContactSetup<Dim>& setup, const ContactState<Dim>& state, const Eigen::VectorXd& u,
                  double t);
  /// @param subject of which one warning is enough: the first, or that of the largest excess
  void add(const std::string& subject, const std::string& text, double t = Finding::NONE,
           const std::vector<double>& place = {}, double excess = 0);

private:
  void check_elements(const ContactSetup<Dim>& setup, const std::vector<int>& tool_of_node,
                      const Eigen::VectorXd& u, double t);
  FindingList m_findings;
};

} // namespace burnish
