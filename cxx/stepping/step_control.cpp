#include "stepping/step_control.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Rounding of times, over the largest at hand.
constexpr double SAME_TIME = 1e-9, AT_END = 1e-12;

// That scale: the end of a program, which may be zero or negative, the present time, or the step.
double scale(const StepControlOptions& o, const StepControlState& s) {
  return std::max({std::abs(o.t_end), std::abs(s.t), s.dt});
}

} // namespace

StepControl::StepControl(double t_start, StepControlOptions options)
    : m_options(std::move(options)), m_start(t_start) {
  auto& o = m_options;
  m_state.t = t_start;
  require(o.t_end > t_start, "StepControl", "t_end", o.t_end, "later than the start");
  if (o.dt_max == 0) o.dt_max = (o.t_end - t_start) / o.steps_per_program;
  if (o.dt_min == 0) o.dt_min = o.floor * (o.t_end - t_start);
  require(o.dt_min > 0 && o.dt_min <= o.dt_max, "StepControl", "dt_min", o.dt_min, "0 < dt_min <= dt_max");
  if (o.dt_first == 0) o.dt_first = std::max(o.first * o.dt_max, o.dt_min);
  require(o.dt_first >= o.dt_min && o.dt_first <= o.dt_max, "StepControl", "dt_first", o.dt_first,
          "dt_min <= dt_first <= dt_max");
  require(o.steps_per_width >= 0, "StepControl", "steps_per_width", o.steps_per_width, ">= 0");
  require(o.accuracy >= 0, "StepControl", "accuracy", o.accuracy, ">= 0");
  require(o.growth > 1, "StepControl", "growth", o.growth, "> 1");
}

double StepControl::next_stop() const {
  const double same = SAME_TIME * scale(m_options, m_state);
  double stop = m_options.t_end;
  for (const double t : m_options.output_times)
    if (t > m_state.t + same) stop = std::min(stop, t);
  if (m_stop > m_state.t + same) stop = std::min(stop, m_stop);
  return stop;
}

bool StepControl::finished() const {
  return m_state.t >= m_options.t_end - AT_END * scale(m_options, m_state);
}

bool StepControl::is_last() const {
  return m_state.t + m_state.dt >= m_options.t_end - SAME_TIME * scale(m_options, m_state);
}

bool StepControl::at_output() const {
  const double same = SAME_TIME * scale(m_options, m_state);
  for (const double t : m_options.output_times)
    if (std::abs(t - m_state.t) <= same) return true;
  return finished();
}

// Length without regard to instants to be hit.
double StepControl::wanted(double width, double speed) {
  const auto& o = m_options;
  auto& s = m_state;
  double dt = o.dt_max;
  if (s.failed_dt > 0) dt = std::min(dt, s.cap);
  dt = std::min(dt, s.first ? o.dt_first : o.growth * s.last_dt);
  const double kept = s.width > 0 && width > 0 ? o.width_memory : 0;
  s.width = kept * s.width + (1 - kept) * width;
  double per_width = o.steps_per_width;
  if (o.accuracy > 0) per_width = std::min(per_width, o.coarsest);
  if (!s.first && per_width > 0 && s.width > 0 && speed > 0)
    dt = std::min(dt, std::max(s.width / per_width / speed, o.shrink * s.last_dt));
  if (o.accuracy > 0 && s.error > 0) {
    const double factor = std::pow(o.accuracy / s.error, o.steer_power);
    dt = std::min(dt, std::clamp(factor, o.steer_least, o.steer_most) * s.last_dt);
  }
  return std::max(dt, o.dt_min);
}

double StepControl::propose(double width, double speed) {
  auto& s = m_state;
  double dt = wanted(width, speed);
  const double rest = next_stop() - s.t;
  if (dt > rest * (1 - SAME_TIME))
    dt = rest;
  else if (2 * dt > rest)
    dt = 0.5 * rest; // less than two steps remain: split evenly
  return s.dt = dt;
}

void StepControl::accepted() {
  auto& s = m_state;
  s.t += s.dt;
  const double stop = next_stop();
  if (std::abs(s.t - stop) < AT_END * scale(m_options, s)) s.t = stop;
  s.last_dt = s.dt;
  s.first = false;
  s.cap *= m_options.relaxation;
  if (s.cap >= s.failed_dt) s.failed_dt = 0; // past the length that failed: growth is free again
}

void StepControl::steer(double error) {
  auto& s = m_state;
  s.error = s.error > 0 && error > 0 ? std::sqrt(s.error * error) : error;
}

bool StepControl::rejected() {
  auto& s = m_state;
  s.failed_dt = s.dt;
  s.cap = m_options.caution * s.dt;
  s.dt *= m_options.retry;
  s.last_dt = s.dt;
  return s.dt >= m_options.dt_min;
}

} // namespace burnish
