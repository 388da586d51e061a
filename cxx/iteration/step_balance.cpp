#include "iteration/step_balance.hpp"

namespace burnish {
namespace {

constexpr double LEAST_LOAD = 1e-9; // a load below this part of what rounding leaves is none
constexpr double LEAST_TOOL_LOAD =
    1e-7;                         // a tool with less than this part of the load has the tolerance of the load
constexpr double STATE_GAP = 0.5; // tolerance of gaps in the state tests over gap_tolerance
constexpr double STATE_SLIP = 0.1; // tolerance of backward slips there over that of gaps

Eigen::VectorXd larger(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  if (a.size() != b.size()) return a.size() > b.size() ? a : b;
  return a.cwiseMax(b);
}

} // namespace

// A billionth of what rounding leaves is no load at all: a tool under zero force.
template <int Dim> double StepBalance<Dim>::allowed(double scale) const {
  const double capped = std::min(m_memory.rounding, IterationOptions().tolerance * scale);
  return std::max({m_options.tolerance * scale, capped, LEAST_LOAD * m_memory.rounding});
}

// A tool that carries less than others is held to its own load, but to no less than what rounding leaves.
template <int Dim>
Eigen::VectorXd StepBalance<Dim>::allowed_of_tools(double scale, const Eigen::VectorXd& tools) const {
  const double common = allowed(scale);
  Eigen::VectorXd result = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(m_model.tools.size()), common);
  for (Eigen::Index t = 0; t < tools.size(); ++t)
    if (tools[t] > LEAST_TOOL_LOAD * scale)
      result[t] = std::min(common, std::max(allowed(tools[t]), m_memory.rounding));
  return result;
}

template <int Dim> Tolerances StepBalance<Dim>::tolerances(double scale, const Eigen::VectorXd& tools) const {
  const double h = m_body.spacing, slip = m_options.gap_tolerance * h,
               offset = m_options.offset_tolerance * h;
  const double coarse = std::min(1., m_options.tolerance / IterationOptions().tolerance) * offset;
  return {allowed(scale), m_coarse_gaps ? std::max(slip, coarse) : slip, slip, offset,
          allowed_of_tools(scale, tools)};
}

template <int Dim> Tolerances StepBalance<Dim>::tolerances() const {
  return tolerances(scale(), larger(m_memory.tools, m_last.tool_load));
}

template <int Dim> Tolerances StepBalance<Dim>::state_tolerances() const {
  Tolerances result = tolerances();
  result.force *= STATE_FORCE;
  result.tool_force *= STATE_FORCE;
  result.gap *= STATE_GAP;
  result.slip *= STATE_GAP * STATE_SLIP;
  return result;
}

// The load of an iterate counts in its own tolerance.
template <int Dim>
void StepBalance<Dim>::look(const ContactState<Dim>& state, const PrescribedValues& prescribed,
                            const Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  double scale = m_memory.scale;
  Eigen::VectorXd tools = m_memory.tools;
  for (int pass = 0; pass < 2; ++pass) {
    m_last = balance<Dim>({m_model, m_body, state, prescribed, u, R, tolerances(scale, tools), m_held});
    const Eigen::VectorXd grown = larger(tools, m_last.tool_load);
    if (m_last.load <= scale && grown == tools) break;
    scale = std::max(scale, m_last.load);
    tools = grown;
  }
}

template <int Dim> void StepBalance<Dim>::remember() {
  m_memory.scale = scale();
  m_memory.tools = larger(m_memory.tools, m_last.tool_load);
}

template class StepBalance<2>;
template class StepBalance<3>;

} // namespace burnish
