#include "run/step_control.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Rounding of times, over the largest at hand.
constexpr double SAME_TIME = 1e-9, AT_END = 1e-12;

constexpr double STEPS_PER_PROGRAM = 100; // dt_max, if it is not given, is the program over this
constexpr double FLOOR = 1e-7;            // dt_min, if it is not given, over the program
constexpr double FIRST = 0.25;            // first step over dt_max
constexpr double GROWTH = 1.3;            // largest ratio of neighboring steps
// Least ratio of neighboring steps where the contact's width asks for shorter ones.
constexpr double SHRINK = 0.5;
constexpr double RETRY = 0.5;       // a failed step is tried again with this part of its length
constexpr double CAUTION = 0.7;     // after a failure steps may be this part of the failed one, ...
constexpr double RELAXATION = 1.05; // ... growing by this factor a step until they are as long as it
constexpr double COARSEST = 4;      // steps_per_width at most, where an accuracy is given
constexpr double STEER_POWER = 0.4; // power of accuracy over error that the next step is multiplied by, ...
constexpr double STEER_LEAST = 0.75, STEER_MOST = 1.15; // ... within these bounds
// Part of the last width in the one that counts: one node more is no jump of the step.
constexpr double WIDTH_MEMORY = 0.75;
constexpr double CRAWL = 0.02; // a run crawls while its steps are below this part of dt_max after a failure

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
  if (o.dt_max == 0) o.dt_max = (o.t_end - t_start) / STEPS_PER_PROGRAM;
  if (o.dt_min == 0) o.dt_min = FLOOR * (o.t_end - t_start);
  require(o.dt_min > 0 && o.dt_min <= o.dt_max, "StepControl", "dt_min", o.dt_min, "0 < dt_min <= dt_max");
  if (o.dt_first == 0) o.dt_first = std::max(FIRST * o.dt_max, o.dt_min);
  require(o.dt_first >= o.dt_min && o.dt_first <= o.dt_max, "StepControl", "dt_first", o.dt_first,
          "dt_min <= dt_first <= dt_max");
  require(o.steps_per_width >= 0, "StepControl", "steps_per_width", o.steps_per_width, ">= 0");
  require(o.accuracy >= 0, "StepControl", "accuracy", o.accuracy, ">= 0");
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

bool StepControl::crawls() const { return m_state.failed_dt > 0 && m_state.dt < CRAWL * m_options.dt_max; }

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
  dt = std::min(dt, s.first ? o.dt_first : GROWTH * s.last_dt);
  const double kept = s.width > 0 && width > 0 ? WIDTH_MEMORY : 0;
  s.width = kept * s.width + (1 - kept) * width;
  double per_width = o.steps_per_width;
  if (o.accuracy > 0) per_width = std::min(per_width, COARSEST);
  if (!s.first && per_width > 0 && s.width > 0 && speed > 0)
    dt = std::min(dt, std::max(s.width / per_width / speed, SHRINK * s.last_dt));
  if (o.accuracy > 0 && s.error > 0) {
    const double factor = std::pow(o.accuracy / s.error, STEER_POWER);
    dt = std::min(dt, std::clamp(factor, STEER_LEAST, STEER_MOST) * s.last_dt);
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
  s.cap *= RELAXATION;
  if (s.cap >= s.failed_dt) s.failed_dt = 0; // past the length that failed: growth is free again
}

void StepControl::steer(double error) {
  auto& s = m_state;
  s.error = s.error > 0 && error > 0 ? std::sqrt(s.error * error) : error;
}

void StepControl::retry(double dt) {
  auto& s = m_state;
  s.dt = s.last_dt = std::min(std::max(dt, m_options.dt_min), next_stop() - s.t);
  s.failed_dt = 0;
}

bool StepControl::rejected() {
  auto& s = m_state;
  s.failed_dt = s.dt;
  s.cap = CAUTION * s.dt;
  s.dt *= RETRY;
  s.last_dt = s.dt;
  return s.dt >= m_options.dt_min;
}

} // namespace burnish
