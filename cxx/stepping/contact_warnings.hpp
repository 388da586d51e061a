#pragma once
// What a scene asks for beyond what it can give: reported once each, the run goes on.
#include "stepping/contact_setup.hpp"

namespace burnish {

template <int Dim> class ContactWarnings {
public:
  struct Warning {
    std::string subject, text;
  };
  const std::vector<Warning>& list() const { return m_list; }

  /// Tools curved tighter than the spacing of the candidates.
  void check_curvature(const ContactSetup<Dim>& setup);
  /// Nodes in contact with one tool that another tool reaches for too, and elements that touch two tools.
  void check_conflicts(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                       const Eigen::VectorXd& u, double t);
  /// Contact at an end of an open tool, beyond which the surface of the body goes on: a sharp edge.
  void check_ends(const ContactSetup<Dim>& setup, const ContactState<Dim>& state, const Eigen::VectorXd& u,
                  double t);
  /// @param subject of which one warning is enough
  void add(const std::string& subject, const std::string& text);

private:
  void check_elements(const ContactSetup<Dim>& setup, const std::vector<int>& tool_of_node,
                      const Eigen::VectorXd& u, double t);
  std::vector<Warning> m_list;
};

} // namespace burnish
