// The condensed system with its given unknowns, and its lower half (METHOD.md 3.7).
#include "base/error.hpp"
#include "contact/condensation.hpp"
#include "contact/coupling.hpp"
#include "contact/tied_edges.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

// The geometric terms and drives in the columns of coordinates under motion are known: they go to the right-hand side.
// The rest of those columns is there already (m_known_increment).
template <int Dim> void Condensation<Dim>::move_geometric_columns(const CondensedProblem<Dim>& problem) {
  const PrescribedValues& prescribed = problem.end;
  const int ndof = static_cast<int>(m_body.X.size());
  for (const auto& node : m_nodes)
    for (Eigen::Index k = 0; k < node.geo_sq.cols(); ++k) {
      const int q = node.at[static_cast<std::size_t>(k)];
      if (!prescribed.is_motion[q]) continue;
      const double dq = prescribed.value[q] - m_q[q];
      for (Eigen::Index l = 0; l < node.geo_qq.rows(); ++l)
        m_full.rhs[ndof + node.at[static_cast<std::size_t>(l)]] -= dq * node.geo_qq(l, k);
      if (node.sliding)
        m_full.rhs.template segment<Dim - 1>(Dim * m_model.candidates[node.candidate]) -=
            dq * node.geo_sq.col(k);
      for (const TiedRow<Dim>& tied : node.ties)
        m_full.rhs.template segment<Dim - 1>(Dim * m_model.candidates[tied.end]) -= dq * tied.geo_sq.col(k);
    }
  for (Eigen::Index k = 0; k < m_drive.slope.cols(); ++k)
    if (prescribed.is_motion[k])
      m_full.rhs.segment(ndof, m_drive.slope.rows()) += (prescribed.value[k] - m_q[k]) * m_drive.slope.col(k);
}

// Given unknowns: zero row and column, `scale` on the diagonal.
template <int Dim> void Condensation<Dim>::set_given(const CondensedProblem<Dim>& problem) {
  const NodeBlockMatrix<Dim>& K = problem.K;
  double scale = 0;
  for (int m = 0; m < K.num_nodes; ++m) scale = std::max(scale, std::abs(*K.block(K.find(m, m))));
  const int ndof = static_cast<int>(m_body.X.size());
  m_given.assign(m_full.n, 0);
  Eigen::VectorXd given = Eigen::VectorXd::Zero(m_full.n);
  for (int d = 0; d < ndof; ++d) m_given[d] = m_body.fixed[d];
  for (const auto& node : m_nodes)
    for (int c = 0; c < Dim; ++c) // the slips of a guided node stand where its displacements would
      m_given[Dim * m_model.candidates[node.candidate] + c] = c >= (node.sliding ? Dim - 1 : 0);
  for (int k = 0; k < m_model.num_coordinates(); ++k)
    if (m_model.coupling_of(k))
      m_given[ndof + k] = 1;
    else if (problem.end.is_motion[k]) {
      m_given[ndof + k] = 1;
      given[ndof + k] = problem.end.value[k] - m_q[k];
    }
  for (int row = 0; row < m_full.n; ++row)
    for (int k = m_full.row_start[row]; k < m_full.row_start[row + 1]; ++k) {
      const int column = m_full.col[k];
      if (m_given[row] || m_given[column]) m_full.value[k] = row == column ? scale : 0;
    }
  for (int row = 0; row < m_full.n; ++row)
    if (m_given[row]) m_full.rhs[row] = scale * given[row];
}

// What was asked for must exist; m_drive is that of this system.
template <int Dim> void Condensation<Dim>::require_form(const CondensedProblem<Dim>& problem) const {
  const bool consistent = problem.tangent == FrictionTangent::CONSISTENT;
  if (problem.right == RightHandSide::RATES && !consistent)
    fail("condense", "pure rates are solved once and need the consistent tangent of friction");
  if (!problem.half) return;
  if (!m_model.symmetric() && consistent)
    fail("condense",
         "symmetric storage needs a contact without friction, or one with frictiontangent=\"lagged\"");
  if (problem.terms == GeometricTerms::ARTICLE) fail("condense", "the article's terms are not symmetric");
  require_symmetric_drive(m_model, problem.end, m_drive);
}

template <int Dim> void Condensation<Dim>::keep_lower() {
  m_half.n = m_full.n;
  m_half.half = true;
  m_half.row_start.assign(1, 0);
  m_half.col.clear();
  m_half.value.clear();
  for (int row = 0; row < m_full.n; ++row) {
    for (int k = m_full.row_start[row]; k < m_full.row_start[row + 1] && m_full.col[k] <= row; ++k) {
      m_half.col.push_back(m_full.col[k]);
      m_half.value.push_back(m_full.value[k]);
    }
    m_half.row_start.push_back(static_cast<int>(m_half.col.size()));
  }
  m_half.rhs = m_full.rhs;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template void Condensation<Dim>::move_geometric_columns(const CondensedProblem<Dim>&);                     \
  template void Condensation<Dim>::set_given(const CondensedProblem<Dim>&);                                  \
  template void Condensation<Dim>::require_form(const CondensedProblem<Dim>&) const;                         \
  template void Condensation<Dim>::keep_lower();
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
