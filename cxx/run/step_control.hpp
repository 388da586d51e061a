#pragma once
// Length of the next step: tied to the contact width, to failures and to output times (ALGORITHMS.md 1).
#include <limits>
#include <vector>

namespace burnish {

struct StepControlOptions {
  double t_end = 1;                 ///< end of the program
  double dt_max = 0;                ///< largest step; 0: t_end / 100
  double steps_per_width = 14;      ///< steps while the tool rolls one contact width; 0: no such limit
  double dt_min = 0;                ///< floor; 0: 1e-7 t_end
  std::vector<double> output_times; ///< hit exactly, besides t_end; ascending
  double dt_first = 0;              ///< first step; 0: a quarter of dt_max
  double accuracy =
      0; ///< relative error of the plastic strain increments that the steps are chosen for; 0: they are not
};

/// All that the control needs to go on. Plain data.
struct StepControlState {
  double t = 0;         ///< start of the step to come
  double dt = 0;        ///< its length
  double last_dt = 0;   ///< of the step before, or tried last
  double failed_dt = 0; ///< the length that failed last, while it limits the steps; 0: none does
  double cap = 0;       ///< largest step near it
  bool first = true;    ///< no step has been accepted
  // A step that failed once leaves the division of the program as it was.
  double width = 0; ///< contact width that counts
  double error = 0; ///< of the last steps, geometric mean; 0: not estimated
};

class StepControl {
public:
  /// @throws std::invalid_argument for t_end <= t_start, negative numbers, dt_min > dt_max
  StepControl(double t_start, StepControlOptions options);
  const StepControlOptions& options() const { return m_options; }
  const StepControlState& state() const { return m_state; }
  void set_state(const StepControlState& state) { m_state = state; }

  double time() const { return m_state.t; } ///< start of the step to come
  double start() const { return m_start; }  ///< of the program
  double dt() const { return m_state.dt; }  ///< its length
  bool finished() const;
  bool is_last() const;   ///< the step to come reaches the end
  bool at_output() const; ///< time() is an output time or the end
  /// Steps are far shorter than dt_max since one failed.
  bool crawls() const;
  /// Chooses the next step. @param width contact width [length]; @param speed of the contact along the body
  /// [length/time]; either 0: unknown
  double propose(double width, double speed);
  /// One more instant that a step ends at, in place of an earlier one; one that is past does not count.
  void stop_at(double t) { m_stop = t; }
  void accepted();
  /// Error of the step just accepted, for the lengths to come. @param error of the plastic strain increments [-]; 0: nothing
  /// flowed
  void steer(double error);
  /// Shortens the step. If the step before had not failed, the next ones end where this one should have, and go on with
  /// its length: where a step fails for once depends on rounding, the division of the program does not. @returns false at the floor (the run must stop)
  bool rejected();
  /// A step of that length, or up to the next instant to be hit, in place of those that failed.
  void retry(double dt);
  /// Takes only a part of the present step (an event in it), 0 < fraction <= 1.
  void cut(double fraction) { m_state.dt *= fraction; }

private:
  double next_stop() const;
  double wanted(double width, double speed);
  StepControlOptions m_options;
  double m_start;
  StepControlState m_state;
  double m_stop = -std::numeric_limits<double>::infinity();
};

} // namespace burnish
