// State, stress update and the ways between the two states; assembly is in assembly.cpp.
#include "workpiece/workpiece.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

template <int Dim> void require_valid(const Discretization<Dim>& mesh) {
  const char* where = "Workpiece";
  const std::size_t points = static_cast<std::size_t>(std::max(0, mesh.num_points()));
  const std::size_t per_point = static_cast<std::size_t>(std::max(0, mesh.nodes_per_element)) * Dim;
  require(mesh.num_elements > 0, where, "num_elements", mesh.num_elements, "> 0");
  require(mesh.nodes_per_element > Dim, where, "nodes_per_element", mesh.nodes_per_element, "> Dim");
  require(mesh.points_per_element > 0, where, "points_per_element", mesh.points_per_element, "> 0");
  const std::size_t nodes = static_cast<std::size_t>(std::max(0, mesh.num_nodes));
  require(mesh.X.size() == Dim * nodes, where, "size of X", mesh.X.size(), "num_nodes x Dim");
  require(mesh.connectivity.size() == static_cast<std::size_t>(mesh.num_elements) * mesh.nodes_per_element,
          where, "size of connectivity", mesh.connectivity.size(), "num_elements x nodes_per_element");
  require(mesh.weight.size() == points, where, "size of weight", mesh.weight.size(), "num_points");
  require(mesh.shape_grad.size() == points * per_point, where, "size of shape_grad", mesh.shape_grad.size(),
          "num_points x nodes_per_element x Dim");
  require(mesh.shape.size() * Dim == mesh.shape_grad.size(), where, "size of shape", mesh.shape.size(),
          "num_points x nodes_per_element");
  require(mesh.point.size() == points * Dim, where, "size of point", mesh.point.size(), "num_points x Dim");
}

template <int Dim> WorkpieceState<Dim> initial_state(const Discretization<Dim>& mesh) {
  WorkpieceState<Dim> state;
  const std::size_t points = mesh.num_points();
  state.displacement = Eigen::VectorXd::Zero(mesh.num_dofs());
  const Gradient<Dim> F = undeformed<Dim>();
  for (std::size_t p = 0; p < points; ++p) state.F.insert(state.F.end(), F.begin(), F.end());
  state.stress.assign(points * num_stress<Dim>, 0.);
  state.strain_increment = state.stress;
  state.plastic_strain_eq.assign(points, 0.);
  state.plastic.assign(points, 0);
  return state;
}

template <int Dim>
void check_array(const char* name, const double* data, std::size_t size, std::size_t expected) {
  const std::string size_name = std::string("size of ") + name;
  require(size == expected, "Workpiece::set_state", size_name.c_str(), size,
          std::to_string(expected).c_str());
  for (std::size_t k = 0; k < size; ++k)
    require(std::isfinite(data[k]), "Workpiece::set_state", name, data[k], "finite numbers");
}

/// @return true unless det is > 0 and finite; then says so in result
bool bad_determinant(double det, int point, UpdateResult& result) {
  if (det > 0 && std::isfinite(det)) return false;
  const UpdateStatus status = std::isfinite(det) ? UpdateStatus::INVERTED_ELEMENT : UpdateStatus::NOT_FINITE;
  result = {status, point, det};
  return true;
}

} // namespace

template <int Dim>
Workpiece<Dim>::Workpiece(Discretization<Dim> discretization, J2Parameters material, UpdateOptions options)
    : m_discretization(std::move(discretization)), m_material(material), m_options(options) {
  burnish::require_valid(m_material, "Workpiece");
  burnish::require_valid(m_options, "Workpiece");
  require_valid(m_discretization);
  const Discretization<Dim>& mesh = m_discretization;
  m_state_old = m_state = initial_state(mesh);
  m_substeps.assign(mesh.num_points(), 0);
  m_used_substeps = m_substeps;
  const int nodes = mesh.nodes_per_element;
  m_pattern = pattern_from_elements<Dim>(mesh.num_nodes, nodes, mesh.connectivity);
  m_slot.reserve(mesh.connectivity.size() * nodes);
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < nodes; ++b)
        m_slot.push_back(m_pattern.find(mesh.element(e)[a], mesh.element(e)[b]));
  if (!mesh.axisymmetric) return;
  for (const double x : mesh.X) m_rounding = std::max(m_rounding, 1e-9 * std::abs(x));
  for (int a = 0; a < mesh.num_nodes; ++a)
    if (mesh.node(a)[0] <= m_rounding) m_axis.push_back(a);
}

template <int Dim> void Workpiece<Dim>::check_axis(const Eigen::VectorXd& displacement) const {
  for (const int a : m_axis) {
    if (!(std::abs(displacement[Dim * a]) > m_rounding)) continue;
    std::ostringstream what;
    what << "radial displacement of node " << a << " on the axis = " << displacement[Dim * a]
         << ", expected 0: hold it there, on(axis, u=0)";
    fail("Workpiece::update", what.str());
  }
}

template <int Dim>
Gradient<Dim> Workpiece<Dim>::gradient_of_deformation(int element, int point,
                                                      const Eigen::VectorXd& u) const {
  const Discretization<Dim>& mesh = m_discretization;
  const int* node = mesh.element(element);
  const double* gradient = mesh.gradients(point);
  RowMajorTensor<Dim> in_mesh = RowMajorTensor<Dim>::Identity();
  for (int a = 0; a < mesh.nodes_per_element; ++a)
    in_mesh.noalias() += Eigen::Map<const Vector<Dim>>(u.data() + Dim * node[a]) *
                         Eigen::Map<const Vector<Dim>>(gradient + Dim * a).transpose();
  Gradient<Dim> F = undeformed<Dim>();
  mesh_part<Dim>(F) = in_mesh;
  if (!mesh.axisymmetric) return F;
  double radial = 0;
  for (int a = 0; a < mesh.nodes_per_element; ++a) radial += mesh.shapes(point)[a] * u[Dim * node[a]];
  F[ZZ] += radial * mesh.inverse_radius(point);
  return F;
}

template <int Dim> PointOld<Dim> Workpiece<Dim>::point_old(int point) const {
  const std::size_t p = point;
  PointOld<Dim> old;
  old.F = Eigen::Map<const Gradient<Dim>>(m_state_old.F.data() + p * num_gradient<Dim>);
  old.stress = Eigen::Map<const Stress<Dim>>(m_state_old.stress.data() + p * num_stress<Dim>);
  old.plastic_strain_eq = m_state_old.plastic_strain_eq[p];
  old.strain_increment =
      Eigen::Map<const Stress<Dim>>(m_state_old.strain_increment.data() + p * num_stress<Dim>);
  old.plastic = m_state_old.plastic[p] != 0;
  return old;
}

template <int Dim> PointScheme Workpiece<Dim>::scheme(double ratio, int substeps) const {
  return {m_options.update, m_options.path_limit, ratio, substeps};
}

template <int Dim> double Workpiece<Dim>::step_ratio() const {
  return m_state_old.dt > 0 ? m_state.dt / m_state_old.dt : 0;
}

template <int Dim>
bool Workpiece<Dim>::update_point(int point, const Gradient<Dim>& F, double ratio, bool may_grow,
                                  UpdateResult& result) {
  if (bad_determinant(determinant(F), point, result)) return false;
  const PointOld<Dim> old = point_old(point);
  const StepKinematics<Dim> kin = step_kinematics(old.F, F, m_options.strain_frame);
  if (bad_determinant(kin.det_mid, point, result)) return false;
  const ElasticTrial<Dim> trial = elastic_trial<Dim>(m_material, kin, old.stress);
  int substeps = 0;
  if (m_options.update == StressUpdate::SUBSTEPPED) {
    substeps = substeps_needed<Dim>(m_material, m_options, trial, old.plastic_strain_eq, old.plastic);
    int& kept = m_substeps[point];
    if (substeps > 0) substeps = kept = may_grow || kept == 0 ? std::max(kept, substeps) : kept;
  }
  m_used_substeps[point] = substeps;
  const PointNew<Dim> now = updated_point<Dim>(m_material, scheme(ratio, substeps), old, kin, trial);
  const std::size_t p = point;
  Eigen::Map<Gradient<Dim>>(m_state.F.data() + p * num_gradient<Dim>) = F;
  Eigen::Map<Stress<Dim>>(m_state.stress.data() + p * num_stress<Dim>) = now.stress;
  Eigen::Map<Stress<Dim>>(m_state.strain_increment.data() + p * num_stress<Dim>) = kin.strain;
  m_state.plastic_strain_eq[p] = now.plastic_strain_eq;
  m_state.plastic[p] = now.plastic;
  return true;
}

template <int Dim>
UpdateResult Workpiece<Dim>::update(const Eigen::VectorXd& displacement, double dt, int iteration) {
  const char* where = "Workpiece::update";
  require(displacement.size() == m_discretization.num_dofs(), where, "size of displacement",
          displacement.size(), "num_dofs");
  require(dt > 0 && std::isfinite(dt), where, "dt", dt, "finite > 0");
  require(iteration >= 0, where, "iteration", iteration, ">= 0");
  burnish::require_valid(m_options, where);
  check_axis(displacement);
  if (iteration == 0) std::fill(m_substeps.begin(), m_substeps.end(), 0);
  m_state.displacement = displacement;
  m_state.dt = dt;
  m_updated = true;
  UpdateResult result;
  const double ratio = step_ratio();
  const bool may_grow = iteration < m_options.freeze_iteration;
  const int per_element = m_discretization.points_per_element;
  for (int e = 0; e < m_discretization.num_elements; ++e)
    for (int p = e * per_element; p < (e + 1) * per_element; ++p)
      if (!update_point(p, gradient_of_deformation(e, p, displacement), ratio, may_grow, result))
        return result;
  // a node of no element
  if (!displacement.allFinite())
    return {UpdateStatus::NOT_FINITE, -1, std::numeric_limits<double>::quiet_NaN()};
  return result;
}

template <int Dim> void Workpiece<Dim>::accept() {
  m_state_old = m_state;
  m_updated = false;
}

template <int Dim> void Workpiece<Dim>::revert() {
  m_state = m_state_old;
  m_updated = false;
}

template <int Dim> void Workpiece<Dim>::set_plastic(int point, bool plastic) {
  require(point >= 0 && point < m_discretization.num_points(), "Workpiece::set_plastic", "point", point,
          "0 <= point < num_points");
  m_state_old.plastic[point] = m_state.plastic[point] = plastic;
}

template <int Dim> void Workpiece<Dim>::set_state(const WorkpieceState<Dim>& state) {
  const std::size_t points = m_discretization.num_points(), stresses = points * num_stress<Dim>;
  const auto check = [](const char* name, const std::vector<double>& array, std::size_t expected) {
    check_array<Dim>(name, array.data(), array.size(), expected);
  };
  check_array<Dim>("displacement", state.displacement.data(), state.displacement.size(),
                   m_discretization.num_dofs());
  check("F", state.F, points * num_gradient<Dim>);
  check("stress", state.stress, stresses);
  check("plastic_strain_eq", state.plastic_strain_eq, points);
  check("strain_increment", state.strain_increment, stresses);
  require(state.plastic.size() == points, "Workpiece::set_state", "size of plastic", state.plastic.size(),
          std::to_string(points).c_str());
  for (std::size_t p = 0; p < points; ++p) {
    const double det = determinant(Eigen::Map<const Gradient<Dim>>(state.F.data() + p * num_gradient<Dim>));
    require(det > 0, "Workpiece::set_state", "det F", det, "> 0");
  }
  require(state.dt >= 0 && std::isfinite(state.dt), "Workpiece::set_state", "dt", state.dt, "finite >= 0");
  m_state_old = m_state = state;
  m_updated = false;
}

template class Workpiece<2>;

} // namespace burnish
