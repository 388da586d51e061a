#include "workpiece/user_points.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double LEAST_SYMMETRY = 1e-9;

std::string gradient_name(int dim, int component) {
  if (component == dim * dim) return "zz";
  const char* axes = "xyz";
  return {axes[component / dim], axes[component % dim]};
}
template <int Dim> std::string increment_name(int component) {
  return component < num_stress<Dim> ? PointTraits<Dim>::stress_names[component] : "rotation";
}
void require_component(int component, int size, const char* what, const char* where) {
  require(component >= 0 && component < size, where, what, component,
          ("0.." + std::to_string(size - 1)).c_str());
}

} // namespace

template <int Dim>
UserPoints<Dim>::UserPoints(const Discretization<Dim>& mesh)
    : m_axisymmetric(mesh.axisymmetric), m_place(mesh.point) {
  const auto points = static_cast<std::size_t>(mesh.num_points());
  m_piola.assign(points, Gradient<Dim>::Zero());
  m_moduli.assign(points, PiolaTangent<Dim>::Zero());
  m_jacobian.assign(points, StressByIncrement<Dim>::Zero());
}

template <int Dim> void UserPoints<Dim>::expire() {
  m_stress_given = {};
  m_piola_given = {};
  m_moduli_given = {};
  m_jacobian_given = {};
  m_by_piola = m_by_increment = false;
}

// Out of the plane only axisymmetric meshes have virtual work.
template <int Dim> bool UserPoints<Dim>::in_mesh(int component) const {
  return component < Dim * Dim || m_axisymmetric;
}

template <int Dim> void UserPoints<Dim>::require_stress(const char* where) const {
  for (int c = 0; m_by_piola && c < NG; ++c)
    if (in_mesh(c) && !m_piola_given[c])
      fail(where, "the user-defined law has not given component " + gradient_name(Dim, c) +
                      " of the first Piola stress since the last update");
  for (int c = 0; c < NS; ++c)
    if (!m_stress_given[c])
      fail(where, std::string("the user-defined law has not given component ") +
                      PointTraits<Dim>::stress_names[c] + " of the stress since the last update");
}

template <int Dim> void UserPoints<Dim>::require_moduli(const char* where) const {
  const std::string begin = "the user-defined law has not given the ", end = " since the last update";
  if (m_by_increment) {
    for (int i = 0; i < NS; ++i)
      for (int j = 0; j < NY; ++j)
        if (!m_jacobian_given[i][j])
          fail(where, begin + "derivative of tau_" + PointTraits<Dim>::stress_names[i] +
                          " by the increment of " + increment_name<Dim>(j) + end);
    return;
  }
  for (int i = 0; i < NG; ++i)
    for (int j = 0; j < NG; ++j)
      if (in_mesh(i) && in_mesh(j) && !m_moduli_given[i][j] && !m_moduli_given[j][i])
        fail(where, begin + "modulus d P_" + gradient_name(Dim, i) + "/d F_" + gradient_name(Dim, j) + end);
}

template <int Dim>
RangeResult UserPoints<Dim>::move(const MaterialLaw<Dim>& law, const RangeStep<Dim>& step,
                                  const RangeUpdate<Dim>& now) {
  for (int k = 0; k < step.size; ++k) {
    const PointStep<Dim> one = step.point(k);
    const Gradient<Dim> F_mid = 0.5 * (one.old.F + one.F);
    const PointResult result = determinant_result(determinant(F_mid));
    if (result.status != UpdateStatus::OK) return {result, k};
    Eigen::Map<Stress<Dim>>(now.strain_increment + std::ptrdiff_t{NS} * k) =
        law.increments(one).y.template head<NS>();
    now.plastic[k] = 0;
  }
  return {};
}

template <int Dim>
PiolaTangent<Dim> UserPoints<Dim>::moduli(int point, const MaterialLaw<Dim>& law, const PointStep<Dim>& step,
                                          const PointState<Dim>& now) const {
  if (!m_by_increment) return m_moduli[point];
  const StressByF<Dim> by_F = m_jacobian[point] * law.increments(step).by_F;
  return piola_tangent<Dim>(by_F, now.stress, Gradient<Dim>(now.F), law.small_strain());
}

template <int Dim> void GivenPoints<Dim>::check(const Values& values, const std::string& name) const {
  const std::size_t points = m_points.m_piola.size();
  require(static_cast<std::size_t>(values.size()) == points, m_where, ("size of " + name).c_str(),
          values.size(), (std::to_string(points) + ", the number of points").c_str());
  for (Eigen::Index p = 0; p < values.size(); ++p)
    if (!std::isfinite(values[p])) {
      std::ostringstream text;
      const Eigen::Map<const Vector<Dim>> X(m_points.m_place.data() + Dim * p);
      text << name << " is " << values[p] << " at point " << p << ", reference place (" << X[0];
      for (int i = 1; i < Dim; ++i) text << ", " << X[i];
      fail(m_where, text.str() + "), expected a finite number from the law");
    }
}

template <int Dim> void GivenPoints<Dim>::stress(int component, const Values& values) const {
  require_component(component, NS, "component", m_where);
  check(values, std::string("Kirchhoff stress ") + PointTraits<Dim>::stress_names[component]);
  for (Eigen::Index p = 0; p < values.size(); ++p) m_now.stress[NS * p + component] = values[p];
  m_points.m_stress_given[component] = true;
}

template <int Dim> void GivenPoints<Dim>::piola(int component, const Values& values) const {
  require_component(component, NG, "component", m_where);
  check(values, "first Piola stress " + gradient_name(Dim, component));
  for (Eigen::Index p = 0; p < values.size(); ++p) m_points.m_piola[p][component] = values[p];
  m_points.m_piola_given[component] = m_points.m_by_piola = true;
  for (int c = 0; c < NG; ++c)
    if (m_points.in_mesh(c) && !m_points.m_piola_given[c]) return;
  follow_piola();
}

// tau = P F', in small strains P.
template <int Dim> void GivenPoints<Dim>::follow_piola() const {
  for (std::size_t p = 0; p < m_points.m_piola.size(); ++p) {
    Gradient<Dim> F = Eigen::Map<const Gradient<Dim>>(m_now.F.data() + p * NG);
    if (m_law.small_strain()) F = undeformed<Dim>();
    const Tensor<Dim> tau = mesh_part<Dim>(m_points.m_piola[p]) * mesh_part<Dim>(F).transpose();
    const double skew = (tau - tau.transpose()).norm();
    if (skew > LEAST_SYMMETRY * tau.norm()) {
      std::ostringstream text;
      text << "P F' is not symmetric at point " << p << ": skew part " << skew << ", norm " << tau.norm()
           << "; expected a law that is objective (or another order of the components)";
      fail(m_where, text.str());
    }
    double* stress = m_now.stress.data() + p * NS;
    for (int k = 0; k < NS; ++k) {
      const auto [i, j] = PointTraits<Dim>::place[k];
      stress[k] = i >= 0 ? 0.5 * (tau(i, j) + tau(j, i)) : m_points.m_piola[p][NG - 1] * F[NG - 1];
    }
  }
  m_points.m_stress_given.fill(true);
}

template <int Dim> void GivenPoints<Dim>::moduli(int row, int column, const Values& values) const {
  require_component(row, NG, "row", m_where);
  require_component(column, NG, "column", m_where);
  check(values, "modulus d P_" + gradient_name(Dim, row) + "/d F_" + gradient_name(Dim, column));
  const bool follows = !m_points.m_moduli_given[column][row];
  for (Eigen::Index p = 0; p < values.size(); ++p) {
    m_points.m_moduli[p](row, column) = values[p];
    if (follows) m_points.m_moduli[p](column, row) = values[p];
  }
  m_points.m_moduli_given[row][column] = true;
  m_points.m_by_increment = false;
}

template <int Dim> void GivenPoints<Dim>::jacobian(int row, int column, const Values& values) const {
  require_component(row, NS, "row", m_where);
  require_component(column, NY, "column", m_where);
  check(values, std::string("derivative of tau_") + PointTraits<Dim>::stress_names[row] +
                    " by the increment of " + increment_name<Dim>(column));
  for (Eigen::Index p = 0; p < values.size(); ++p) m_points.m_jacobian[p](row, column) = values[p];
  m_points.m_jacobian_given[row][column] = m_points.m_by_increment = true;
}

template <int Dim>
void GivenPoints<Dim>::internal(const std::string& name, int component, const Values& values) const {
  check(values, "internal variable " + name);
  const int place = m_law.internal_place(name, component, m_where), size = m_law.internal_variables().size();
  const bool flow = name == "plastic_strain_eq";
  for (Eigen::Index p = 0; p < values.size(); ++p) {
    m_now.internal[p * size + place] = values[p];
    if (flow) m_now.plastic[p] = values[p] > m_old.internal[p * size + place];
  }
}

template class UserPoints<2>;
template class UserPoints<3>;
template class GivenPoints<2>;
template class GivenPoints<3>;

} // namespace burnish
