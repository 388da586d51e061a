#include "contact/tool_stiffness.hpp"
#include "contact/driving_force.hpp"
#include <limits>

namespace burnish {
namespace {

constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
constexpr double LEAST_PIVOT =
    1e-12; // of the equilibrated stiffness of the free coordinates: below, it has none

// Leading rows and columns of a system, without its coordinates.
struct Leading {
  std::vector<int> row_start{0}, col;
  std::vector<double> value;
  Leading(const CondensedSystem& system, int size) {
    for (int row = 0; row < size; ++row) {
      for (int k = system.row_start[row]; k < system.row_start[row + 1] && system.col[k] < size; ++k) {
        col.push_back(system.col[k]);
        value.push_back(system.value[k]);
      }
      row_start.push_back(static_cast<int>(col.size()));
    }
  }
  SparseView view() const {
    return {static_cast<int>(row_start.size()) - 1, row_start.data(), col.data(), value.data(), false};
  }
};

// Coordinates under force, but for one, that something resists.
template <int Dim>
std::vector<int> free_coordinates(const ContactModel<Dim>& model, const Eigen::MatrixXd& resistance,
                                  const PrescribedValues& prescribed, int moved) {
  std::vector<int> free;
  for (int k = 0; k < model.num_coordinates(); ++k)
    if (k != moved && !prescribed.is_motion[static_cast<std::size_t>(k)] && !model.coupling_of(k) &&
        (resistance.row(k).cwiseAbs().maxCoeff() > 0))
      free.push_back(k);
  return free;
}

// Solves A x = b with rows and columns equilibrated; NaN where A is singular.
Eigen::VectorXd solve_equilibrated(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  if (b.size() == 0) return b;
  const Eigen::VectorXd scale = A.cwiseAbs()
                                    .rowwise()
                                    .maxCoeff()
                                    .cwiseMax(std::numeric_limits<double>::min())
                                    .cwiseSqrt()
                                    .cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * A * scale.asDiagonal();
  Eigen::FullPivLU<Eigen::MatrixXd> lu(scaled);
  lu.setThreshold(LEAST_PIVOT);
  if (!scaled.allFinite() || !lu.isInvertible()) return Eigen::VectorXd::Constant(b.size(), NONE);
  return scale.asDiagonal() * lu.solve(Eigen::VectorXd(scale.asDiagonal() * b));
}

} // namespace

template <int Dim> Eigen::MatrixXd ToolStiffness<Dim>::held(const TangentState<Dim>& state) {
  const int nq = m_model.num_coordinates();
  // all independent coordinates unknown, and no stiffness of the drives
  const PrescribedValues none{std::vector<char>(static_cast<std::size_t>(nq), 0), Eigen::VectorXd::Zero(nq)};
  const CondensedSystem& system =
      m_condensation.condense({state.K, state.contact, none, none, state.u, state.R});
  const int size = system.n - nq;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(size, nq), stiffness = Eigen::MatrixXd::Zero(nq, nq);
  for (int row = 0; row < size; ++row)
    for (int k = system.row_start[row + 1] - 1; k >= system.row_start[row] && system.col[k] >= size; --k)
      columns(row, system.col[k] - size) = system.value[k];
  const Leading leading(system, size);
  if (m_solver.factorize(leading.view()) != FactorStatus::OK) return Eigen::MatrixXd::Constant(nq, nq, NONE);
  for (int l = 0; l < nq; ++l)
    if (columns.col(l).cwiseAbs().maxCoeff() > 0)
      columns.col(l) =
          m_solver.solve(columns.col(l)).eval(); // how nodes and slips give way, with the sign changed
  for (int row = 0; row < nq; ++row)
    for (int k = system.row_start[size + row]; k < system.row_start[size + row + 1]; ++k) {
      const int column = system.col[k];
      if (column < size)
        stiffness.row(row) -= system.value[k] * columns.row(column);
      else
        stiffness(row, column - size) += system.value[k];
    }
  for (const Coupling& coupling : m_model.couplings) {
    stiffness.row(coupling.dependent).setZero();
    stiffness.col(coupling.dependent).setZero();
  }
  return stiffness;
}

template <int Dim>
Eigen::MatrixXd driven_stiffness(const ContactModel<Dim>& model, const Eigen::MatrixXd& held,
                                 const PrescribedValues& prescribed, const Eigen::VectorXd& q) {
  const int nq = model.num_coordinates();
  Eigen::MatrixXd slope = driving_force(model, prescribed, q).slope;
  if (slope.size() == 0) slope = Eigen::MatrixXd::Zero(nq, nq);
  const Eigen::MatrixXd resistance = held - slope;
  Eigen::MatrixXd driven = held;
  for (int l = 0; l < nq; ++l) {
    const std::vector<int> free = free_coordinates(model, resistance, prescribed, l);
    const Eigen::VectorXd follow =
        solve_equilibrated(resistance(free, free), -Eigen::VectorXd(resistance(free, l)));
    driven.col(l) += held(Eigen::all, free) * follow;
    for (const int k : free) driven(k, l) = slope(k, l) + slope(k, free).dot(follow.transpose());
  }
  return driven;
}

template class ToolStiffness<2>;
template class ToolStiffness<3>;
template Eigen::MatrixXd driven_stiffness<2>(const ContactModel<2>&, const Eigen::MatrixXd&,
                                             const PrescribedValues&, const Eigen::VectorXd&);
template Eigen::MatrixXd driven_stiffness<3>(const ContactModel<3>&, const Eigen::MatrixXd&,
                                             const PrescribedValues&, const Eigen::VectorXd&);

} // namespace burnish
