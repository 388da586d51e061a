#include "workpiece/workpiece.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int ELEMENTS_AT_A_TIME = 64; // moved and updated while they are in the nearest cache
// Part of elastic moduli in a point that has been elastic and plastic in turn (ALGORITHMS.md 5.2)
constexpr int FIRST_SWITCHES = 2; // from so many switches on
constexpr double BLEND_PER_SWITCH = 0.03, LARGEST_BLEND = 0.3;

template <int Dim> Discretization<Dim> valid(Discretization<Dim> mesh) {
  require_sizes(mesh, "Workpiece");
  return mesh;
}

template <int Dim>
std::shared_ptr<const MaterialLaw<Dim>> valid(std::shared_ptr<const MaterialLaw<Dim>> law) {
  if (!law) fail("Workpiece", "there is no law");
  return law;
}

void require_blend(const char* where, double blend) {
  require(blend >= 0 && blend <= 1, where, "elastic_blend", blend, "0 <= elastic_blend <= 1");
}

/// F = I + du/dX at a point; in axisymmetry F_zz = 1 + u_r/R.
template <int Dim>
Gradient<Dim> deformation_gradient(const Discretization<Dim>& mesh, int element, int point,
                                   const Eigen::VectorXd& u) {
  const int* node = mesh.element(element);
  const double* gradient = mesh.gradients(point);
  RowMajorTensor<Dim> in_mesh = RowMajorTensor<Dim>::Identity();
  for (int a = 0; a < mesh.nodes_per_element; ++a)
    in_mesh.noalias() += Eigen::Map<const Vector<Dim>>(u.data() + Eigen::Index{Dim} * node[a]) *
                         Eigen::Map<const Vector<Dim>>(gradient + Dim * a).transpose();
  Gradient<Dim> F = undeformed<Dim>();
  mesh_part<Dim>(F) = in_mesh;
  if constexpr (PointTraits<Dim>::has_hoop) {
    if (!mesh.axisymmetric) return F;
    double radial = 0;
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      radial += mesh.shapes(point)[a] * u[Eigen::Index{Dim} * node[a]];
    F[ZZ] += radial * mesh.inverse_radius(point);
  }
  return F;
}

} // namespace

template <int Dim>
Workpiece<Dim>::Workpiece(Discretization<Dim> discretization, std::shared_ptr<const MaterialLaw<Dim>> law,
                          UpdateOptions options)
    : m_discretization(valid(std::move(discretization))), m_law(valid(std::move(law))), m_options(options),
      m_assembly(m_discretization), m_division(m_discretization), m_axis(m_discretization),
      m_state_old(initial_state(m_discretization, m_law->internal_variables())), m_state(m_state_old),
      m_trial(m_discretization.num_points()), m_switches(m_discretization.num_points()),
      m_integrity(m_law->internal_variables().initial()) {
  burnish::require_valid(m_options, "Workpiece");
  if (!m_law->has_moduli()) set_user_defined(true);
}

template <int Dim> double Workpiece<Dim>::step_ratio() const {
  return m_state_old.dt > 0 ? m_state.dt / m_state_old.dt : 0;
}

template <int Dim> PointStep<Dim> Workpiece<Dim>::point_step(int point) const {
  return {point_state(start(), point), point_state(m_state, point).F, step_ratio(), 0, m_options};
}

/// Deformation gradients at the points of some elements, into m_state. @return the first point that has none
template <int Dim> UpdateResult Workpiece<Dim>::deform(int first_element, int end_element) {
  const int per_element = m_discretization.points_per_element;
  for (int e = first_element; e < end_element; ++e)
    for (int p = e * per_element; p < (e + 1) * per_element; ++p) {
      const Gradient<Dim> F = deformation_gradient(m_discretization, e, p, m_state.displacement);
      const PointResult result = determinant_result(determinant(F));
      if (result.status != UpdateStatus::OK) return {result.status, p, result.value};
      Eigen::Map<Gradient<Dim>>(m_state.F.data() + static_cast<std::size_t>(p) * num_gradient<Dim>) = F;
    }
  return {};
}

/// Law of the points first..end-1, whose deformation gradients are there.
template <int Dim> UpdateResult Workpiece<Dim>::update_points(int first, int end, int iteration) {
  const int num_internal = m_law->internal_variables().size();
  const std::size_t p = first, gradient = p * num_gradient<Dim>, tensor = p * num_stress<Dim>,
                    internal = p * num_internal;
  const WorkpieceState<Dim>& old = start();
  const RangeStep<Dim> step{end - first,
                            old.F.data() + gradient,
                            old.stress.data() + tensor,
                            old.internal.data() + internal,
                            old.strain_increment.data() + tensor,
                            old.plastic.data() + p,
                            num_internal,
                            m_state.F.data() + gradient,
                            step_ratio(),
                            iteration,
                            m_options};
  const RangeUpdate<Dim> now{m_state.stress.data() + tensor, m_state.internal.data() + internal,
                             m_state.strain_increment.data() + tensor, m_state.plastic.data() + p,
                             m_trial.data() + p};
  const RangeResult found =
      m_user ? UserPoints<Dim>::move(*m_law, step, now) : m_law->update_range(step, now);
  if (found.point < 0) return {};
  return {found.result.status, first + found.point, found.result.value};
}

/// Deformation gradients and law of some elements.
template <int Dim>
UpdateResult Workpiece<Dim>::update_batch(int first_element, int end_element, int iteration) {
  const int per_element = m_discretization.points_per_element;
  const UpdateResult deformed = deform(first_element, end_element);
  const bool sound = deformed.status == UpdateStatus::OK;
  const UpdateResult updated = update_points(first_element * per_element,
                                             sound ? end_element * per_element : deformed.point, iteration);
  return updated.status != UpdateStatus::OK ? updated : deformed;
}

/// All elements up to the first that fails.
template <int Dim> UpdateResult Workpiece<Dim>::update_elements(int iteration) {
  const int count = m_discretization.num_elements;
  for (int first = 0; first < count; first += ELEMENTS_AT_A_TIME)
    if (const auto found = update_batch(first, std::min(first + ELEMENTS_AT_A_TIME, count), iteration);
        found.status != UpdateStatus::OK)
      return found;
  return {};
}

template <int Dim>
UpdateResult Workpiece<Dim>::update(const Eigen::VectorXd& displacement, double dt, int iteration) {
  const char* where = "Workpiece::update";
  require(displacement.size() == m_discretization.num_dofs(), where, "size of displacement",
          displacement.size(), "num_dofs");
  require(dt > 0 && std::isfinite(dt), where, "dt", dt, "finite > 0");
  require(iteration >= 0, where, "iteration", iteration, ">= 0");
  burnish::require_valid(m_options, where);
  m_axis.check(displacement, where);
  if (iteration == 0) {
    std::fill(m_trial.begin(), m_trial.end(), PointTrial{});
    std::fill(m_switches.begin(), m_switches.end(), 0);
  }
  const std::vector<char> before = m_state.plastic;
  m_state.displacement = displacement;
  m_state.dt = dt;
  m_updated = true;
  if (m_user) m_user->expire();
  m_integrity.move(m_state_old, m_state);
  const UpdateResult found = update_elements(iteration);
  if (found.status != UpdateStatus::OK) return found;
  for (std::size_t p = 0; iteration > 0 && p < before.size(); ++p)
    m_switches[p] += before[p] != m_state.plastic[p];
  // a node of no element
  if (!displacement.allFinite())
    return {UpdateStatus::NOT_FINITE, -1, std::numeric_limits<double>::quiet_NaN()};
  return {};
}

template <int Dim> Eigen::VectorXd Workpiece<Dim>::internal_force() const {
  if (m_user && m_updated) m_user->require_stress("Workpiece::internal_force");
  Eigen::VectorXd force = Eigen::VectorXd::Zero(m_discretization.num_dofs());
  m_division.for_points([&](int p) {
    add_force<Dim>(m_discretization, p, carried_piola(m_state, p, m_law->small_strain()), force);
  });
  m_division.share_rows(force);
  return force;
}

// A plastic tangent is some hundred times too soft for a point that unloads.
template <int Dim> double Workpiece<Dim>::own_blend(int point) const {
  const int switches = m_switches[point];
  return m_updated && !m_user && switches >= FIRST_SWITCHES
             ? std::min(BLEND_PER_SWITCH * switches, LARGEST_BLEND)
             : 0;
}

template <int Dim>
PiolaTangent<Dim> Workpiece<Dim>::exact_moduli(int point, TangentKind kind, double elastic_blend) const {
  const PointStep<Dim> step = point_step(point);
  const PointState<Dim> now = point_state(m_state, point);
  const PointTrial& trial = m_trial[point];
  const double w = integrity_of(m_state, point);
  const auto elastic = [&] { return m_law->tangent(TangentKind::ELASTIC, step, trial, now); };
  if (kind == TangentKind::ELASTIC) return w * elastic();
  if (kind == TangentKind::DAMPED) {
    kind = TangentKind::CONSISTENT;
    elastic_blend = std::max(elastic_blend, own_blend(point));
  }
  PiolaTangent<Dim> A = m_user ? m_user->moduli(point, *m_law, step, now)
                               : m_law->tangent(m_updated ? kind : TangentKind::RATE, step, trial, now);
  if (now.plastic && elastic_blend > 0 && m_law->has_moduli()) A += elastic_blend * (elastic() - A);
  return w * A;
}

template <int Dim>
PiolaTangent<Dim> Workpiece<Dim>::moduli(int point, TangentKind kind, double elastic_blend) const {
  const PiolaTangent<Dim> A = exact_moduli(point, kind, elastic_blend);
  return 0.5 * (A + A.transpose());
}

template <int Dim>
void Workpiece<Dim>::tangent(NodeBlockMatrix<Dim>& matrix, TangentKind kind, double elastic_blend) const {
  const char* where = "Workpiece::tangent";
  require_blend(where, elastic_blend);
  if (!m_assembly.fits(matrix))
    fail(where, "the matrix has another pattern than this discretization, expected one from pattern()");
  if (m_user) m_user->require_moduli(where);
  matrix.value.assign(matrix.col.size() * Dim * Dim, 0.);
  m_division.for_points(
      [&](int p) { m_assembly.add(m_discretization, p, moduli(p, kind, elastic_blend), matrix); });
  m_division.share_rows(matrix);
}

template <int Dim>
void Workpiece<Dim>::add_antisymmetric_tangent(NodeBlockMatrix<Dim>& matrix, TangentKind kind,
                                               double elastic_blend) const {
  const char* where = "Workpiece::add_antisymmetric_tangent";
  require_blend(where, elastic_blend);
  if (!m_assembly.fits(matrix) || matrix.value.empty())
    fail(where, "the matrix is not one that tangent() has filled");
  if (m_user) m_user->require_moduli(where);
  m_division.for_points([&](int p) {
    const PiolaTangent<Dim> A = exact_moduli(p, kind, elastic_blend);
    m_assembly.add_antisymmetric(m_discretization, p, 0.5 * (A - A.transpose()), matrix);
  });
  m_division.share_rows(matrix);
}

template <int Dim> void Workpiece<Dim>::require_point(const char* where, int point) const {
  require(point >= 0 && point < m_discretization.num_points(), where, "point", point,
          "0 <= point < num_points");
}

template <int Dim>
PiolaTangent<Dim> Workpiece<Dim>::point_moduli(int point, TangentKind kind, double elastic_blend) const {
  require_point("Workpiece::point_moduli", point);
  require_blend("Workpiece::point_moduli", elastic_blend);
  if (m_user) m_user->require_moduli("Workpiece::point_moduli");
  return moduli(point, kind, elastic_blend);
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
  require_point("Workpiece::set_plastic", point);
  m_state_old.plastic[point] = m_state.plastic[point] = plastic;
}

template <int Dim> void Workpiece<Dim>::set_state(const WorkpieceState<Dim>& state) {
  burnish::require_valid(state, m_discretization, m_law->internal_variables(), "Workpiece::set_state");
  if (tracks_integrity() == state.integrity.empty())
    fail("Workpiece::set_state", tracks_integrity()
                                     ? "size of integrity = 0, expected the number of points"
                                     : "the state has integrities, this workpiece tracks none");
  m_state_old = m_state = state;
  m_updated = false;
}

template <int Dim> void Workpiece<Dim>::set_user_defined(bool user_defined) {
  if (!user_defined && !m_law->has_moduli())
    fail("Workpiece::set_user_defined", "law \"" + m_law->name() + "\" has no stress of its own");
  if (user_defined && !m_user) m_user.emplace(m_discretization);
  if (!user_defined) m_user.reset();
}

template <int Dim> GivenPoints<Dim> Workpiece<Dim>::given(const char* where) {
  if (!m_user) fail(where, "the law of this material is not user-defined, nothing can be given");
  if (!m_updated) fail(where, "there was no update since the last accepted state, call update first");
  return {*m_user, *m_law, m_state_old, m_state, where};
}

template <int Dim> void Workpiece<Dim>::track_integrity() {
  if (tracks_integrity()) return;
  for (WorkpieceState<Dim>* state : {&m_state_old, &m_state}) {
    state->integrity.assign(m_discretization.num_points(), 1);
    state->integrity_rate.assign(m_discretization.num_points(), 0);
    state->integrity_goal.assign(m_discretization.num_points(), 1);
  }
}

template <int Dim> void Workpiece<Dim>::change_integrity(int point, double goal, int steps) {
  const char* where = "Workpiece::change_integrity";
  require_point(where, point);
  if (!tracks_integrity()) fail(where, "no integrity is tracked, call track_integrity first");
  if (m_updated) fail(where, "a step is under way, expected a call between steps, as in record");
  require(goal > 0 && goal <= 1, where, "goal", goal, "0 < goal <= 1");
  require(steps >= 1, where, "steps", steps, ">= 1");
  const double w = m_state_old.integrity[point];
  if (m_user && goal > w)
    fail(where, "the law is user-defined: the stress that it keeps cannot be forgotten");
  for (WorkpieceState<Dim>* state : {&m_state_old, &m_state}) {
    state->integrity_rate[point] = (goal - w) / steps;
    state->integrity_goal[point] = goal;
  }
}

template class Workpiece<2>;
template class Workpiece<3>;

} // namespace burnish
