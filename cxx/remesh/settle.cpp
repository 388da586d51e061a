#include "remesh/settle.hpp"
#include "contact/resultant.hpp"
#include "run/workpiece_tangent.hpp"
#include "workpiece/elastic_energy.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double SHORT = 1e-6;         // of the last step: nothing moves in it by itself
constexpr int MOST = 100;              // iterations
constexpr double LEAST_PART = 1. / 16; // of what is out of balance, that is let go of in a step

template <int Dim>
bool equilibrium(Workpiece<Dim>& body, ContactRun<Dim>& contact, Eigen::VectorXd& u, double dt,
                 int& iterations) {
  for (int i = 0; i < MOST; ++i) {
    if (body.update(u, dt, i).status != UpdateStatus::OK) return false;
    const Eigen::VectorXd R = body.internal_force();
    const StepStatus status = contact.check(u, R);
    iterations = i;
    if (status == StepStatus::CONVERGED) {
      contact.accept(u, R, {});
      return true;
    }
    if (status == StepStatus::FAILED) return false;
    if (status == StepStatus::REFACTORIZE && !factorize_tangent(contact, body, u)) return false;
    if (status != StepStatus::BACKTRACKED && contact.correct(u, R) == StepStatus::FAILED) return false;
  }
  return false;
}

// The nodal forces that nothing carries: those of free components of nodes that no tool touches, less a hold's.
template <int Dim>
Eigen::VectorXd uncarried(const Workpiece<Dim>& body, const ContactRun<Dim>& contact, double t) {
  Eigen::VectorXd R = contact.loads().residual(contact.accepted().u, t, body.internal_force());
  const ContactSetup<Dim>& setup = contact.setup();
  for (Eigen::Index d = 0; d < R.size(); ++d)
    if (setup.body().fixed[static_cast<std::size_t>(d)]) R[d] = 0;
  const auto& nodes = contact.accepted().contact.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (in_contact(nodes[i].state))
      R.template segment<Dim>(Eigen::Index{Dim} * setup.candidates()[i]).setZero();
  return R;
}

// Steps in which nothing is driven: part after part of the uncarried forces, held by external ones, is let go of; first all of it.
template <int Dim> bool let_go(Workpiece<Dim>& body, ContactRun<Dim>& contact, double t, int& iterations) {
  const Eigen::VectorXd held = uncarried(body, contact, t);
  const double dt = SHORT * contact.accepted().history.dt;
  iterations = 0;
  for (double share = 1, part = 1; share > 0;) {
    const double left = std::max(0., share - part);
    if (left > 0)
      contact.loads().external.prescribe(left * held);
    else
      contact.loads().external.restore(Eigen::VectorXd(), false);
    Eigen::VectorXd u = contact.accepted().u;
    int made = 0;
    contact.begin(u, t, dt, Stepping::IMPLICIT);
    const bool found = equilibrium(body, contact, u, dt, made);
    iterations += made;
    if (found) {
      body.accept();
      share = left;
      continue;
    }
    body.revert();
    contact.revert();
    part /= 2;
    if (part < LEAST_PART) return false;
  }
  return true;
}

} // namespace

double Remeshing::volume() const { return (meshed - before.volume) / before.volume; }
double Remeshing::energy() const {
  const double change = (after.elastic_energy - before.elastic_energy) / before.elastic_energy;
  return std::isfinite(change) ? change : 0;
}
double Remeshing::force() const {
  if (!settled) return 0;
  double largest = 0, change = 0;
  for (std::size_t t = 0; t < before.force.size(); ++t) {
    largest = std::max(largest, before.force[t].norm());
    change = std::max(change, (after.force[t] - before.force[t]).norm());
  }
  return largest > 0 ? change / largest : 0;
}

template <int Dim> MeshState mesh_state(const Workpiece<Dim>& body, const ContactRun<Dim>& contact) {
  MeshState state;
  state.nodes = body.discretization().num_nodes;
  state.shape = least_shape(body);
  state.volume = deformed_volume(body);
  state.elastic_energy = elastic_energy(body);
  const ContactRunState<Dim>& at = contact.accepted();
  const ContactSetup<Dim>& setup = contact.setup();
  for (int t = 0; t < static_cast<int>(setup.tools().size()); ++t) {
    const Eigen::VectorXd forces = contact_forces(setup.model(), at.contact, at.R, t);
    state.force.push_back(resultant(setup.body(), at.u, forces, Vector<Dim>(Vector<Dim>::Zero())).force);
  }
  return state;
}

template <int Dim>
int settle(Workpiece<Dim>& body, ContactRun<Dim>& contact, double t, const TransferredState<Dim>& start) {
  const ContactRunState<Dim> before = contact.state();
  if (before.history.dt == 0) return 0; // no step has been made: nothing is in contact yet
  WorkpieceState<Dim> still = start.workpiece;
  std::fill(still.strain_increment.begin(), still.strain_increment.end(), 0);
  still.dt = 0;
  int iterations = 0;
  body.set_state(still);
  if (!let_go(body, contact, t, iterations)) {
    contact.set_state(before);
    body.set_state(start.workpiece);
    return -1;
  }
  still = body.state_old();
  still.strain_increment = start.workpiece.strain_increment;
  still.dt = start.workpiece.dt;
  body.set_state(still);
  ContactRunState<Dim> state = contact.state();
  state.history = before.history;
  contact.set_state(state);
  return iterations;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template MeshState mesh_state<Dim>(const Workpiece<Dim>&, const ContactRun<Dim>&);                         \
  template int settle<Dim>(Workpiece<Dim>&, ContactRun<Dim>&, double, const TransferredState<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
