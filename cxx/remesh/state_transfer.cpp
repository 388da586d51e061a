#include "remesh/state_transfer.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "material/stress_algebra.hpp"
#include "remesh/field_transfer.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double SAME_VOLUME = 1e-2; // relative: beyond it is no mesh of the body
constexpr double FLOWING =
    0.1; // distance from the yield surface, over the yield stress, up to which a point flows on

// Component k of n per point.
Eigen::VectorXd component_of(const std::vector<double>& values, int k, int n) {
  return Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>>(
      values.data() + k, static_cast<Eigen::Index>(values.size()) / n, Eigen::InnerStride<>(n));
}
void put_component(std::vector<double>& values, int k, int n, const Eigen::VectorXd& component) {
  for (Eigen::Index p = 0; p < component.size(); ++p)
    values[static_cast<std::size_t>(p * n + k)] = component[p];
}

template <int Dim> Eigen::VectorXd determinants(const WorkpieceState<Dim>& state) {
  Eigen::VectorXd J(static_cast<Eigen::Index>(state.plastic.size()));
  for (Eigen::Index p = 0; p < J.size(); ++p)
    J[p] = determinant(Gradient<Dim>(point_state(state, static_cast<int>(p)).F));
  return J;
}

// Stresses per present volume: divided by J there, times J here.
template <int Dim>
void carry_stresses(const FieldTransfer<Dim>& field, const WorkpieceState<Dim>& old,
                    WorkpieceState<Dim>& now) {
  constexpr int n = num_stress<Dim>;
  const Eigen::VectorXd J_old = determinants(old), J = determinants(now);
  for (int k = 0; k < n; ++k) {
    const Eigen::VectorXd cauchy = component_of(old.stress, k, n).cwiseQuotient(J_old);
    put_component(now.stress, k, n, field(cauchy).cwiseProduct(J));
    put_component(now.strain_increment, k, n, field(component_of(old.strain_increment, k, n)));
  }
}

// What was nowhere negative stays so.
template <int Dim>
void carry_variables(const FieldTransfer<Dim>& field, const InternalVariables<Dim>& variables,
                     const WorkpieceState<Dim>& old, WorkpieceState<Dim>& now) {
  for (int k = 0; k < variables.size(); ++k) {
    const Eigen::VectorXd before = component_of(old.internal, k, variables.size());
    Eigen::VectorXd after = field(before);
    if (before.minCoeff() >= 0) after = after.cwiseMax(0);
    put_component(now.internal, k, variables.size(), after);
  }
}

template <int Dim>
void carry_integrity(const FieldTransfer<Dim>& field, const WorkpieceState<Dim>& old,
                     WorkpieceState<Dim>& now) {
  if (!old.tracks_integrity()) return;
  const auto map = [](const std::vector<double>& v) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())));
  };
  const double least = map(old.integrity).minCoeff();
  const Eigen::VectorXd w = field(map(old.integrity)).cwiseMax(least).cwiseMin(1);
  now.integrity.assign(w.data(), w.data() + w.size());
  for (std::size_t p = 0; p < now.integrity.size(); ++p) {
    const std::size_t from = field.nearest()[p];
    now.integrity_rate[p] = old.integrity_rate[from];
    now.integrity_goal[p] = old.integrity_rate[from] == 0 ? now.integrity[p] : old.integrity_goal[from];
  }
}

// Deviator less back stress times a factor, so that the point is not outside the yield surface, and on it if it flows.
template <int Dim> void admit(const MaterialLaw<Dim>& law, WorkpieceState<Dim>& state, int point) {
  const std::size_t p = point;
  Eigen::Map<Stress<Dim>> tau(state.stress.data() + p * num_stress<Dim>);
  const double* internal = state.internal.data() + p * law.internal_variables().size();
  const double distance = law.yield_distance(Stress<Dim>(tau), internal);
  if (!std::isfinite(distance)) return; // no yield surface
  const bool flows = state.plastic[p] && distance > -FLOWING;
  if (distance <= 0 && !flows) return;
  Stress<Dim> center = Stress<Dim>::Zero();
  const int back = law.internal_variables().find("backstress");
  if (back >= 0) center = Eigen::Map<const Stress<Dim>>(internal + law.internal_variables().offset(back));
  const Stress<Dim> stress = tau, s = deviator<Dim>(stress);
  tau += (center + (s - center) / (1 + distance)) - s;
}

template <int Dim>
void require_same_volume(const Workpiece<Dim>& old, const Workpiece<Dim>& fresh,
                         const WorkpieceState<Dim>& state) {
  const double before = deformed_volume(old);
  double now = 0;
  const Eigen::VectorXd J = determinants(state);
  for (Eigen::Index p = 0; p < J.size(); ++p) now += fresh.discretization().weight[p] * J[p];
  if (std::abs(now - before) <= SAME_VOLUME * before) return;
  fail("remesh", sentence("the new mesh has the volume ", now,
                          ", expected that of the workpiece as it is now, ", before));
}

} // namespace

template <int Dim>
TransferredState<Dim> transferred(const Workpiece<Dim>& old, Workpiece<Dim>& fresh,
                                  const Eigen::VectorXd& start, const Eigen::VectorXd& du) {
  if (old.law().small_strain())
    fail("remesh", "strain=\"small\": forces act at the undeformed place, where no element becomes bad, and "
                   "a mesh of the deformed body is none "
                   "of it; expected strain=\"large\"");
  if (old.state_old().tracks_integrity()) fresh.track_integrity();
  const Discretization<Dim>& mesh = fresh.discretization();
  const UpdateResult moved = fresh.update(start, 1, 0); // for the deformation gradients
  TransferredState<Dim> result{fresh.state(), {}, {}};
  fresh.revert();
  require(moved.status == UpdateStatus::OK, "remesh", "det F of the new mesh", moved.value, "> 0");
  WorkpieceState<Dim>& now = result.workpiece;
  const WorkpieceState<Dim>& before = old.state_old();
  require_same_volume(old, fresh, now);
  const Discretization<Dim> there = deformed(old.discretization(), before.displacement),
                            here = deformed(mesh, start);
  std::vector<Vector<Dim>> points(mesh.num_points()), nodes(mesh.num_nodes);
  for (int p = 0; p < mesh.num_points(); ++p) points[p] = Eigen::Map<const Vector<Dim>>(&here.point[Dim * p]);
  for (int a = 0; a < mesh.num_nodes; ++a) nodes[a] = here.node(a);
  const FieldTransfer<Dim> field(there, points);
  carry_stresses(field, before, now);
  carry_variables(field, old.law().internal_variables(), before, now);
  carry_integrity(field, before, now);
  for (int p = 0; p < mesh.num_points(); ++p) {
    now.plastic[p] = before.plastic[field.nearest()[p]];
    admit(old.law(), now, p);
  }
  now.dt = before.dt;
  result.origin = field.nearest();
  if (du.size() > 0) result.du = nodal_transfer<Dim>(there, du, nodes);
  return result;
}

template TransferredState<2> transferred<2>(const Workpiece<2>&, Workpiece<2>&, const Eigen::VectorXd&,
                                            const Eigen::VectorXd&);
template TransferredState<3> transferred<3>(const Workpiece<3>&, Workpiece<3>&, const Eigen::VectorXd&,
                                            const Eigen::VectorXd&);

} // namespace burnish
