// Work done on the workpiece against what it stores and dissipates (METHOD.md 3.17).
#include "base/sentence.hpp"
#include "contact/resultant.hpp"
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "workpiece/elastic_energy.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr Bounds ENERGY{0.1}; // error of the energy over the largest work

// Energies of the run so far [force length].
struct EnergyState {
  double tools = 0, supports = 0, external = 0, hold = 0; // work done on the body and in friction
  double friction = 0;                                    // dissipated between body and tools
  double inside = 0;        // work of the internal forces, where elastic and plastic parts are not known
  double elastic = 0;       // stored now
  double elastic_start = 0; // stored at the start of the run
  double plastic = 0;       // dissipated in the body
  double largest = 0;       // largest sum of the absolute works: scale of the error
  // at the end of the last step
  Eigen::VectorXd u, q, generalized_force, support_force, external_force, hold_force, internal_force;
  Eigen::VectorXd plastic_strain_eq, friction_force; // per point [-]; per candidate, along the slip [force]
  BURNISH_FIELDS(tools, supports, external, hold, friction, inside, elastic, elastic_start, plastic, largest,
                 u, q, generalized_force, support_force, external_force, hold_force, internal_force,
                 plastic_strain_eq, friction_force)
};

template <int Dim> class EnergyCheck final : public ObserverOf<EnergyCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_energy)
  void begin(const AcceptedStep<Dim>& step, FindingList& findings) override;
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  EnergyState m_energy;
};

// The law where stored and dissipated energy follow from its state; else null.
template <int Dim> const MaterialLaw<Dim>* energetic_law(const Workpiece<Dim>& workpiece) {
  const MaterialLaw<Dim>* law = known_law(&workpiece);
  const bool known =
      law && !workpiece.state().tracks_integrity() && law->internal_variables().find("backstress") < 0;
  return known ? law : nullptr;
}

// Dissipated in the step: yield stress times plastic strain, by the trapezoid.
template <int Dim>
double dissipated(const Workpiece<Dim>& workpiece, const MaterialLaw<Dim>& law, const Eigen::VectorXd& before,
                  const Eigen::VectorXd& now) {
  double sum = 0;
  for (Eigen::Index p = 0; p < now.size(); ++p)
    if (now[p] > before[p])
      sum += workpiece.discretization().weight[static_cast<std::size_t>(p)] * (now[p] - before[p]) * 0.5 *
             (law.yield_stress(before[p]).value + law.yield_stress(now[p]).value);
  return sum;
}

double work(const Eigen::VectorXd& force_before, const Eigen::VectorXd& force, const Eigen::VectorXd& way) {
  return 0.5 * (force_before + force).dot(way);
}

// Along the slip, per candidate and component.
template <int Dim> Eigen::VectorXd friction_forces(const AcceptedStep<Dim>& step) {
  Eigen::VectorXd forces =
      Eigen::VectorXd::Zero((Dim - 1) * static_cast<Eigen::Index>(step.contact.nodes.size()));
  for (const CheckedNode<Dim>& node : step.touching)
    forces.template segment<Dim - 1>((Dim - 1) * node.candidate) = node.force.part.T;
  return forces;
}

// What the friction of the nodes that slide has taken in the step.
template <int Dim>
double rubbed(const AcceptedStep<Dim>& step, const Eigen::VectorXd& before, const Eigen::VectorXd& now) {
  double sum = 0;
  for (const CheckedNode<Dim>& node : step.touching) {
    const ContactNode<Dim>& contact = step.contact.nodes[node.candidate];
    if (contact.state != NodeState::SLIDING) continue;
    const Eigen::Index i = (Dim - 1) * node.candidate;
    const Param<Dim> T = 0.5 * (before.template segment<Dim - 1>(i) + now.template segment<Dim - 1>(i));
    sum -= T.dot(node.at.m) * contact.slip_rate * step.dt;
  }
  return sum;
}

struct Forces {
  Eigen::VectorXd support, external, hold;
};
template <int Dim> Forces forces_of(const AcceptedStep<Dim>& step) {
  Forces forces;
  forces.support = support_forces(step.model(), step.body(), step.contact, step.R);
  forces.hold = step.hold.force.size() > 0 ? step.hold.force : Eigen::VectorXd::Zero(step.R.size());
  forces.external = step.internal - step.R - forces.hold;
  return forces;
}

void keep(EnergyState& energy, Forces forces) {
  energy.support_force = std::move(forces.support);
  energy.external_force = std::move(forces.external);
  energy.hold_force = std::move(forces.hold);
}

template <int Dim> void EnergyCheck<Dim>::begin(const AcceptedStep<Dim>& step, FindingList&) {
  if (!step.workpiece) return;
  EnergyState& energy = m_energy;
  energy.u = step.workpiece->state_old().displacement;
  energy.q = step.contact.q;
  energy.generalized_force = step.generalized_force;
  energy.friction_force = friction_forces(step);
  energy.internal_force = step.internal;
  if (const auto* law = energetic_law(*step.workpiece)) {
    energy.elastic = energy.elastic_start = elastic_energy(*step.workpiece);
    energy.plastic_strain_eq = plastic_strains(*step.workpiece);
  }
  // of a body that is under stress while its contact is new the forces are not known before the first step
  if (step.internal.isZero(0) || !step.R.isZero(0)) keep(energy, forces_of(step));
}

template <int Dim> void EnergyCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  constexpr double tolerances = 10;
  if (!step.workpiece) return;
  EnergyState& energy = m_energy;
  Forces forces = forces_of(step);
  const Eigen::VectorXd du = step.u - energy.u, friction = friction_forces(step);
  if (energy.support_force.size() == 0) { // what is out of balance at the start goes off in the first step
    keep(energy, forces);
    energy.external += 0.5 * (energy.internal_force - step.internal).dot(du);
  }
  for (Eigen::Index k = 0; k < step.contact.q.size(); ++k)
    if (!step.model().coupling_of(static_cast<int>(k))) // what follows hands its force on
      energy.tools +=
          0.5 * (energy.generalized_force[k] + step.generalized_force[k]) * (step.contact.q[k] - energy.q[k]);
  energy.supports += work(energy.support_force, forces.support, du);
  energy.external += work(energy.external_force, forces.external, du);
  energy.hold += work(energy.hold_force, forces.hold, du);
  energy.friction += rubbed(step, energy.friction_force, friction);
  energy.inside += work(energy.internal_force, step.internal, du);
  double taken = energy.inside;
  const auto* law = energetic_law(*step.workpiece);
  const bool now = step.tenth();
  if (law && now) { // the yield stress depends on the plastic strain alone: long intervals will do
    Eigen::VectorXd strain = plastic_strains(*step.workpiece);
    energy.plastic += dissipated(*step.workpiece, *law, energy.plastic_strain_eq, strain);
    energy.plastic_strain_eq = std::move(strain);
    energy.elastic = elastic_energy(*step.workpiece);
  }
  if (law) {
    taken = energy.elastic - energy.elastic_start + energy.plastic;
  }
  energy.u = step.u;
  energy.q = step.contact.q;
  energy.generalized_force = step.generalized_force;
  energy.friction_force = friction;
  energy.internal_force = step.internal;
  keep(energy, std::move(forces));

  const double given = energy.tools + energy.supports + energy.external + energy.hold;
  energy.largest = std::max({energy.largest, std::abs(given), std::abs(taken) + std::abs(energy.friction)});
  const double off = std::abs(given - taken - energy.friction - step.jumped);
  const double error = energy.largest > 0 ? off / energy.largest : 0;
  if (!law || now) findings.measure("energy", error);
  // what the tolerance of the residual and rounding leave does not count
  const double left = std::max(step.allowed.residual(), step.allowed.rounding);
  const double resolved = tolerances * left * step.u.cwiseAbs().maxCoeff();
  if (!step.last || !(off > resolved)) return;
  Finding* finding = findings.beyond("energy", "", error, ENERGY, step.t);
  if (!finding) return;
  finding->text = sentence("energy is not balanced: ", given, " was put in, ", taken,
                           " is stored and dissipated in the workpiece, ", energy.friction,
                           " in friction; the error is ", error, " of the largest: take shorter steps");
}

} // namespace

BURNISH_OBSERVER(energy_check, EnergyCheck)

} // namespace burnish
