#include "stepping/step_control.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

StepControl::StepControl(double t_start, StepControlOptions options)
    : m_options(std::move(options)), m_t(t_start) {
  auto& o = m_options;
  require(o.t_end > t_start, "StepControl", "t_end", o.t_end, "later than the start");
  if (o.dt_max == 0) o.dt_max = (o.t_end - t_start) / 100;
  if (o.dt_min == 0) o.dt_min = 1e-7 * (o.t_end - t_start);
  require(o.dt_min > 0 && o.dt_min <= o.dt_max, "StepControl", "dt_min", o.dt_min, "0 < dt_min <= dt_max");
  require(o.steps_per_width >= 0, "StepControl", "steps_per_width", o.steps_per_width, ">= 0");
  require(o.growth > 1, "StepControl", "growth", o.growth, "> 1");
  m_cap = o.dt_max;
}

double StepControl::next_stop() const {
  double stop = m_options.t_end;
  const double tiny = 1e-9 * m_options.t_end;
  for (const double t : m_options.output_times)
    if (t > m_t + tiny) stop = std::min(stop, t);
  return stop;
}

bool StepControl::finished() const { return m_t >= m_options.t_end * (1 - 1e-12); }

bool StepControl::at_output() const {
  const double tiny = 1e-9 * m_options.t_end;
  for (const double t : m_options.output_times)
    if (std::abs(t - m_t) <= tiny) return true;
  return finished();
}

double StepControl::propose(double width, double speed) {
  double dt = std::min(m_options.dt_max, m_cap);
  if (m_first)
    dt = std::min(dt, m_options.dt_max / 4);
  else
    dt = std::min(dt, m_options.growth * m_last_dt);
  if (!m_first && m_options.steps_per_width > 0 && width > 0 && speed > 0)
    dt = std::min(dt, std::max(width / m_options.steps_per_width / speed, 0.5 * m_last_dt));
  dt = std::max(dt, m_options.dt_min);
  const double rest = next_stop() - m_t;
  if (dt > rest * (1 - 1e-9))
    dt = rest;
  else if (2 * dt > rest)
    dt = 0.5 * rest; // less than two steps remain: split evenly
  return m_dt = dt;
}

void StepControl::accepted() {
  m_t += m_dt;
  const double stop = next_stop();
  if (std::abs(m_t - stop) < 1e-12 * m_options.t_end) m_t = stop;
  m_last_dt = m_dt;
  m_cap = std::min(m_options.dt_max, m_cap * 1.05);
  m_first = false;
}

bool StepControl::rejected() {
  m_cap = 0.7 * m_dt;
  m_dt *= 0.5;
  m_last_dt = m_dt;
  return m_dt >= m_options.dt_min;
}

} // namespace burnish
