// Internal force and tangent of the workpiece.
#include "base/error.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish {
namespace {

template <int Dim> Gradient<Dim> deformation(const WorkpieceState<Dim>& state, int point) {
  return Eigen::Map<const Gradient<Dim>>(state.F.data() +
                                         static_cast<std::size_t>(point) * num_gradient<Dim>);
}

template <int Dim> Stress<Dim> kirchhoff(const WorkpieceState<Dim>& state, int point) {
  return Eigen::Map<const Stress<Dim>>(state.stress.data() +
                                       static_cast<std::size_t>(point) * num_stress<Dim>);
}

void require_point(const char* where, int point, int num_points) {
  require(point >= 0 && point < num_points, where, "point", point, "0 <= point < num_points");
}

void require_blend(const char* where, double blend) {
  require(blend >= 0 && blend <= 1, where, "elastic_blend", blend, "0 <= elastic_blend <= 1");
}

} // namespace

template <int Dim> Eigen::VectorXd Workpiece<Dim>::internal_force() const {
  const Discretization<Dim>& mesh = m_discretization;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(mesh.num_dofs());
  for (int p = 0; p < mesh.num_points(); ++p) {
    const int* node = mesh.element(p / mesh.points_per_element);
    const double* gradient = mesh.gradients(p);
    const Gradient<Dim> F_inverse = inverse(deformation(m_state, p));
    const Gradient<Dim> P = first_piola(kirchhoff(m_state, p), F_inverse);
    const Tensor<Dim> in_mesh = mesh.weight[p] * mesh_part<Dim>(P);
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      Eigen::Map<Vector<Dim>>(force.data() + Dim * node[a]).noalias() +=
          in_mesh * Eigen::Map<const Vector<Dim>>(gradient + Dim * a);
    if (!mesh.axisymmetric) continue;
    const double hoop = mesh.weight[p] * P[ZZ] * mesh.inverse_radius(p);
    for (int a = 0; a < mesh.nodes_per_element; ++a) force[Dim * node[a]] += hoop * mesh.shapes(p)[a];
  }
  return force;
}

template <int Dim>
PiolaTangent<Dim> Workpiece<Dim>::consistent_at(int point, const Gradient<Dim>& F,
                                                const Stress<Dim>& stress) const {
  const PointOld<Dim> old = point_old(point);
  const StepKinematics<Dim> kin = step_kinematics(old.F, F, m_options.strain_frame);
  const PointScheme with = scheme(step_ratio(), m_used_substeps[point]);
  return consistent_tangent<Dim>(m_material, with, old, kin, F, stress);
}

template <int Dim>
PiolaTangent<Dim> Workpiece<Dim>::moduli(int point, TangentKind kind, double elastic_blend) const {
  const Gradient<Dim> F = deformation(m_state, point);
  const Stress<Dim> stress = kirchhoff(m_state, point);
  const bool plastic = m_state.plastic[point];
  if (kind == TangentKind::ELASTIC) return rate_tangent<Dim>(m_material, stress, F, false);
  PiolaTangent<Dim> A = kind == TangentKind::CONSISTENT && m_updated
                            ? consistent_at(point, F, stress)
                            : rate_tangent<Dim>(m_material, stress, F, plastic);
  if (plastic && elastic_blend > 0)
    A += elastic_blend * (rate_tangent<Dim>(m_material, stress, F, false) - A);
  return 0.5 * (A + A.transpose());
}

template <int Dim>
template <int Hoop>
void Workpiece<Dim>::add_point(NodeBlockMatrix<Dim>& matrix, int element, int point,
                               const PiolaTangent<Dim>& A) const {
  using Block = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;
  const int nodes = m_discretization.nodes_per_element;
  const double *gradient = m_discretization.gradients(point), *shape = m_discretization.shapes(point);
  const double inverse_radius = Hoop ? m_discretization.inverse_radius(point) : 0;
  const int* slot = m_slot.data() + static_cast<std::size_t>(element) * nodes * nodes;
  for (int b = 0; b < nodes; ++b) {
    // A times the gradients that the components k of node b cause; then the block (i,k) of pair (a,b)
    const Eigen::Map<const Vector<Dim>> grad_b(gradient + Dim * b);
    Eigen::Matrix<double, Dim * Dim + Hoop, Dim> column;
    for (int k = 0; k < Dim; ++k)
      column.col(k).noalias() = A.template block<Dim * Dim + Hoop, Dim>(0, Dim * k) * grad_b;
    if constexpr (Hoop) column.col(0) += shape[b] * inverse_radius * A.template rightCols<1>();
    for (int a = 0; a <= b; ++a) {
      const Eigen::Map<const Vector<Dim>> grad_a(gradient + Dim * a);
      Block block;
      for (int i = 0; i < Dim; ++i)
        block.row(i).noalias() = grad_a.transpose() * column.template middleRows<Dim>(Dim * i);
      if constexpr (Hoop) block.row(0) += shape[a] * inverse_radius * column.template bottomRows<1>();
      Eigen::Map<Block>(matrix.block(slot[a * nodes + b])) += block;
      if (a != b) Eigen::Map<Block>(matrix.block(slot[b * nodes + a])) += block.transpose();
    }
  }
}

template <int Dim>
void Workpiece<Dim>::tangent(NodeBlockMatrix<Dim>& matrix, TangentKind kind, double elastic_blend) const {
  const char* where = "Workpiece::tangent";
  require_blend(where, elastic_blend);
  if (matrix.row_start != m_pattern.row_start || matrix.col != m_pattern.col ||
      matrix.value.size() != m_pattern.value.size())
    fail(where, "the matrix has another pattern than this discretization, expected one from pattern()");
  std::fill(matrix.value.begin(), matrix.value.end(), 0.);
  const Discretization<Dim>& mesh = m_discretization;
  for (int p = 0; p < mesh.num_points(); ++p) {
    const PiolaTangent<Dim> A = mesh.weight[p] * moduli(p, kind, elastic_blend);
    const int element = p / mesh.points_per_element;
    if (mesh.axisymmetric)
      add_point<1>(matrix, element, p, A);
    else
      add_point<0>(matrix, element, p, A);
  }
}

template <int Dim>
void Workpiece<Dim>::point_moduli(int point, TangentKind kind, double elastic_blend, double* A) const {
  require_point("Workpiece::point_moduli", point, m_discretization.num_points());
  require_blend("Workpiece::point_moduli", elastic_blend);
  Eigen::Map<PiolaTangent<Dim>>{A} = moduli(point, kind, elastic_blend);
}

template <int Dim> void Workpiece<Dim>::point_piola(int point, double* P) const {
  require_point("Workpiece::point_piola", point, m_discretization.num_points());
  Eigen::Map<Gradient<Dim>>{P} = first_piola(kirchhoff(m_state, point), inverse(deformation(m_state, point)));
}

template <int Dim> double Workpiece<Dim>::stress_eq(int point) const {
  require_point("Workpiece::stress_eq", point, m_discretization.num_points());
  return equivalent<Dim>(deviator<Dim>(kirchhoff(m_state, point)));
}

template <int Dim> double Workpiece<Dim>::yield_excess(int point) const {
  return stress_eq(point) / yield_stress_at(m_material, m_state.plastic_strain_eq[point]) - 1;
}

// members of this file; workpiece.cpp instantiates the others
template Eigen::VectorXd Workpiece<2>::internal_force() const;
template void Workpiece<2>::tangent(NodeBlockMatrix<2>&, TangentKind, double) const;
template void Workpiece<2>::point_moduli(int, TangentKind, double, double*) const;
template void Workpiece<2>::point_piola(int, double*) const;
template double Workpiece<2>::stress_eq(int) const;
template double Workpiece<2>::yield_excess(int) const;

} // namespace burnish
