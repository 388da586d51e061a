#pragma once
// What is said of a scene at the end of its run (ALGORITHMS.md 17).
#include "diagnosis/accepted_step.hpp"
#include "diagnosis/findings.hpp"

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

/// What the statements rest on beside what the observers have seen; refers to what belongs to the run.
template <int Dim> struct EndedRun {
  const AcceptedStep<Dim>& step; ///< the last one; need not be prepared
  const FindingList& findings;   ///< what is a finding already is not said again
  StepAccuracy accuracy;
};

/// Three significant digits.
std::string short_number(double value);

} // namespace burnish
