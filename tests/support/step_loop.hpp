#pragma once
// The step loops of edp/rcSteps.idp in C++: rcConverge, rcStepImplicit, rcStepEvent (without element events),
// rcRun.
#include "stepping/step_control.hpp"
#include "support/scene.hpp"
#include <functional>
#include <gtest/gtest.h>

namespace burnish::test {

using ProgramAt =
    std::function<void(double t)>; ///< sets every coordinate of every tool for the end of a step

struct LoopCounts {
  int steps = 0, rejected = 0, substeps = 0, pileups = 0;
};

/// Tangent with elastic blending until it is positive definite (the plugin's C.factorize(M, u)).
inline bool factorize(Scene& scene) {
  do {
    scene.workpiece.tangent(scene.tangent, TangentKind::CONSISTENT,
                            scene.session.corrector().elastic_blend());
    if (scene.session.factorize(scene.tangent, scene.u) == FactorStatus::OK) return true;
  } while (!scene.session.corrector().blend_exhausted());
  return false;
}

/// rcConverge: solves one step. @returns CONVERGED or FAILED
inline StepStatus converge(Scene& scene, double t, double dt, Stepping stepping) {
  scene.session.begin(scene.u, t, dt, stepping);
  StepStatus status = StepStatus::ITERATE;
  for (int it = 0; status != StepStatus::CONVERGED && status != StepStatus::FAILED; ++it) {
    if (scene.workpiece.update(scene.u, dt, it).status != UpdateStatus::OK) return StepStatus::FAILED;
    scene.R = scene.workpiece.internal_force();
    status = scene.session.check(scene.u, scene.R);
    if (status == StepStatus::REFACTORIZE && !factorize(scene)) return StepStatus::FAILED;
    if (status == StepStatus::ITERATE || status == StepStatus::REFACTORIZE)
      if (scene.session.correct(scene.u, scene.R) == StepStatus::FAILED) status = StepStatus::FAILED;
  }
  return status;
}

inline void accept(Scene& scene, const std::vector<ContactEvent<2>>& events) {
  scene.workpiece.accept();
  scene.session.accept(scene.u, scene.R, events);
}

inline void revert(Scene& scene, const Eigen::VectorXd& accepted) {
  scene.workpiece.revert();
  scene.session.revert();
  scene.u = accepted;
}

/// rcStepImplicit. @returns true if the step was accepted
inline bool step_implicit(Scene& scene, StepControl& control, const ProgramAt& program) {
  program(control.time() + control.dt());
  if (converge(scene, control.time(), control.dt(), Stepping::IMPLICIT) != StepStatus::CONVERGED)
    return false;
  accept(scene, {});
  control.accepted();
  return true;
}

/// From event to event through one step; the state of the loop in rcStepEvent.
class EventStep {
public:
  /// @param on_accept called after every accepted substep
  EventStep(Scene& scene, StepControl& control, const ProgramAt& program, LoopCounts& counts,
            std::function<void()> on_accept)
      : m_scene(scene), m_control(control), m_program(program), m_counts(counts),
        m_on_accept(std::move(on_accept)), m_accepted(scene.u), m_from(control.time()) {}

  bool run() {
    const double dt = m_control.dt(), to = m_from + dt;
    bool converged = true;
    while (m_from < to - 1e-9 * dt && converged) converged = substep(to, dt);
    if (converged) {
      m_control.accepted();
      return true;
    }
    if (!(m_from > m_control.time() + 1e-9 * dt)) return false;
    m_control.cut((m_from - m_control.time()) / dt); // what was accepted counts
    m_control.accepted();
    revert(m_scene, m_accepted);
    return true;
  }

private:
  /// One accepted substep, or a change of states at this instant. @returns false if it does not converge
  bool substep(double to, double dt) {
    const bool adapt = m_passes > 3;
    double h = to - m_from;
    if (adapt) h = std::min(h, 0.02 * dt);
    for (int cut = 0; cut < 12; ++cut) {
      m_program(m_from + h);
      if (converge(m_scene, m_from, h, adapt ? Stepping::IMPLICIT : Stepping::EVENT) != StepStatus::CONVERGED)
        return false;
      std::vector<ContactEvent<2>> events;
      if (!adapt) events = m_scene.session.events(m_scene.u, m_scene.R);
      double f = 2;
      for (const auto& event : events) f = std::min(f, event.fraction);
      const bool found = f > 1 || (1 - f) * h < 1e-3 * dt || cut == 11, at_once = f * h <= 1e-6 * dt;
      if (found && !at_once) {
        finish(events, h, adapt);
        return true;
      }
      if (at_once) {
        m_scene.session.switch_states(events);
        ++m_passes;
      }
      revert(m_scene, m_accepted);
      if (at_once) return true; // stay here with the new states
      h *= f;
    }
    return true;
  }
  void finish(const std::vector<ContactEvent<2>>& events, double h, bool adapt) {
    accept(m_scene, events);
    m_accepted = m_scene.u;
    m_from += h;
    m_passes = 0;
    ++m_counts.substeps;
    m_counts.pileups += adapt;
    m_on_accept();
  }

  Scene& m_scene;
  StepControl& m_control;
  const ProgramAt& m_program;
  LoopCounts& m_counts;
  std::function<void()> m_on_accept;
  Eigen::VectorXd m_accepted;
  double m_from;
  int m_passes = 0; // changes of state at this instant
};

/// rcRun: all steps of a program. @param on_accept called after every accepted step or substep
/// @returns counts; fails the test if the step falls below its floor
inline LoopCounts run(
    Scene& scene, StepControl control, Stepping stepping, const ProgramAt& program,
    const std::function<void()>& on_accept = [] {}) {
  LoopCounts counts;
  while (!control.finished()) {
    const double spacing = scene.session.corrector().body().spacing;
    control.propose(std::max(scene.session.contact_width(), 14 * spacing), scene.session.contact_speed());
    const Eigen::VectorXd accepted = scene.u;
    for (;;) {
      const bool implicit = stepping == Stepping::IMPLICIT;
      if (implicit ? step_implicit(scene, control, program)
                   : EventStep(scene, control, program, counts, on_accept).run()) {
        if (implicit) on_accept();
        break;
      }
      ++counts.rejected;
      revert(scene, accepted);
      if (control.rejected()) continue;
      ADD_FAILURE() << "step below its floor at t = " << control.time() << ": "
                    << scene.session.corrector().reason();
      return counts;
    }
    ++counts.steps;
  }
  return counts;
}

} // namespace burnish::test
