#pragma once
// summary.json of a run: what the run and its diagnosis know of themselves; a script adds what it knows.
#include "diagnosis/diagnosis.hpp"
#include "run/stepper.hpp"
#include <nlohmann/json.hpp>

namespace burnish {

using Json = nlohmann::ordered_json;

/// What a summary is made of, all of one run; refers to what must outlive the call.
struct SummarizedRun {
  const ContactRun<2>& contact;
  const Workpiece<2>& workpiece;
  const Diagnosis<2>& diagnosis;
  const StepControl& control;
  const Stepper<2>* stepper; ///< null: no run of a stepcontrol was begun
  const std::vector<Statement>& report;
  const CondensedSystem* condensed;      ///< the last one; null: none
  std::string warnings;                  ///< of the material's numbers, a line each
  bool has_damage;                       ///< some event damages
  Vector<2> about;                       ///< point of the moments [length]
  std::map<std::string, double> seconds; ///< CPU by phase [s]
};

/// The keys of edp/cases/rcSummary.idp but those that only a script knows.
Json run_summary(const SummarizedRun& run);
/// Versions of what is in use, by package.
Json versions();
/// Writes an object whole, a line for each of its keys; NaN and Inf as null. @throws FileError
void save_summary(const Json& summary, const std::string& path);

} // namespace burnish
