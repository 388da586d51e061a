#include "contact/active_set.hpp"
#include "base/stop_request.hpp"
#include "contact/pass_choice.hpp"
#include "contact/support_by_friction.hpp"

namespace burnish {
namespace {

// A node that slid when the iteration began and slides again is where it was then: from a place to which a pass has taken it, or where
// it stuck, its way would be a chord of the tool.
template <int Dim> void slide_on(const ContactState<Dim>& start, ContactState<Dim>& trial) {
  for (std::size_t i = 0; i < trial.nodes.size(); ++i) {
    const ContactNode<Dim>& began = start.nodes[i];
    ContactNode<Dim>& node = trial.nodes[i];
    if (node.state == NodeState::SLIDING && began.state == NodeState::SLIDING && began.tool == node.tool)
      node.place = began.place;
  }
}

} // namespace

template <int Dim> WindowSolution<Dim> solve_window(const WindowProblem<Dim>& problem) {
  WindowSolution<Dim> solution, best;
  WindowSolver<Dim> solver(problem);
  SupportByFriction<Dim> support(problem);
  PassChoice<Dim> choice(*problem.model, *problem.window);
  ContactState<Dim> trial = *problem.start;
  std::vector<double> severity(trial.nodes.size());
  for (solution.passes = 1;; ++solution.passes) {
    if (problem.adapt) support.begin_pass(solver, trial);
    follow_ends(*problem.model, trial);
    if (!solver.solve(trial, solution)) {
      if (!problem.adapt || solution.passes >= problem.max_passes || !support.regain(trial)) break;
      continue;
    }
    if (!problem.adapt) break;
    const ContactState<Dim> before = trial;
    solution.left = solver.test(solution, trial, severity);
    if (solution.left == 0 && !solution.held_back) break;
    if (solution.left == 0) {
      solver.let_run();
      continue;
    }
    if (best.F.size() == 0 || solution.left < best.left) best = solution;
    if (solution.passes >= problem.max_passes) break;
    if ((solution.stopped = stop_asked())) return solution;
    choice.choose(before, severity, trial);
    if (choice.cycles()) support.leave_cycle(solver, before, solution.left, trial);
    solver.note_released(before, trial);
    slide_on(*problem.start, trial);
    support.note_refused(before, trial);
  }
  // The one that contradicts itself least; also where a pass has lost what holds a tool in space, or all that holds the body: the
  // next iteration knows other forces and directions.
  if (solution.singular ? (Dim == 3 || support.is_lost(trial)) && best.F.size() > 0 : solution.left > 0) {
    best.passes = solution.passes;
    solution = std::move(best);
  }
  if (solution.singular) solution.state = trial;
  return solution;
}

template WindowSolution<2> solve_window<2>(const WindowProblem<2>&);
template WindowSolution<3> solve_window<3>(const WindowProblem<3>&);

} // namespace burnish
