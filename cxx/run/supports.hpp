#pragma once
// The motion of the supports: values of the given components at the end of a step (METHOD.md 3.15).
#include "contact/body_view.hpp"

namespace burnish {

template <int Dim> class Supports {
public:
  /// @param body must outlive it; its fixed dofs are the given components
  explicit Supports(const BodyView<Dim>& body) : m_body(body) {}

  /// Displacement of the given components at the end of the step to come, until another is prescribed.
  /// @param values num_dofs, from the reference place of the run's first mesh, 0 at free components [length]
  /// @throws std::invalid_argument for another size, NaN, or a value at a free component (names node and place)
  void prescribe(const Eigen::VectorXd& values);
  /// What was prescribed last; empty: nothing, the components stay where the caller's displacement has them.
  const Eigen::VectorXd& displacement() const { return m_values; }
  /// What the values were where the mesh of now began; empty: 0.
  const Eigen::VectorXd& origin() const { return m_origin; }
  void restore(const Eigen::VectorXd& values, const Eigen::VectorXd& origin) {
    m_values = values;
    m_origin = origin;
  }
  /// Puts values less origin into the given components of u.
  void apply(Eigen::VectorXd& u) const;
  /// Whether that would change u.
  bool move(const Eigen::VectorXd& u) const;

private:
  const BodyView<Dim>& m_body;
  double way(Eigen::Index d) const { return m_origin.size() > 0 ? m_values[d] - m_origin[d] : m_values[d]; }

  Eigen::VectorXd m_values, m_origin;
};

} // namespace burnish
