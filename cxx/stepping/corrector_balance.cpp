// What counts as balance: the tolerance of the load, and of what every tool carries (ALGORITHMS.md 5.1).
#include "stepping/corrector.hpp"
#include <algorithm>

namespace burnish {
namespace {

Eigen::VectorXd larger(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  if (a.size() != b.size()) return a.size() > b.size() ? a : b;
  return a.cwiseMax(b);
}

} // namespace

// A billionth of what rounding leaves is no load at all: a tool under zero force.
template <int Dim> double Corrector<Dim>::allowed(double scale) const {
  const double capped = std::min(m_rounding, StepOptions().tolerance * scale);
  return std::max({m_options.tolerance * scale, capped, m_options.least_load * m_rounding});
}

// A tool that carries less than others is held to its own load, but to no less than what rounding leaves.
template <int Dim>
Eigen::VectorXd Corrector<Dim>::allowed_of_tools(double scale, const Eigen::VectorXd& tools) const {
  const double common = allowed(scale);
  Eigen::VectorXd result = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(m_model.tools.size()), common);
  for (Eigen::Index t = 0; t < tools.size(); ++t)
    if (tools[t] > m_options.least_tool_load * scale)
      result[t] = std::min(common, std::max(allowed(tools[t]), m_rounding));
  return result;
}

template <int Dim> Eigen::VectorXd Corrector<Dim>::tool_tolerance() const {
  return allowed_of_tools(std::max(m_load_scale, m_balance.load), larger(m_tool_load, m_balance.tool_load));
}

// Sets m_balance; returns the load scale, in which the load of this state counts in its own tolerance.
template <int Dim> double Corrector<Dim>::balance_at(const Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  const double h = m_body.spacing;
  double scale = m_load_scale;
  Eigen::VectorXd tools = m_tool_load;
  for (int pass = 0; pass < 2; ++pass) {
    m_balance = balance(m_model, m_body, m_state, m_prescribed, u, R,
                        {allowed(scale), m_options.gap_tolerance * h, m_options.offset_tolerance * h, m_held,
                         allowed_of_tools(scale, tools)});
    const Eigen::VectorXd grown = larger(tools, m_balance.tool_load);
    if (m_balance.load <= scale && grown == tools) break;
    scale = std::max(scale, m_balance.load);
    tools = grown;
  }
  return scale;
}

template <int Dim> void Corrector<Dim>::measure(const Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  m_load_scale = balance_at(u, R);
  m_tool_load = larger(m_tool_load, m_balance.tool_load);
}

// clang-format off
#define BURNISH_BALANCE(Dim)                                                                                           \
  template double Corrector<Dim>::allowed(double) const;                                                               \
  template Eigen::VectorXd Corrector<Dim>::allowed_of_tools(double, const Eigen::VectorXd&) const;                     \
  template Eigen::VectorXd Corrector<Dim>::tool_tolerance() const;                                                     \
  template double Corrector<Dim>::balance_at(const Eigen::VectorXd&, const Eigen::VectorXd&);                          \
  template void Corrector<Dim>::measure(const Eigen::VectorXd&, const Eigen::VectorXd&);
// clang-format on
BURNISH_BALANCE(2)
BURNISH_BALANCE(3)

} // namespace burnish
