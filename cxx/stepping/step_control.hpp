#pragma once
// Length of the next step: tied to the contact width, to failures and to output times (algorithms.md section
// 1).
#include <string>
#include <vector>

namespace burnish {

struct StepControlOptions {
  double t_end = 1;                 ///< end of the program
  double dt_max = 0;                ///< largest step; 0: t_end / 100
  double steps_per_width = 14;      ///< steps while the tool rolls one contact width; 0: no such limit
  double growth = 1.3;              ///< largest ratio of neighboring steps
  double dt_min = 0;                ///< floor; 0: 1e-7 t_end
  std::vector<double> output_times; ///< hit exactly, besides t_end; ascending
};

/// Plain data, can be written and read.
class StepControl {
public:
  /// @throws std::invalid_argument for t_end <= t_start, negative numbers, dt_min > dt_max
  StepControl(double t_start, StepControlOptions options);
  double time() const { return m_t; } ///< start of the step to come
  double dt() const { return m_dt; }  ///< its length
  bool finished() const;
  bool at_output() const; ///< time() is an output time or the end
  /// Chooses the next step. @param width contact width [length]; @param speed of the contact along the body
  /// [length/time]; either 0: unknown
  double propose(double width, double speed);
  void accepted();
  /// Halves the step. @returns false at the floor (the run must stop)
  bool rejected();
  /// Takes only a part of the present step (an event in it), 0 < fraction <= 1.
  void cut(double fraction) { m_dt *= fraction; }

private:
  double next_stop() const;
  StepControlOptions m_options;
  double m_t, m_dt = 0, m_last_dt = 0, m_cap;
  bool m_first = true;
};

} // namespace burnish
