#include "contact/contact_block.hpp"
#include <cmath>

namespace burnish {
namespace {

// Columns A and rows W' of the active nodes: slips and loose displacements first, coordinates after them.
template <int Dim> struct Columns {
  Eigen::MatrixXd A, W;
  std::vector<int> first; // per active node: its first column, -1 for a sticking or held one
  int num_nodal = 0;
};

template <int Dim>
Columns<Dim> assemble_columns(const ContactModel<Dim>& model,
                              const std::vector<NodeLinearization<Dim>>& nodes) {
  Columns<Dim> c;
  for (const auto& node : nodes) {
    const int count = node.loose ? Dim : node.sliding ? 1 : 0;
    c.first.push_back(count > 0 ? c.num_nodal : -1);
    c.num_nodal += count;
  }
  const Eigen::Index rows = Dim * static_cast<Eigen::Index>(nodes.size());
  c.A = c.W = Eigen::MatrixXd::Zero(rows, c.num_nodal + model.num_coordinates());
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto& node = nodes[a];
    const Eigen::Index row = Dim * static_cast<Eigen::Index>(a);
    if (node.loose) {
      c.A.template block<Dim, Dim>(row, c.first[a]).setIdentity();
      c.W.template block<Dim, Dim>(row, c.first[a]).setIdentity();
      continue;
    }
    if (node.sliding) {
      c.A.template block<Dim, 1>(row, c.first[a]) = node.point.x_s.col(0);
      c.W.template block<Dim, 1>(row, c.first[a]) = node.tau;
    }
    const Eigen::Index first = c.num_nodal + model.first[node.tool];
    c.A.block(row, first, Dim, node.x_q.cols()) = node.x_q;
    c.W.block(row, first, Dim, node.x_q.cols()) = node.x_q;
  }
  return c;
}

template <int Dim>
void add_geometric_terms(const ContactModel<Dim>& model, const std::vector<NodeLinearization<Dim>>& nodes,
                         const Columns<Dim>& c, Eigen::MatrixXd& matrix) {
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto& node = nodes[a];
    if (node.loose) continue;
    const Eigen::Index nq = node.x_q.cols(), first = c.num_nodal + model.first[node.tool];
    matrix.block(first, first, nq, nq) += node.geo_qq;
    if (!node.sliding) continue;
    const Eigen::Index s = c.first[a];
    matrix(s, s) += node.geo_ss;
    matrix.row(s).segment(first, nq) += node.geo_sq.transpose();
    matrix.col(s).segment(first, nq) += node.geo_qs;
  }
}

// Replaces rows of prescribed coordinates; returns the scale of every unknown.
void prescribe_motion(const Program& program, const Eigen::VectorXd& q, Eigen::Index first,
                      Eigen::MatrixXd& matrix, Eigen::VectorXd& rhs) {
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    if (!program.is_motion[k]) continue;
    const double pivot = std::max(std::abs(matrix(first + k, first + k)), 1e-300);
    matrix.row(first + k).setZero();
    matrix(first + k, first + k) = pivot;
    rhs[first + k] = pivot * (program.value[k] - q[k]);
  }
}

// Solves with rows and columns equilibrated; reports the coordinate that nothing resists.
bool solve_scaled(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs, Eigen::Index first,
                  Eigen::VectorXd& z, int& weakest) {
  const Eigen::Index n = matrix.rows();
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double largest = std::max(matrix.row(i).cwiseAbs().maxCoeff(), matrix.col(i).cwiseAbs().maxCoeff());
    const double d = std::abs(matrix(i, i));
    scale[i] = largest > 0 ? 1 / std::sqrt(std::max(d, 1e-12 * largest)) : 0;
    if (largest == 0) {
      weakest = i >= first ? static_cast<int>(i - first) : -1;
      return false;
    }
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(scale.asDiagonal() * matrix * scale.asDiagonal());
  if (!(lu.rcond() > 1e-15)) {
    Eigen::Index pivot;
    lu.matrixLU().diagonal().cwiseAbs().minCoeff(&pivot);
    weakest = pivot >= first ? static_cast<int>(pivot - first) : -1;
    return false;
  }
  z = scale.asDiagonal() * lu.solve(Eigen::VectorXd(scale.asDiagonal() * rhs));
  return z.allFinite();
}

} // namespace

template <int Dim>
ContactBlockSolution<Dim> solve_contact_block(const ContactModel<Dim>& model, const Program& program,
                                              const Eigen::VectorXd& q, const ContactBlockInput<Dim>& input) {
  const auto& nodes = *input.nodes;
  const Columns<Dim> c = assemble_columns(model, nodes);
  const Eigen::LLT<Eigen::MatrixXd> flexibility(*input.flexibility);
  ContactBlockSolution<Dim> solution;
  if (flexibility.info() != Eigen::Success) {
    solution.singular = true;
    return solution;
  }
  Eigen::MatrixXd SA = flexibility.solve(c.A);
  Eigen::VectorXd F0 = flexibility.solve(Eigen::VectorXd(input.offset - input.free_increment));
  if (input.shift.size() > 0) { // the body's own Schur complement is that of the shifted one less the shift
    SA -= input.shift.asDiagonal() * c.A;
    F0 -= input.shift.cwiseProduct(input.offset);
  }
  Eigen::MatrixXd matrix = c.W.transpose() * SA;
  Eigen::VectorXd rhs = -c.W.transpose() * F0;
  add_geometric_terms(model, nodes, c, matrix);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    if (nodes[a].sliding) rhs[c.first[a]] -= nodes[a].constant;
  for (int k = 0; k < model.num_coordinates(); ++k)
    if (!program.is_motion[k]) rhs[c.num_nodal + k] += program.value[k];
  prescribe_motion(program, q, c.num_nodal, matrix, rhs);

  Eigen::VectorXd z;
  if (!solve_scaled(matrix, rhs, c.num_nodal, z, solution.weakest_coordinate)) {
    solution.singular = true;
    return solution;
  }
  solution.ds = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t a = 0; a < nodes.size(); ++a)
    if (nodes[a].sliding) solution.ds[static_cast<Eigen::Index>(a)] = z[c.first[a]];
  solution.dq = z.tail(model.num_coordinates());
  solution.F = F0 + SA * z;
  solution.load = solution.F;
  if (input.shift.size() > 0) solution.load += input.shift.cwiseProduct(input.offset + c.A * z);
  return solution;
}

template ContactBlockSolution<2> solve_contact_block<2>(const ContactModel<2>&, const Program&,
                                                        const Eigen::VectorXd&, const ContactBlockInput<2>&);

} // namespace burnish
