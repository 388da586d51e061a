#include "stepping/supports.hpp"
#include "base/error.hpp"
#include "stepping/program_checks.hpp"
#include <cmath>

namespace burnish {

template <int Dim> void Supports<Dim>::prescribe(const Eigen::VectorXd& values) {
  const char* where = "contact.supportdisplacement";
  require(values.size() == m_body.X.size(), where, "size of the values", values.size(),
          (std::to_string(m_body.X.size()) + ", one per degree of freedom").c_str());
  for (Eigen::Index d = 0; d < values.size(); ++d) {
    const auto say = [&](const char* what) {
      std::ostringstream text;
      text << "value " << values[d] << " at component " << d % Dim << " of node " << d / Dim << " at "
           << m_body.X.template segment<Dim>(d - d % Dim).transpose().format(PLACE_FORMAT) << ": " << what;
      fail(where, text.str());
    };
    if (!std::isfinite(values[d])) say("expected a finite number");
    if (values[d] != 0 && !m_body.fixed[d]) say("this component is free, expected 0; see fixed=");
  }
  m_values = values;
}

template <int Dim> void Supports<Dim>::apply(Eigen::VectorXd& u) const {
  for (Eigen::Index d = 0; d < m_values.size(); ++d)
    if (m_body.fixed[d]) u[d] = m_values[d];
}

template <int Dim> bool Supports<Dim>::move(const Eigen::VectorXd& u) const {
  for (Eigen::Index d = 0; d < m_values.size(); ++d)
    if (m_body.fixed[d] && u[d] != m_values[d]) return true;
  return false;
}

template class Supports<2>;
template class Supports<3>;

} // namespace burnish
