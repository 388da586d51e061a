#pragma once
// The motion of the supports: values of the given components at the end of a step (METHOD.md 3.15).
#include "contact/body_view.hpp"

namespace burnish {

template <int Dim> class Supports {
public:
  /// @param body must outlive it; its fixed dofs are the given components
  explicit Supports(const BodyView<Dim>& body) : m_body(body) {}

  /// Displacement of the given components at the end of the step to come, until another is prescribed.
  /// @param values num_dofs, from the reference place, 0 at free components [length]
  /// @throws std::invalid_argument for another size, NaN, or a value at a free component (names node and place)
  void prescribe(const Eigen::VectorXd& values);
  /// What was prescribed last; empty: nothing, the components stay where the caller's displacement has them.
  const Eigen::VectorXd& displacement() const { return m_values; }
  void restore(const Eigen::VectorXd& values) { m_values = values; }
  /// Puts the values into the given components of u.
  void apply(Eigen::VectorXd& u) const;
  /// Whether that would change u.
  bool move(const Eigen::VectorXd& u) const;

private:
  const BodyView<Dim>& m_body;
  Eigen::VectorXd m_values;
};

} // namespace burnish
