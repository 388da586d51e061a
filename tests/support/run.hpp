#pragma once
// Runs of a scene: the Stepper's tasks answered by its workpiece, and one step by the verbs.
#include "run/stepper.hpp"
#include "run/workpiece_tangent.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "support/scene.hpp"
#include <functional>
#include <gtest/gtest.h>

namespace burnish::test {

/// Sets every coordinate of every tool for the end of a step.
using ProgramAt = std::function<void(double t)>;

/// What a script does for a task; refuses what cannot be done.
inline void answer(Task task, Scene& scene, Stepper<2>& stepper, const ProgramAt& program) {
  if (task == Task::PROGRAM) program(stepper.target());
  if (task == Task::FORCES) {
    if (scene.workpiece().update(scene.u, stepper.dt(), stepper.iteration()).status != UpdateStatus::OK)
      stepper.refuse("the material could not follow");
    scene.R = scene.workpiece().internal_force();
  }
  if (task == Task::TANGENT && !factorize_tangent(scene.contact(), scene.workpiece(), scene.u))
    stepper.refuse("");
  if (task != Task::SOLVE) return;
  scene.workpiece().tangent(scene.tangent, TangentKind::RATE);
  const CondensedSystem& system = scene.contact().condensed().condense(
      scene.tangent, scene.u, scene.R, GeometricTerms::ARTICLE, RightHandSide::RATES, false);
  UnsymmetricSolver solver;
  if (solver.factorize({system.n, system.row_start.data(), system.col.data(), system.value.data(), false}) !=
      FactorStatus::OK)
    return stepper.refuse("the condensed matrix is singular");
  scene.contact().condensed().expand(solver.solve(system.rhs), scene.u);
}

/// Goes on to the end of the run. @param on_accept after every accepted piece of a step, u, R at its end
/// @returns FINISHED or STOPPED
inline Task run(
    Scene& scene, Stepper<2>& stepper, const ProgramAt& program,
    const std::function<void()>& on_accept = [] {}) {
  for (;;) {
    const long pieces = stepper.counts().scheme.pieces;
    const Task task = stepper.next(scene.u, scene.R);
    if (stepper.counts().scheme.pieces != pieces) on_accept();
    if (task == Task::FINISHED || task == Task::STOPPED) return task;
    answer(task, scene, stepper, program);
  }
}

/// Solves one step by the verbs. @returns CONVERGED or FAILED
inline StepStatus converge(Scene& scene, double t, double dt, Stepping stepping) {
  ContactRun<2>& contact = scene.contact();
  contact.begin(scene.u, t, dt, stepping);
  StepStatus status = StepStatus::ITERATE;
  for (int it = 0; status != StepStatus::CONVERGED && status != StepStatus::FAILED; ++it) {
    if (scene.workpiece().update(scene.u, dt, it).status != UpdateStatus::OK) return StepStatus::FAILED;
    scene.R = scene.workpiece().internal_force();
    status = contact.check(scene.u, scene.R);
    if (status == StepStatus::REFACTORIZE && !factorize_tangent(contact, scene.workpiece(), scene.u))
      return StepStatus::FAILED;
    if (status == StepStatus::ITERATE || status == StepStatus::REFACTORIZE)
      if (contact.correct(scene.u, scene.R) == StepStatus::FAILED) status = StepStatus::FAILED;
  }
  return status;
}

inline void accept(Scene& scene, const std::vector<ContactEvent<2>>& events) {
  scene.body.accept();
  scene.contact().accept(scene.u, scene.R, events);
}

/// Back to the accepted state.
inline void revert(Scene& scene) {
  scene.body.revert();
  scene.contact().revert();
  scene.u = scene.contact().accepted().u;
}

} // namespace burnish::test
