#include "run/supports.hpp"
#include "run/nodal_values.hpp"

namespace burnish {

template <int Dim> void Supports<Dim>::prescribe(const Eigen::VectorXd& values) {
  require_nodal(m_body, values, "contact.supportdisplacement", [&](Eigen::Index d) -> std::string {
    return values[d] == 0 || m_body.fixed[d] ? "" : "this component is free, expected 0; see fixed=";
  });
  m_values = values;
}

template <int Dim> void Supports<Dim>::apply(Eigen::VectorXd& u) const {
  for (Eigen::Index d = 0; d < m_values.size(); ++d)
    if (m_body.fixed[d]) u[d] = way(d);
}

template <int Dim> bool Supports<Dim>::move(const Eigen::VectorXd& u) const {
  for (Eigen::Index d = 0; d < m_values.size(); ++d)
    if (m_body.fixed[d] && u[d] != way(d)) return true;
  return false;
}

template class Supports<2>;
template class Supports<3>;

} // namespace burnish
