// The verbs of a session for a step by a sparse solver of the caller's choice, and for pure rates.
#include "base/error.hpp"
#include "stepping/session.hpp"

namespace burnish {

// Program at the start of the step in the kinds (motion or force) of its end: for pure rates. A coordinate
// that was under motion has received a force.
template <int Dim> void Session<Dim>::match_old_program() {
  Program old{m_program.is_motion, m_accepted.q};
  const bool known = m_program_old.value.size() == m_program.value.size();
  for (std::size_t t = 0; t < m_tools.size(); ++t)
    for (int q = m_model.first[t]; q < m_model.first[t + 1]; ++q) {
      if (old.is_motion[q]) continue;
      const bool was_force = known && !m_program_old.is_motion[q];
      old.value[q] =
          was_force ? m_program_old.value[q] : m_tools[t]->generalized_force()[q - m_model.first[t]];
    }
  m_program_old = std::move(old);
}

// Start of a step of pure rates: the accepted state as it is.
template <int Dim> Prediction<Dim> Session<Dim>::resting(const Eigen::VectorXd& u) const {
  Prediction<Dim> start{u, m_accepted, {}};
  for (auto& node : start.state.nodes) {
    if (node.state == NodeState::TOUCHED) node.state = NodeState::STICKING;
    node.s_ref = node.s;
  }
  start.entry = start.state.nodes;
  return start;
}

template <int Dim>
const CondensedSystem& Session<Dim>::condense(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u,
                                              const Eigen::VectorXd& R, GeometricTerms terms,
                                              RightHandSide right, bool half) {
  if (!m_corrector) fail("contact.condense", "call begin first");
  require(u.size() == m_u.size() && R.size() == m_u.size(), "contact.condense", "size of the arrays",
          R.size(), "number of dofs");
  if (!R.allFinite()) fail("contact.condense", "the force array holds NaN or Inf");
  ++m_condensations;
  return m_condensation->condense(K, m_corrector->state(), m_program, m_program_old, u, R, terms, right,
                                  half);
}

template <int Dim> double Session<Dim>::expand(const Eigen::VectorXd& z, Eigen::VectorXd& u) {
  if (!m_corrector) fail("contact.expand", "call begin and condense first");
  require(u.size() == m_u.size(), "contact.expand", "size of u", u.size(), "number of dofs");
  const auto increment = m_condensation->expand(z);
  auto& state = m_corrector->state();
  u += increment.du;
  state.q += increment.dq;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    state.nodes[i].s[0] += increment.ds[static_cast<Eigen::Index>(i)];
  return increment.du.cwiseAbs().maxCoeff();
}

template <int Dim> void Session<Dim>::cut(Eigen::VectorXd& u, double fraction) {
  const char* where = "contact.cut";
  if (m_stepping != Stepping::RATES || !m_corrector)
    fail(where, "only a step of pure rates is linear: begin it with rates=true");
  require(fraction > 0 && fraction <= 1, where, "fraction", fraction, "0 < fraction <= 1");
  require(u.size() == m_u.size(), where, "size of u", u.size(), "number of dofs");
  auto& state = m_corrector->state();
  const auto shorten = [fraction](auto& end, const auto& start) {
    end = (start + fraction * (end - start)).eval();
  };
  shorten(u, m_u);
  shorten(state.q, m_accepted.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) shorten(state.nodes[i].s, m_accepted.nodes[i].s);
  shorten(m_program.value, m_program_old.value);
  m_dt *= fraction;
}

// members of this file; session.cpp instantiates the others
template void Session<2>::match_old_program();
template Prediction<2> Session<2>::resting(const Eigen::VectorXd&) const;
template const CondensedSystem& Session<2>::condense(const NodeBlockMatrix<2>&, const Eigen::VectorXd&,
                                                     const Eigen::VectorXd&, GeometricTerms, RightHandSide,
                                                     bool);
template double Session<2>::expand(const Eigen::VectorXd&, Eigen::VectorXd&);
template void Session<2>::cut(Eigen::VectorXd&, double);

} // namespace burnish
