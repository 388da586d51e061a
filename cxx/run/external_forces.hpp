#pragma once
// External forces on the nodes, weight and pressure say (METHOD.md 3.15).
#include "base/error.hpp"
#include "run/nodal_values.hpp"

namespace burnish {

template <int Dim> class ExternalForces {
public:
  /// @param body must outlive it
  explicit ExternalForces(const BodyView<Dim>& body) : m_body(body) {}

  /// Forces of the steps to come, until others are given.
  /// @param forces num_dofs, on the body; on given components they go to the supports [force]
  /// @throws std::invalid_argument for another size, none included, or NaN (names node and place)
  void prescribe(const Eigen::VectorXd& forces) {
    require_nodal(m_body, forces, "contact.external", [](Eigen::Index) { return std::string(); });
    m_given = forces;
    m_lost = false;
  }
  /// A step begins: what was given last acts in it.
  /// @throws std::invalid_argument for forces that acted on another mesh of the body, with none given since
  void begin() {
    if (m_lost)
      fail("contact.external",
           "the forces are those of the mesh before, expected others on the new one: give "
           "them in program, zeros where none act");
    m_acting = m_given;
  }
  bool act() const { return m_acting.size() > 0 && !m_acting.isZero(0); }
  /// Of the step under way, or of the last one; empty: none.
  const Eigen::VectorXd& acting() const { return m_acting; }
  /// Whether forces acted on another mesh of the body and none have been given since.
  bool lost() const { return m_lost; }
  void restore(const Eigen::VectorXd& acting, bool lost) {
    m_given = m_acting = acting;
    m_lost = lost;
  }
  /// Takes them off the internal nodal force.
  void take_off(Eigen::VectorXd& R) const {
    if (m_acting.size() > 0) R -= m_acting;
  }

private:
  const BodyView<Dim>& m_body;
  Eigen::VectorXd m_given, m_acting;
  bool m_lost = false;
};

} // namespace burnish
