#pragma once
// The self-checks of a run: each looks at every accepted step (ALGORITHMS.md 16). Called by the Stepper.
#include "base/findings.hpp"
#include "checks/accepted_step.hpp"
#include "checks/check_options.hpp"
#include "checks/check_state.hpp"
#include <memory>

namespace burnish {

/// One check. What it has to remember is in CheckState; members of its own are lists made from the mesh.
template <int Dim> class Check {
public:
  virtual ~Check() = default;
  /// The state at the start of the run. @param step prepared
  virtual void begin(const AcceptedStep<Dim>&, CheckState&) {}
  /// @param step prepared; @param state, findings what it adds to
  virtual void look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                    FindingList& findings) = 0;
};

template <int Dim> class RunChecks {
public:
  RunChecks();
  ~RunChecks();
  CheckOptions& options() { return m_options; }
  const CheckOptions& options() const { return m_options; }
  /// Before every step; the first one counts: energies are those of the run.
  void begin(AcceptedStep<Dim> step);
  bool begun() const { return m_state.begun; }
  /// Looks at an accepted step. @param step prepared here; @param findings what is added to
  void look(AcceptedStep<Dim>& step, FindingList& findings);
  /// Why the run cannot go on; "": it can.
  const std::string& stop() const { return m_state.stop; }
  const CheckState& state() const { return m_state; }
  void set_state(const CheckState& state) { m_state = state; }
  double seconds() const { return m_seconds; } ///< CPU of all looks [s]

private:
  CheckOptions m_options;
  CheckState m_state;
  std::vector<std::unique_ptr<Check<Dim>>> m_checks;
  double m_seconds = 0;
};

} // namespace burnish
