#include "iteration/tangent_policy.hpp"
#include <algorithm>
#include <array>

namespace burnish {
namespace {

constexpr double GROWS = 2;      // residual ratio from which an iteration goes back or takes a new tangent
constexpr int RATE_WINDOW = 4;   // iterations that the rate of convergence is measured over
constexpr double RATE_BOUND = 8; // a new tangent is taken where that rate leaves more iterations than this
// Condensed: part of elastic moduli after 0, 1, 2, ... iterations that were slow
constexpr std::array<double, 4> BLEND_BY_SLOWNESS{0, 0.2, 0.2, 0.4};
// The same after 0, 1, 2, ... losses of definiteness in a row (ALGORITHMS.md 5.2)
constexpr std::array<double, 4> BLEND_BY_FAILURE{0, 0.05, 0.2, 0.8};
constexpr double CONDENSED_SLOW =
    0.7; // condensed iterations: a residual that falls by less takes more elastic moduli
constexpr int CONDENSED_FALLS = 3; // after so many that fall by more none are taken again

} // namespace

void TangentPolicy::begin() {
  *this = TangentPolicy();
  m_rate = ConvergenceRate(RATE_WINDOW, RATE_BOUND);
}

void TangentPolicy::look(double residual, double allowed) {
  m_lags = !m_condensed && m_rate.slow(residual, allowed);
  m_grows = m_last >= 0 && residual > allowed && residual > GROWS * m_last;
  m_grown = m_grown || m_grows;
}

void TangentPolicy::go_on(double residual) {
  if (m_condensed && m_last >= 0) {
    if (residual > CONDENSED_SLOW * m_last) {
      ++m_slow;
      m_falls = 0;
    } else if (++m_falls >= CONDENSED_FALLS) {
      m_slow = 0;
    }
  }
  m_last = residual;
}

void TangentPolicy::factored(bool definite) {
  m_rate.clear();
  m_indefinite = definite ? 0 : m_indefinite + 1;
}

double TangentPolicy::elastic_blend() const {
  const auto entry = [](const std::array<double, 4>& table, int i) { return table[std::min(i, 3)]; };
  return std::max(entry(BLEND_BY_SLOWNESS, m_slow), entry(BLEND_BY_FAILURE, m_indefinite));
}

} // namespace burnish
