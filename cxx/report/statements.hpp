#pragma once
// What is said of a scene at the end of its run (ALGORITHMS.md 17).
#include "base/findings.hpp"
#include "checks/accepted_step.hpp"
#include "checks/check_state.hpp"
#include "report/report_options.hpp"
#include "report/scene_state.hpp"

namespace burnish {

enum class StatementKind {
  NEEDED,     ///< needed and not modelled
  NOT_NEEDED, ///< modelled and not needed
  LEAN,       ///< left out of itself
};
/// "needed and not modelled", "modelled and not needed", "lean".
const char* name_of(StatementKind kind);

struct Statement {
  StatementKind kind = StatementKind::LEAN;
  std::string name;      ///< of the statement, and of its subject
  double value = 0;      ///< the number that it rests on
  double importance = 0; ///< larger comes first
  std::string text;      ///< a sentence, with the number and the option that changes it
};

/// Error of the steps, estimated, and the one asked for, both relative; NaN: unknown, nothing is said of it.
struct StepAccuracy {
  double error = Finding::NONE, asked = Finding::NONE;
  bool given = false; ///< the script has stated the accuracy; else it is the bound of the warning
  bool longest =
      true; ///< on average the steps are at least half as long as they may be: nothing else keeps them short
};

/// What the statements rest on; refers to what belongs to the run.
template <int Dim> struct ReportedRun {
  const AcceptedStep<Dim>& step; ///< the last one; need not be prepared
  const SceneState& scene;
  const CheckState& checks;
  const FindingList& findings; ///< what is a finding already is not said again
  const ReportOptions& options;
  StepAccuracy accuracy;
};

/// The most important first, at most ReportOptions::most; none before the first step.
template <int Dim> std::vector<Statement> statements(const ReportedRun<Dim>& run);

/// The two parts of it, in any order.
template <int Dim> std::vector<Statement> modelled_in_vain(const ReportedRun<Dim>& run);
template <int Dim> std::vector<Statement> not_modelled(const ReportedRun<Dim>& run);

/// Three significant digits.
std::string short_number(double value);

} // namespace burnish
