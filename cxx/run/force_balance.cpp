#include "run/force_balance.hpp"
#include "base/error.hpp"
#include <algorithm>

namespace burnish {

template <int Dim>
ForceBalance<Dim>::ForceBalance(const ContactRun<Dim>& run, const Vector<Dim>& about)
    : m_run(run), m_about(about) {
  for (int c = 0; c < Dim; ++c)
    require(std::isfinite(about[c]), "contact", "point of the moments", about[c], "finite coordinates");
}

template <int Dim>
Resultant<Dim> ForceBalance<Dim>::sum(const Eigen::VectorXd& f, const Vector<Dim>& about,
                                      const std::vector<int>& nodes) const {
  const Resultant<Dim> all = resultant(m_run.setup().body(), m_run.accepted().u, f, about, nodes);
  return m_run.setup().mesh().axisymmetric ? of_ring(all) : all;
}

template <int Dim> Resultant<Dim> ForceBalance<Dim>::reaction(const std::vector<int>& nodes) const {
  const auto& state = m_run.accepted();
  return sum(support_forces(m_run.setup().model(), m_run.setup().body(), state.contact, state.R), m_about,
             nodes);
}

template <int Dim> Resultant<Dim> ForceBalance<Dim>::contact_force(int tool) const {
  const auto& state = m_run.accepted();
  return sum(contact_forces(m_run.setup().model(), state.contact, state.R, tool), m_about);
}

template <int Dim> Resultant<Dim> ForceBalance<Dim>::external_force(const Eigen::VectorXd& internal) const {
  const Eigen::VectorXd& R = m_run.accepted().R;
  require(internal.size() == R.size(), "contact", "size of the internal force", internal.size(),
          "number of dofs");
  return sum(internal - R - hold_forces(), m_about);
}

template <int Dim> Eigen::VectorXd ForceBalance<Dim>::hold_forces() const {
  const Hold<Dim>& hold = m_run.loads().hold;
  return hold.force(m_run.accepted().u, hold.state().factor);
}

template <int Dim> Resultant<Dim> ForceBalance<Dim>::hold_force() const {
  return sum(hold_forces(), m_about);
}

template <int Dim> double ForceBalance<Dim>::imbalance(const Eigen::VectorXd& internal) const {
  const BodyView<Dim>& body = m_run.setup().body();
  const auto& state = m_run.accepted();
  const int nodes = static_cast<int>(body.X.size()) / Dim;
  Vector<Dim> middle = Vector<Dim>::Zero();
  for (int a = 0; a < nodes; ++a) middle += body.position(state.u, a) / nodes;
  double size = 0;
  for (int a = 0; a < nodes; ++a) size = std::max(size, (body.position(state.u, a) - middle).norm());
  const ForceBalance centered(m_run, middle);
  Resultant<Dim> total = centered.reaction();
  total += centered.contact_force(-1);
  total += centered.external_force(internal);
  total += centered.hold_force();
  const double load = std::max(m_run.iteration().balance().memory().scale, state.R.cwiseAbs().maxCoeff());
  if (!(load > 0)) return 0;
  return std::max(total.force.cwiseAbs().maxCoeff(), total.moment.cwiseAbs().maxCoeff() / size) / load;
}

template class ForceBalance<2>;
template class ForceBalance<3>;

} // namespace burnish
