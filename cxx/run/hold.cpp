#include "run/hold.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace burnish {
template <int Dim> void Hold<Dim>::set(double stiffness, double until) {
  require(std::isfinite(stiffness) && stiffness > 0, "contact.hold", "stiffness", stiffness,
          "a finite number > 0");
  require(std::isfinite(until), "contact.hold", "until", until, "a finite number");
  m_state = HoldState{};
  m_state.stiffness = stiffness;
  m_state.until = until;
}

template <int Dim> void Hold<Dim>::begin(double t, const Eigen::VectorXd& u) {
  if (m_state.stiffness == 0 || m_state.origin.size() > 0) return;
  require(m_state.until > t, "contact.hold", "until", m_state.until,
          ("later than the start of the step, " + std::to_string(t)).c_str());
  m_state.from = t;
  m_state.origin = u;
}

template <int Dim> double Hold<Dim>::factor(double t) const {
  if (m_state.stiffness == 0 || m_state.origin.size() == 0) return 0;
  const double left = (m_state.until - t) / (m_state.until - m_state.from);
  constexpr double rounding = 1e-9; // of the instant at which a step ends
  return left > rounding ? std::min(left, 1.) : 0;
}

template <int Dim> Eigen::VectorXd Hold<Dim>::force(const Eigen::VectorXd& u, double factor) const {
  if (!(factor > 0)) return Eigen::VectorXd::Zero(u.size());
  return m_springs.force(m_state.stiffness * factor, u, m_state.origin);
}

template <int Dim> void Hold<Dim>::add_force(const Eigen::VectorXd& u, double t, Eigen::VectorXd& R) const {
  if (acts(t)) R -= force(u, factor(t));
}

template <int Dim> void Hold<Dim>::add_stiffness(double t, NodeBlockMatrix<Dim>& K) const {
  if (acts(t)) m_springs.add_stiffness(m_state.stiffness * factor(t), K);
}

template <int Dim> double Hold<Dim>::carried(const Eigen::VectorXd& u, double t) const {
  return acts(t) ? sum_of_norms<Dim>(force(u, factor(t))) : 0;
}

template <int Dim> void Hold<Dim>::accept(const Eigen::VectorXd& u, double t, double load) {
  m_state.factor = factor(t);
  if (!acts(t)) return;
  const double force = carried(u, t);
  m_state.share = force > 0 ? force / std::max(load, force) : 0;
}

template <int Dim> std::string Hold<Dim>::warning() const {
  if (m_state.stiffness == 0 || m_state.share <= NOTICED) return "";
  std::ostringstream text;
  if (m_state.factor > 0)
    text << "the hold, which ends at t = " << m_state.until << ", carries ";
  else
    text << "when the hold ended at t = " << m_state.until << " it still carried ";
  text << m_state.share << " of the load: tools and supports do not hold the workpiece alone";
  return text.str();
}

template class Hold<2>;
template class Hold<3>;

} // namespace burnish
