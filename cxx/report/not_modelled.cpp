// Needed and not modelled. What a self-check reports is not said again.
#include "report/statements.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/stress_error.hpp"
#include "workpiece/volume_percentile.hpp"
#include <algorithm>

namespace burnish {
namespace {

using List = std::vector<Statement>;

bool found(const FindingList& findings, const std::string& check, const std::string& subject) {
  return std::any_of(findings.list().begin(), findings.list().end(),
                     [&](const Finding& f) { return f.check == check && f.subject == subject; });
}

template <int Dim> void say_of_ends(const ReportedRun<Dim>& run, List& list) {
  for (int tool = 0; tool < static_cast<int>(run.scene.ends.size()); ++tool) {
    const EndLoad& end = run.scene.ends[tool];
    const double share = end.load > 0 ? end.force / end.load : 0;
    if (!(share > run.options.end_load)) continue;
    const std::string name = run.step.tool_name(tool);
    list.push_back({StatementKind::NEEDED, "end of surface " + name, share, 95,
                    "the last node of the contact surface, at " + place_text(end.place) + ", carries " +
                        short_number(100 * share) + " % of the largest load of tool \"" + name +
                        "\" at t = " + short_number(end.t) +
                        ": what lies beyond it touches nothing, label= may take it in"});
  }
}

template <int Dim> void say_of_stress(const ReportedRun<Dim>& run, List& list) {
  if (run.scene.stress.empty() || found(run.findings, "locking", "")) return; // P1 that locks: said already
  const Discretization<Dim>& space = run.step.workpiece.discretization();
  const StressError error = stress_error(space, run.scene.stress);
  if (!(error.relative > run.options.stress_error)) return;
  Vector<Dim> place = Vector<Dim>::Zero();
  for (int v = 0; v <= Dim; ++v) place += space.node(space.element(error.worst)[v]) / (Dim + 1);
  list.push_back({StatementKind::NEEDED, "stress error", error.relative, 85,
                  "the mesh is coarser than the stress gradient: stress and its nodal recovery differ by " +
                      short_number(100 * error.relative) + " % at t = " + short_number(run.scene.load_t) +
                      ", most in the element at " + place_text(run.step.place_of(place)) +
                      " of the undeformed body: a finer mesh there resolves it"});
}

// What no node confirms: the largest value of all points beside the largest nodal one.
template <int Dim> struct Largest {
  double point = 0, nodal = 0, part = 0; // part: most of the volume lies below
  std::string place;
  double ratio() const { return nodal > 0 ? point / nodal : 1; }
};

template <int Dim>
Largest<Dim> largest(const ReportedRun<Dim>& run, const Eigen::VectorXd& values, double least) {
  const Discretization<Dim>& space = run.step.workpiece.discretization();
  Eigen::Index p = 0;
  Largest<Dim> result;
  result.point = values.maxCoeff(&p);
  result.nodal = nodal_average(space, values).maxCoeff();
  result.part = volume_percentile(space, values, run.options.percentile, least);
  result.place = place_text(run.step.place_of(run.step.point(static_cast<int>(p))));
  return result;
}

template <int Dim>
Statement of_one_point(const ReportedRun<Dim>& run, const std::string& name, const std::string& volume,
                       const Largest<Dim>& value) {
  return {StatementKind::NEEDED, "largest " + name, value.ratio(), 75,
          "the largest " + name + ", " + short_number(value.point) + ", is that of one point, at " +
              value.place + ": " + short_number(value.nodal) + " at a node, " +
              short_number(100 * run.options.percentile) + " % of the " + volume + " below " +
              short_number(value.part) + ": judge by these, or refine there"};
}

template <int Dim> void say_of_largest(const ReportedRun<Dim>& run, List& list) {
  const Workpiece<Dim>& workpiece = run.step.workpiece;
  const ReportOptions& options = run.options;
  if (workpiece.law().internal_variables().find("plastic_strain_eq") >= 0) {
    const auto strain = largest(run, workpiece.internal("plastic_strain_eq"), options.flowing);
    if (strain.point > options.flowing && strain.ratio() > 1 + options.one_point)
      list.push_back(of_one_point(run, "plastic strain", "flowing volume", strain));
  }
  const auto stress = largest(run, stress_eq_field(workpiece), 0);
  if (stress.ratio() > 1 + options.one_stress)
    list.push_back(of_one_point(run, "von Mises stress", "volume", stress));
}

} // namespace

template <int Dim> std::vector<Statement> not_modelled(const ReportedRun<Dim>& run) {
  List list;
  say_of_ends(run, list);
  say_of_stress(run, list);
  say_of_largest(run, list);
  return list;
}

template std::vector<Statement> not_modelled<2>(const ReportedRun<2>&);
template std::vector<Statement> not_modelled<3>(const ReportedRun<3>&);

} // namespace burnish
