#include "contact/condensation.hpp"
#include "base/error.hpp"
#include "contact/coupling.hpp"
#include "contact/slip_direction.hpp"
#include <algorithm>

namespace burnish {

template <int Dim> double& Condensation<Dim>::at(int row, int column) {
  const auto first = m_full.col.begin() + m_full.row_start[row],
             last = m_full.col.begin() + m_full.row_start[row + 1];
  return m_full.value[static_cast<std::size_t>(std::lower_bound(first, last, column) - m_full.col.begin())];
}

// Superset pattern: every candidate's neighbors are coupled to all tool coordinates.
template <int Dim> void Condensation<Dim>::build_pattern(const NodeBlockMatrix<Dim>& K) {
  if (m_pattern_row_start == K.row_start && m_pattern_col == K.col) return;
  m_pattern_row_start = K.row_start;
  m_pattern_col = K.col;
  const int ndof = K.size(), nq = m_model.num_coordinates();
  std::vector<char> near(K.num_nodes, 0);
  for (const int c : m_model.candidates)
    for (int k = K.row_start[c]; k < K.row_start[c + 1]; ++k) near[K.col[k]] = 1;
  m_full = {};
  m_full.n = ndof + nq;
  m_full.row_start.push_back(0);
  const auto add_coordinates = [&] {
    for (int k = 0; k < nq; ++k) m_full.col.push_back(ndof + k);
  };
  for (int d = 0; d < ndof; ++d) {
    const int node = d / Dim;
    for (int k = K.row_start[node]; k < K.row_start[node + 1]; ++k)
      for (int c = 0; c < Dim; ++c) m_full.col.push_back(Dim * K.col[k] + c);
    if (near[node]) add_coordinates();
    m_full.row_start.push_back(static_cast<int>(m_full.col.size()));
  }
  for (int k = 0; k < nq; ++k) {
    for (int d = 0; d < ndof; ++d)
      if (near[d / Dim]) m_full.col.push_back(d);
    add_coordinates();
    m_full.row_start.push_back(static_cast<int>(m_full.col.size()));
  }
}

template <int Dim> void Condensation<Dim>::linearize(const CondensedProblem<Dim>& problem) {
  const ContactState<Dim>& state = problem.state;
  const Eigen::VectorXd& R = problem.R;
  const auto poses = m_model.poses(state.q);
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(m_model, state, poses, R);
  m_nodes.clear();
  m_contact_of.assign(m_body.X.size() / Dim, -1);
  m_known_increment = Eigen::VectorXd::Zero(m_body.X.size());
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    if (!in_contact(state.nodes[i].state)) continue;
    const int node = m_model.candidates[i];
    const Vector<Dim> Rn = R.template segment<Dim>(Dim * node);
    m_contact_of[node] = static_cast<int>(m_nodes.size());
    NodeCones<Dim> cones = cones_of(m_model, state, poses, deciding, static_cast<int>(i), problem.tangent);
    if (problem.tangent == FrictionTangent::CONSISTENT)
      begin_turn(m_model, BeginningSlips<Dim>{problem.by_friction, state, poses, deciding},
                 static_cast<int>(i), cones);
    m_nodes.push_back(
        linearize_node(m_model, state.nodes[i], static_cast<int>(i), poses, Rn, problem.terms, &cones));
    if (!m_model.couplings.empty()) eliminate_followers(m_model, state.q, problem.terms, m_nodes.back());
    const auto& linear = m_nodes.back();
    Vector<Dim> known = Vector<Dim>::Zero();
    if (problem.right == RightHandSide::TOTAL)
      known = offset_to(m_model, static_cast<int>(i), linear.point, m_body.position(problem.u, node));
    for (Eigen::Index k = 0; k < linear.x_q.cols(); ++k) {
      const int q = linear.at[static_cast<std::size_t>(k)];
      if (problem.end.is_motion[q]) known += (problem.end.value[q] - state.q[q]) * linear.x_q.col(k);
    }
    m_known_increment.template segment<Dim>(Dim * node) = known;
  }
}

template <int Dim> typename Condensation<Dim>::Map Condensation<Dim>::map_of(int node) const {
  Map map;
  map.node = m_contact_of[node] < 0 ? nullptr : &m_nodes[m_contact_of[node]];
  if (!map.node) {
    map.part[map.num++] = {node, Tensor<Dim>::Identity(), Tensor<Dim>::Identity()};
    return map;
  }
  const auto add = [&map](int of, const Tangents<Dim>& W, const Tangents<Dim>& A) {
    Part& part = map.part[map.num++];
    part = {of, Tensor<Dim>::Zero(), Tensor<Dim>::Zero()};
    part.W.template leftCols<Dim - 1>() = W;
    part.A.template leftCols<Dim - 1>() = A;
  };
  if (map.node->sliding) add(node, map.node->W, map.node->E);
  for (const TiedRow<Dim>& tied : map.node->ties) add(m_model.candidates[tied.end], tied.W, tied.A);
  return map;
}

template <int Dim> void Condensation<Dim>::add_blocks(const NodeBlockMatrix<Dim>& K) {
  using Block = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;
  const int ndof = K.size();
  std::fill(m_full.value.begin(), m_full.value.end(), 0.0);
  for (int m = 0; m < K.num_nodes; ++m) {
    const Map row = map_of(m);
    for (int k = K.row_start[m]; k < K.row_start[m + 1]; ++k) {
      const Map column = map_of(K.col[k]);
      const Eigen::Map<const Block> block(K.block(k));
      for (const Part& r : row) {
        const Tensor<Dim> WK = r.W.transpose() * block;
        for (const Part& c : column) {
          const Tensor<Dim> local = WK * c.A;
          const bool own = r.node == m && c.node == K.col[k]; // K's pattern comes first in each row
          for (int a = 0; a < Dim; ++a) {
            double* const first =
                own ? &m_full.value[m_full.row_start[Dim * m + a] + Dim * (k - K.row_start[m])]
                    : &at(Dim * r.node + a, Dim * c.node);
            for (int b = 0; b < Dim; ++b) first[b] += local(a, b);
          }
        }
        if (!column.node) continue;
        const PerCoordinate<Dim> q = WK * column.node->x_q;
        for (int a = 0; a < Dim; ++a)
          for (Eigen::Index l = 0; l < q.cols(); ++l)
            at(Dim * r.node + a, ndof + column.node->at[static_cast<std::size_t>(l)]) += q(a, l);
      }
      if (row.node) add_coordinate_rows(*row.node, row.node->x_q.transpose() * block, column);
    }
  }
}

// X_k' K in the rows of the coordinates, for one block of K.
template <int Dim>
void Condensation<Dim>::add_coordinate_rows(const NodeLinearization<Dim>& node, const Eigen::MatrixXd& qK,
                                            const Map& column) {
  const int ndof = static_cast<int>(m_body.X.size());
  for (Eigen::Index l = 0; l < qK.rows(); ++l) {
    const int r = ndof + node.at[static_cast<std::size_t>(l)];
    for (const Part& c : column) {
      const Eigen::RowVectorXd values = qK.row(l) * c.A;
      for (int b = 0; b < Dim; ++b) at(r, Dim * c.node + b) += values[b];
    }
    if (!column.node) continue;
    const Eigen::RowVectorXd qq = qK.row(l) * column.node->x_q;
    for (Eigen::Index j = 0; j < qq.size(); ++j)
      at(r, ndof + column.node->at[static_cast<std::size_t>(j)]) += qq[j];
  }
}

template <int Dim> void Condensation<Dim>::add_geometric_terms() {
  const int ndof = static_cast<int>(m_body.X.size());
  for (const auto& node : m_nodes) {
    const int row = Dim * m_model.candidates[node.candidate];
    const auto q = [&](Eigen::Index k) { return ndof + node.at[static_cast<std::size_t>(k)]; };
    for (Eigen::Index k = 0; k < node.geo_qq.rows(); ++k)
      for (Eigen::Index l = 0; l < node.geo_qq.cols(); ++l) at(q(k), q(l)) += node.geo_qq(k, l);
    for (int a = 0; node.sliding && a < Dim - 1; ++a) {
      for (int b = 0; b < Dim - 1; ++b) at(row + a, row + b) += node.geo_ss(a, b);
      for (Eigen::Index k = 0; k < node.geo_sq.cols(); ++k) {
        at(row + a, q(k)) += node.geo_sq(a, k);
        at(q(k), row + a) += node.geo_qs(a, k);
      }
    }
    for (const TiedRow<Dim>& tied : node.ties) {
      const int end = Dim * m_model.candidates[tied.end];
      for (int a = 0; a < Dim - 1; ++a) {
        for (std::size_t e = 0; e < node.ties.size(); ++e)
          for (int b = 0; b < Dim - 1; ++b)
            at(end + a, Dim * m_model.candidates[node.ties[e].end] + b) += tied.geo_ss[e](a, b);
        for (Eigen::Index k = 0; k < tied.geo_sq.cols(); ++k) {
          at(end + a, q(k)) += tied.geo_sq(a, k);
          at(q(k), end + a) += tied.geo_qs(a, k);
        }
      }
    }
  }
}

// Forces by formula: the stiffness of the drives.
template <int Dim> void Condensation<Dim>::add_drive() {
  const int ndof = static_cast<int>(m_body.X.size()), nq = static_cast<int>(m_drive.slope.rows());
  for (int k = 0; k < nq; ++k)
    for (int l = 0; l < nq; ++l)
      if (m_drive.slope(k, l) != 0) at(ndof + k, ndof + l) -= m_drive.slope(k, l);
}

template <int Dim> void Condensation<Dim>::set_right_hand_side(const CondensedProblem<Dim>& problem) {
  const NodeBlockMatrix<Dim>& K = problem.K;
  const ContactState<Dim>& state = problem.state;
  const Eigen::VectorXd& R = problem.R;
  const bool total = problem.right == RightHandSide::TOTAL;
  const int ndof = K.size(), nq = m_model.num_coordinates();
  Eigen::VectorXd force = -K.multiply(m_known_increment);
  if (total) force -= R;
  for (std::size_t i = 0; i < state.nodes.size() && !total; ++i) { // remaining reactions of released nodes
    const NodeState s = state.nodes[i].state;
    const int dof = Dim * m_model.candidates[i];
    if (s == NodeState::LEAVING || s == NodeState::RECEDING)
      force.template segment<Dim>(dof) -= R.template segment<Dim>(dof);
  }
  m_full.rhs = Eigen::VectorXd::Zero(m_full.n);
  for (int k = 0; k < nq; ++k) m_full.rhs[ndof + k] = m_drive.value[k] - (total ? 0 : problem.start.value[k]);
  for (int m = 0; m < K.num_nodes; ++m) {
    const Map row = map_of(m);
    const Vector<Dim> f = force.template segment<Dim>(Eigen::Index{Dim} * m);
    for (const Part& r : row)
      m_full.rhs.template segment<Dim>(Eigen::Index{Dim} * r.node) += r.W.transpose() * f;
    if (!row.node) continue;
    if (row.node->sliding && total)
      m_full.rhs.template segment<Dim - 1>(Eigen::Index{Dim} * m) -= row.node->constant;
    const Eigen::VectorXd generalized = row.node->x_q.transpose() * f;
    for (std::size_t k = 0; k < row.node->at.size(); ++k)
      m_full.rhs[ndof + row.node->at[k]] += generalized[static_cast<Eigen::Index>(k)];
  }
}

// What expand needs to predict the contact forces.
template <int Dim>
void Condensation<Dim>::keep_candidate_rows(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& R) {
  m_candidate_rows.clear();
  m_candidate_R.resize(Dim * static_cast<Eigen::Index>(m_model.candidates.size()));
  for (std::size_t i = 0; i < m_model.candidates.size(); ++i) {
    const int node = m_model.candidates[i];
    m_candidate_R.template segment<Dim>(Dim * i) = R.template segment<Dim>(Dim * node);
    m_candidate_rows.insert(m_candidate_rows.end(), K.block(K.row_start[node]),
                            K.block(K.row_start[node + 1]));
  }
}

template <int Dim> const CondensedSystem& Condensation<Dim>::condense(const CondensedProblem<Dim>& problem) {
  const NodeBlockMatrix<Dim>& K = problem.K;
  require(K.size() == m_body.X.size(), "condense", "size of K", K.size(),
          "number of dofs of the contact's space");
  m_q = problem.state.q;
  m_drive = driving_force(m_model, problem.end, m_q);
  require_form(problem);
  build_pattern(K);
  linearize(problem);
  m_full.value.assign(m_full.col.size(), 0.0);
  add_blocks(K);
  add_geometric_terms();
  add_drive();
  set_right_hand_side(problem);
  move_geometric_columns(problem);
  set_given(problem);
  keep_candidate_rows(K, problem.R);
  if (!problem.half) return m_full;
  keep_lower();
  return m_half;
}

template <int Dim>
typename Condensation<Dim>::Expansion Condensation<Dim>::expand(const Eigen::VectorXd& z) const {
  require(z.size() == m_full.n && m_full.n > 0, "expand", "size of the solution", z.size(),
          "the size of the last condensed matrix");
  if (!z.allFinite()) fail("expand", "the solution contains NaN or Inf");
  const Eigen::Index ndof = m_body.X.size();
  Expansion result{z.head(ndof), Eigen::MatrixXd::Zero(Dim - 1, m_model.candidates.size()),
                   z.tail(m_model.num_coordinates()), m_candidate_R};
  follow_increment(m_model, m_q, result.dq);
  for (const auto& node : m_nodes) {
    const int dof = Dim * m_model.candidates[node.candidate];
    Vector<Dim> du = m_known_increment.template segment<Dim>(dof);
    if (node.sliding) {
      result.slip.col(node.candidate) = z.template segment<Dim - 1>(dof);
      du += node.E * z.template segment<Dim - 1>(dof);
    }
    for (const TiedRow<Dim>& tied : node.ties)
      du += tied.A * z.template segment<Dim - 1>(Dim * m_model.candidates[tied.end]);
    for (Eigen::Index k = 0; k < node.x_q.cols(); ++k) {
      const int q = node.at[static_cast<std::size_t>(k)];
      if (!m_given[ndof + q]) du += node.x_q.col(k) * z[ndof + q];
    }
    result.du.template segment<Dim>(dof) = du;
  }
  using Block = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;
  const double* block = m_candidate_rows.data();
  for (std::size_t i = 0; i < m_model.candidates.size(); ++i) {
    const int node = m_model.candidates[i];
    for (int k = m_pattern_row_start[node]; k < m_pattern_row_start[node + 1]; ++k, block += Dim * Dim)
      result.F.template segment<Dim>(Dim * i) +=
          Eigen::Map<const Block>(block) * result.du.template segment<Dim>(Dim * m_pattern_col[k]);
  }
  return result;
}

template class Condensation<2>;
template class Condensation<3>;

} // namespace burnish
