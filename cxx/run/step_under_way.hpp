#pragma once
// A step between begin and accept.
#include "contact/contact_state.hpp"
#include "iteration/options.hpp"
#include "iteration/predictor.hpp"
#include "run/event_log.hpp"

namespace burnish {

template <int Dim> struct StepUnderWay {
  enum class Stage { NONE, BEGUN, CHECKED } stage = Stage::NONE; ///< what it has seen
  Stepping stepping = Stepping::IMPLICIT;
  double t = 0, dt = 0;              ///< its start and its length [time]
  Eigen::VectorXd u_start;           ///< displacement at its start [length]
  PrescribedValues prescribed;       ///< at its end
  PrescribedValues prescribed_start; ///< at its start, in the kinds of its end
  std::vector<std::string> left_out; ///< coordinates that nothing resists
  PredictedWays ways;
  EventLog<Dim> log;

  double end() const { return t + dt; }
  /// @throws std::invalid_argument "where: ..." unless a step has been begun, or has been checked
  void require_begun(const char* where) const;
  void require_checked(const char* where) const;
};

} // namespace burnish
