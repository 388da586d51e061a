// What a step that balances is refused for, and why one fails.
#include "stepping/contact_run.hpp"
#include "stepping/failure_reason.hpp"
#include "stepping/leaps.hpp"

namespace burnish {

// An equilibrium that the step has no way to: beyond a body that a tool has passed, or beyond a limit load.
template <int Dim> std::string ContactRun<Dim>::leaps(const Eigen::VectorXd& u) const {
  const SteppedPath<Dim> path{&m_accepted.contact, &m_corrector.state(), &m_u_start, &u};
  const std::string passage = tool_passage(*m_setup, path);
  if (!passage.empty() || m_stepping == Stepping::RATES) return passage;
  const std::string jump = body_jump(*m_setup, path, m_hold.acts(t_end()), m_corrector.options());
  if (!jump.empty()) return jump;
  return sudden_jump(*m_setup, path, m_prescribed,
                     {m_dt, m_accepted.history.dt, m_accepted.history.dq, m_corrector.first_increment()},
                     m_corrector.options());
}

template <int Dim> StepStatus ContactRun<Dim>::check_rates(const Eigen::VectorXd& u) {
  const std::string leap = leaps(u);
  return leap.empty() ? StepStatus::CONVERGED : m_corrector.give_up(leap);
}

template <int Dim> std::string ContactRun<Dim>::reason(const std::string& of_body) const {
  const ContactState<Dim>& state = m_accepted.contact;
  const FailedStep<Dim> step{&state, &m_prescribed, &m_accepted.prescribed, m_t, m_dt, m_largest_dt};
  std::string cause = program_jump(*m_setup, step); // the first cause first
  if (cause.empty()) cause = pulling_force(*m_setup, state, m_prescribed);
  if (cause.empty() && !m_hold.acts(t_end())) cause = unheld_workpiece(*m_setup, state, m_accepted.u);
  if (cause.empty()) cause = of_body;
  const std::string& found = m_corrector.reason();
  if (cause.empty() && found.find("limit load") == std::string::npos)
    cause = m_accepted.drives.exhausted(*m_setup, m_accepted.prescribed, m_prescribed);
  if (found.empty()) return cause; // the material could not follow
  if (!cause.empty())
    return found.find(cause.substr(0, cause.find(':'))) == 0 ? cause : cause + " (" + found + ")";
  std::string last;
  if (found.find("limit load") != std::string::npos && m_accepted.history.dt > 0)
    last =
        "; " + last_equilibrium(*m_setup, m_accepted.prescribed, state.q, m_accepted.generalized_force, m_t);
  const std::string end = end_of_tool(*m_setup, state);
  const bool cycles = found.find("inconsistent contact states") != std::string::npos ||
                      found.find("not held") != std::string::npos;
  return found + last + (end.empty() && cycles ? hangs_on_few(*m_setup, state) : end);
}

template std::string ContactRun<2>::leaps(const Eigen::VectorXd&) const;
template std::string ContactRun<3>::leaps(const Eigen::VectorXd&) const;
template StepStatus ContactRun<2>::check_rates(const Eigen::VectorXd&);
template StepStatus ContactRun<3>::check_rates(const Eigen::VectorXd&);
template std::string ContactRun<2>::reason(const std::string&) const;
template std::string ContactRun<3>::reason(const std::string&) const;

} // namespace burnish
