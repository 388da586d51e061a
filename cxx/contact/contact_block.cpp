#include "contact/contact_block.hpp"
#include "base/decompositions.hpp"
#include "base/dense_kernels.hpp"
#include "contact/coupling.hpp"
#include "contact/driving_force.hpp"
#include <cmath>
#include <map>

namespace burnish {
namespace {

// Rounding leaves 2e-14 of a block that nothing resists in the plane; in space spins are resisted by as little.
template <int Dim> constexpr double LEAST_RCOND = Dim == 2 ? 1e-13 : 1e-14;
constexpr double LEAST_DIAGONAL =
    1e-12; // of the largest entry beside it: smaller ones do not set the scale of an unknown

// Columns A and rows W' of the nodes on their free components: slips and displacements of nodes that are not in
// contact first, coordinates after them.
template <int Dim> struct Columns {
  Eigen::MatrixXd A, W;
  std::vector<int> first;          // per node: its first column, -1 for one without
  std::map<int, int> of_candidate; // the same of those that slide
  int num_nodal = 0;
};

// Number of free components of each node.
std::vector<int> count_free(std::size_t nodes, int dim, const std::vector<int>& free) {
  std::vector<int> count(nodes, 0);
  for (const int component : free) ++count[component / dim];
  return count;
}

template <int Dim>
Columns<Dim> assemble_columns(const ContactModel<Dim>& model,
                              const std::vector<NodeLinearization<Dim>>& nodes,
                              const std::vector<int>& free) {
  Columns<Dim> c;
  const std::vector<int> count = count_free(nodes.size(), Dim, free);
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const int unknowns = !nodes[a].in_contact ? count[a] : nodes[a].sliding ? Dim - 1 : 0;
    c.first.push_back(unknowns > 0 ? c.num_nodal : -1);
    if (nodes[a].in_contact && nodes[a].sliding) c.of_candidate[nodes[a].candidate] = c.num_nodal;
    c.num_nodal += unknowns;
  }
  const auto rows = static_cast<Eigen::Index>(free.size());
  c.A = c.W = Eigen::MatrixXd::Zero(rows, c.num_nodal + model.num_coordinates());
  int displacement = 0; // of the node under way
  for (Eigen::Index r = 0; r < rows; ++r) {
    const auto a = static_cast<std::size_t>(free[r] / Dim);
    const int component = free[r] % Dim;
    const auto& node = nodes[a];
    if (r == 0 || free[r - 1] / Dim != free[r] / Dim) displacement = 0;
    if (!node.in_contact) {
      c.A(r, c.first[a] + displacement) = c.W(r, c.first[a] + displacement) = 1;
      ++displacement;
      continue;
    }
    if (node.sliding) {
      c.A.template block<1, Dim - 1>(r, c.first[a]) = node.E.row(component);
      c.W.template block<1, Dim - 1>(r, c.first[a]) = node.W.row(component);
    }
    for (const TiedRow<Dim>& tied : node.ties) {
      const int end = c.of_candidate.at(tied.end);
      c.A.template block<1, Dim - 1>(r, end) = tied.A.row(component);
      c.W.template block<1, Dim - 1>(r, end) = tied.W.row(component);
    }
    for (std::size_t k = 0; k < node.at.size(); ++k)
      c.A(r, c.num_nodal + node.at[k]) = c.W(r, c.num_nodal + node.at[k]) =
          node.x_q(component, static_cast<Eigen::Index>(k));
  }
  return c;
}

template <int Dim>
void add_geometric_terms(const std::vector<NodeLinearization<Dim>>& nodes, const Columns<Dim>& c,
                         Eigen::MatrixXd& matrix) {
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto& node = nodes[a];
    if (!node.in_contact) continue;
    const Eigen::Index nq = node.x_q.cols(), s = c.first[a];
    const auto at = [&](Eigen::Index k) { return c.num_nodal + node.at[static_cast<std::size_t>(k)]; };
    if (node.sliding) matrix.template block<Dim - 1, Dim - 1>(s, s) += node.geo_ss;
    for (const TiedRow<Dim>& tied : node.ties) {
      const int row = c.of_candidate.at(tied.end);
      for (std::size_t e = 0; e < node.ties.size(); ++e)
        matrix.template block<Dim - 1, Dim - 1>(row, c.of_candidate.at(node.ties[e].end)) += tied.geo_ss[e];
      for (Eigen::Index k = 0; k < nq; ++k) {
        matrix.template block<Dim - 1, 1>(row, at(k)) += tied.geo_sq.col(k);
        matrix.template block<1, Dim - 1>(at(k), row) += tied.geo_qs.col(k).transpose();
      }
    }
    for (Eigen::Index k = 0; k < nq; ++k) {
      for (Eigen::Index l = 0; l < nq; ++l) matrix(at(k), at(l)) += node.geo_qq(k, l);
      if (!node.sliding) continue;
      matrix.template block<Dim - 1, 1>(s, at(k)) += node.geo_sq.col(k);
      matrix.template block<1, Dim - 1>(at(k), s) += node.geo_qs.col(k).transpose();
    }
  }
}

// Replaces rows of coordinates under motion. One that its own nodes do not see, as a turn about the axis that the only one lies on, has no
// pivot of its own: its column goes to the right.
void prescribe_motion(const PrescribedValues& prescribed, const Eigen::VectorXd& q, Eigen::Index first,
                      Eigen::MatrixXd& matrix, Eigen::VectorXd& rhs) {
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    if (!prescribed.is_motion[k]) continue;
    double pivot = std::abs(matrix(first + k, first + k));
    if (pivot < LEAST_DIAGONAL * matrix.col(first + k).cwiseAbs().maxCoeff()) {
      rhs -= matrix.col(first + k) * (prescribed.value[k] - q[k]);
      matrix.col(first + k).setZero();
      pivot = 1;
    }
    pivot = std::max(pivot, 1e-300);
    matrix.row(first + k).setZero();
    matrix(first + k, first + k) = pivot;
    rhs[first + k] = pivot * (prescribed.value[k] - q[k]);
  }
}

// Coordinates that follow others are no unknowns: their rows and columns are empty.
template <int Dim>
void leave_out_followers(const ContactModel<Dim>& model, Eigen::Index first, Eigen::MatrixXd& matrix,
                         Eigen::VectorXd& rhs) {
  for (const Coupling& coupling : model.couplings) {
    matrix(first + coupling.dependent, first + coupling.dependent) = 1;
    rhs[first + coupling.dependent] = 0;
  }
}

// The coordinate that moves most in the null vector of a singular matrix, found by inverse iteration, of several the last
// one (a turn, where places come first); -1 if displacements or slips move far more than all coordinates do.
int weakest_coordinate(const Eigen::MatrixXd& scaled, Eigen::Index first) {
  constexpr double shift = 1e-13, share = 0.1, alike = 0.9;
  const Eigen::Index n = scaled.rows();
  if (first == n) return -1;
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(scaled + shift * Eigen::MatrixXd::Identity(n, n));
  Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(n, 1, 2);
  for (int i = 0; i < 3; ++i) v = lu.solve(v).normalized().eval();
  if (!v.allFinite()) return -1;
  const Eigen::VectorXd moved = v.tail(n - first).cwiseAbs();
  if (moved.maxCoeff() < share * v.cwiseAbs().maxCoeff()) return -1;
  Eigen::Index k = moved.size() - 1;
  while (moved[k] < alike * moved.maxCoeff()) --k;
  return static_cast<int>(k);
}

// Solves with rows and columns equilibrated; reports the coordinate that nothing resists. least_rcond: of the scaled matrix; below, it
// counts as singular.
bool solve_scaled(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rhs, Eigen::Index first,
                  double least_rcond, Eigen::VectorXd& z, int& weakest) {
  const Eigen::Index n = matrix.rows();
  Eigen::VectorXd scale(n), beside = Eigen::VectorXd::Zero(n); // largest entry of row and column
  for (Eigen::Index j = 0; j < n; ++j) {
    beside = beside.cwiseMax(matrix.col(j).cwiseAbs());
    beside[j] = std::max(beside[j], matrix.col(j).cwiseAbs().maxCoeff());
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const double largest = beside[i], d = std::abs(matrix(i, i));
    scale[i] = largest > 0 ? 1 / std::sqrt(std::max(d, LEAST_DIAGONAL * largest)) : 0;
    if (largest == 0) {
      weakest = i >= first ? static_cast<int>(i - first) : -1;
      return false;
    }
  }
  const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  z = scale.asDiagonal() * rhs;
  if (!solve_regular(scaled, least_rcond, z)) {
    weakest = weakest_coordinate(scaled, first);
    return false;
  }
  z = (scale.asDiagonal() * z).eval();
  return z.allFinite();
}

// Whether the matrix of all that may move (slips, displacements, coordinates under force) has an eigenvalue with a
// negative real part. Rows and columns are equilibrated; friction makes it unsymmetric.
template <int Dim>
bool is_unstable(const ContactModel<Dim>& model, const PrescribedValues& prescribed, Eigen::Index first,
                 const Eigen::MatrixXd& matrix) {
  constexpr double least = -1e-10; // eigenvalue of the equilibrated matrix that counts as negative
  std::vector<Eigen::Index> moving;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const int k = static_cast<int>(i - first);
    if (i < first || !(prescribed.is_motion[k] || model.coupling_of(k))) moving.push_back(i);
  }
  if (moving.empty()) return false;
  Eigen::MatrixXd part = matrix(moving, moving);
  const Eigen::VectorXd scale = part.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  part = (scale.asDiagonal() * part * scale.asDiagonal()).eval();
  if (!part.allFinite()) return true;
  return !(least_real_part(part) >= least);
}

Eigen::VectorXd gathered(const Eigen::VectorXd& all, const std::vector<int>& at) {
  Eigen::VectorXd part(static_cast<Eigen::Index>(at.size()));
  for (std::size_t r = 0; r < at.size(); ++r) part[static_cast<Eigen::Index>(r)] = all[at[r]];
  return part;
}
Eigen::VectorXd scattered(const Eigen::VectorXd& part, const std::vector<int>& at, Eigen::Index size) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(size);
  for (std::size_t r = 0; r < at.size(); ++r) all[at[r]] = part[static_cast<Eigen::Index>(r)];
  return all;
}

// W' SA + Geo and its right-hand side, from S A and the forces F0 at z = 0.
template <int Dim>
void assemble_block(const std::vector<NodeLinearization<Dim>>& nodes, const Columns<Dim>& c,
                    const Eigen::MatrixXd& SA, const Eigen::VectorXd& F0, Eigen::MatrixXd& matrix,
                    Eigen::VectorXd& rhs) {
  matrix = transposed_product(c.W, SA);
  rhs = -c.W.transpose() * F0;
  add_geometric_terms(nodes, c, matrix);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    if (nodes[a].in_contact && nodes[a].sliding)
      rhs.template segment<Dim - 1>(c.first[a]) -= nodes[a].constant;
}

// What is known of the coordinates, which stand from row `first` on.
template <int Dim>
void complete_coordinates(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                          const Eigen::VectorXd& q, Eigen::Index first, Eigen::MatrixXd& matrix,
                          Eigen::VectorXd& rhs) {
  const DrivingForce drive = driving_force(model, prescribed, q);
  const int nq = model.num_coordinates();
  if (drive.slope.size() > 0) matrix.block(first, first, nq, nq) -= drive.slope;
  for (int k = 0; k < nq; ++k)
    if (!prescribed.is_motion[k]) rhs[first + k] += drive.value[k];
  prescribe_motion(prescribed, q, first, matrix, rhs);
  leave_out_followers(model, first, matrix, rhs);
}

} // namespace

template <int Dim>
ContactBlockSolution<Dim> solve_contact_block(const ContactModel<Dim>& model,
                                              const PrescribedValues& prescribed, const Eigen::VectorXd& q,
                                              const ContactBlockInput<Dim>& input) {
  const auto& nodes = *input.nodes;
  const std::vector<int>& free = *input.free;
  const Columns<Dim> c = assemble_columns(model, nodes, free);
  const Eigen::VectorXd offset = gathered(input.offset, free);
  Eigen::MatrixXd SA = input.flexibility->solve(c.A), matrix;
  Eigen::VectorXd F0 = input.flexibility->solve(offset - gathered(input.free_increment, free)), rhs, added;
  if (input.added_stiffness.size() > 0) { // the body's own Schur complement lacks what was added
    added = gathered(input.added_stiffness, free);
    SA -= added.asDiagonal() * c.A;
    F0 -= added.cwiseProduct(offset);
  }
  assemble_block(nodes, c, SA, F0, matrix, rhs);
  complete_coordinates(model, prescribed, q, c.num_nodal, matrix, rhs);

  ContactBlockSolution<Dim> solution;
  if (input.test_stability) solution.unstable = is_unstable(model, prescribed, c.num_nodal, matrix);
  Eigen::VectorXd z;
  if (!solve_scaled(matrix, rhs, c.num_nodal, LEAST_RCOND<Dim>, z, solution.weakest_coordinate)) {
    solution.singular = true;
    return solution;
  }
  solution.slip = Eigen::MatrixXd::Zero(Dim - 1, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t a = 0; a < nodes.size(); ++a)
    if (nodes[a].in_contact && nodes[a].sliding)
      solution.slip.col(static_cast<Eigen::Index>(a)) = z.template segment<Dim - 1>(c.first[a]);
  solution.dq = z.tail(model.num_coordinates());
  follow_increment(model, q, solution.dq);
  const Eigen::VectorXd F = F0 + SA * z;
  solution.F = solution.load = scattered(F, free, input.offset.size());
  if (added.size() > 0)
    solution.load = scattered(F + added.cwiseProduct(offset + c.A * z), free, input.offset.size());
  return solution;
}

template ContactBlockSolution<2> solve_contact_block<2>(const ContactModel<2>&, const PrescribedValues&,
                                                        const Eigen::VectorXd&, const ContactBlockInput<2>&);
template ContactBlockSolution<3> solve_contact_block<3>(const ContactModel<3>&, const PrescribedValues&,
                                                        const Eigen::VectorXd&, const ContactBlockInput<3>&);

} // namespace burnish
