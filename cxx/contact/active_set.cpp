#include "contact/active_set.hpp"
#include "base/stop_request.hpp"
#include "contact/pass_choice.hpp"
#include "contact/tool_support.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr int MAX_NEUTRAL_TRIALS = 4; // a neutral point is looked for that often (stick_at_neutral_point)
constexpr int SETTLED = 4;            // iterations after which no neutral point is looked for in space
constexpr int MAX_LOSSES = 4;         // passes that have lost the last node that stuck, and go on

// Nodes that could not stick.
template <int Dim>
void note_refused(const ContactState<Dim>& before, const ContactState<Dim>& after,
                  std::vector<char>& refused) {
  for (std::size_t i = 0; i < refused.size(); ++i)
    refused[i] = refused[i] || (sticks(before.nodes[i].state) && after.nodes[i].state == NodeState::SLIDING);
}

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

// Whether no node sticks, but for those of some tools.
template <int Dim> bool none_sticks(const ContactState<Dim>& state, const std::vector<char>& without = {}) {
  return std::none_of(state.nodes.begin(), state.nodes.end(), [&](const auto& node) {
    return sticks(node.state) && (without.empty() || !without[node.tool]);
  });
}

} // namespace

template <int Dim> WindowSolution<Dim> solve_window(const WindowProblem<Dim>& problem) {
  WindowSolution<Dim> solution;
  const ContactModel<Dim>& model = *problem.model;
  const ContactState<Dim>& state = *problem.start;
  WindowSolver<Dim> solver(problem);
  ContactState<Dim> trial = state;
  std::vector<char> refused(state.nodes.size(), 0); // nodes that could not stick
  const bool turns =
      Dim == 3 && problem.iteration > 0 && (problem.iteration >= SETTLED || none_sticks(state));
  int trials = turns ? MAX_NEUTRAL_TRIALS : 0, supports = 0, losses = 0;
  const bool by_friction = problem.added_stiffness.size() > 0; // holds the body
  std::vector<char> idle; // tools that friction holds, and that hold nothing by it
  if (by_friction) idle = held_by_friction(model, *problem.prescribed, state);
  PassChoice<Dim> choice(model, *problem.window);
  std::vector<double> severity(state.nodes.size());
  WindowSolution<Dim> best;
  for (solution.passes = 1;; ++solution.passes) {
    if (problem.adapt) relieve_vertices(model, trial);
    while (problem.adapt && (Dim == 2 || supports < MAX_SUPPORTS) &&
           stick_unsupported(model, *problem.prescribed, trial, refused, solver.turning(), true) >= 0)
      ++supports;
    if (problem.adapt && problem.added_stiffness.size() > 0 && trials < MAX_NEUTRAL_TRIALS)
      trials += stick_at_neutral_point(model, trial, refused);
    follow_ends(model, trial);
    if (!solver.solve(trial, solution)) {
      if (!problem.adapt || solution.passes >= problem.max_passes) break;
      if (by_friction && none_sticks(trial, idle) && ++losses <= MAX_LOSSES) {
        refused.assign(refused.size(), 0);
        if (stick_at_neutral_point(model, trial, refused, &idle)) continue;
      }
      if (Dim == 2 || stick_unsupported(model, *problem.prescribed, trial, refused, {}, true) < 0) break;
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
    solver.note_released(before, trial);
    slide_on(state, trial);
    note_refused(before, trial, refused);
  }
  // The one that contradicts itself least; also where a pass has lost what holds a tool in space, or all that holds the body: the
  // next iteration knows other forces and directions.
  const bool goes_on = Dim == 3 || (by_friction && none_sticks(trial, idle));
  if (solution.singular ? goes_on && best.F.size() > 0 : solution.left > 0) {
    best.passes = solution.passes;
    solution = std::move(best);
  }
  if (solution.singular) solution.state = trial;
  return solution;
}

template WindowSolution<2> solve_window<2>(const WindowProblem<2>&);
template WindowSolution<3> solve_window<3>(const WindowProblem<3>&);

} // namespace burnish
