#pragma once
// summary.json of a run: what the run and its diagnosis know of themselves; a script adds what it knows.
#include "diagnosis/diagnosis.hpp"
#include "run/stepper.hpp"
#include <nlohmann/json.hpp>

namespace burnish {

using Json = nlohmann::ordered_json;

/// What a summary is made of, all of one run; refers to what must outlive the call.
template <int Dim> struct SummarizedRun {
  const ContactRun<Dim>& contact;
  const Workpiece<Dim>& workpiece;
  const Diagnosis<Dim>& diagnosis;
  const StepControl& control;
  const StepLoop* stepper; ///< null: no run of a stepcontrol was begun
  const std::vector<Statement>& report;
  const CondensedSystem* condensed;      ///< the last one; null: none
  std::string warnings;                  ///< of the material's numbers, a line each
  bool has_damage;                       ///< some event damages
  Vector<Dim> about;                     ///< point of the moments [length]
  std::map<std::string, double> seconds; ///< CPU by phase [s]
};

/// The keys of edp/cases/rcSummary.idp but those that only a script knows. A place has Dim numbers, a resultant the components of the
/// force and those of the moment: in the plane 3, in space 6.
template <int Dim = 2> Json run_summary(const SummarizedRun<Dim>& run);
/// Versions of what is in use, by package.
Json versions();
/// Writes an object whole, a line for each of its keys; NaN and Inf as null. @throws FileError
void save_summary(const Json& summary, const std::string& path);

} // namespace burnish
