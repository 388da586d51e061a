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
    if (!(end.share > run.options.end_load)) continue;
    const std::string name = run.step.tool_name(tool);
    list.push_back({StatementKind::NEEDED, "end of surface " + name, end.share, 95,
                    "the last node of the contact surface, at " + place_text(end.place) + ", carries " +
                        short_number(100 * end.share) + " % of the load of tool \"" + name +
                        "\" at t = " + short_number(end.t) +
                        ": what lies beyond it touches nothing, label= may take it in"});
  }
}

template <int Dim> void say_of_width(const ReportedRun<Dim>& run, List& list) {
  const std::vector<WidthState>& widths = run.checks.width;
  for (int tool = 0; tool < static_cast<int>(widths.size()); ++tool) {
    const std::string name = run.step.tool_name(tool);
    const WidthState& width = widths[tool];
    if (width.nodes == 0 || width.nodes > run.options.narrow_nodes) continue;
    if (found(run.findings, "contact width", name)) continue;
    list.push_back({StatementKind::NEEDED, "contact width " + name, static_cast<double>(width.nodes), 90,
                    "the contact of tool \"" + name + "\" is " + std::to_string(width.nodes) +
                        " nodes wide where it carries most, at " + place_text(width.place) + ", t = " +
                        short_number(width.t) + ": a finer mesh of the contact surface resolves it"});
  }
}

template <int Dim> void say_of_stress(const ReportedRun<Dim>& run, List& list) {
  if (run.scene.stress.empty()) return;
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

// A field whose largest value no node confirms.
template <int Dim>
bool is_of_one_point(const ReportedRun<Dim>& run, const Eigen::VectorXd& values, double& nodal) {
  nodal = nodal_average(run.step.workpiece.discretization(), values).maxCoeff();
  return nodal > 0 && values.maxCoeff() > (1 + run.options.one_point) * nodal;
}

template <int Dim> void say_of_largest(const ReportedRun<Dim>& run, List& list) {
  const Workpiece<Dim>& workpiece = run.step.workpiece;
  const ReportOptions& options = run.options;
  double nodal = 0;
  if (workpiece.law().internal_variables().find("plastic_strain_eq") >= 0) {
    const Eigen::VectorXd strain = workpiece.internal("plastic_strain_eq");
    if (strain.maxCoeff() > options.flowing && is_of_one_point(run, strain, nodal)) {
      const double part =
          volume_percentile(workpiece.discretization(), strain, options.percentile, options.flowing);
      list.push_back({StatementKind::NEEDED, "largest plastic strain", strain.maxCoeff() / nodal, 76,
                      "the largest plastic strain, " + short_number(strain.maxCoeff()) +
                          ", is that of one point: " + short_number(nodal) + " at a node, " +
                          short_number(100 * options.percentile) + " % of the flowing volume below " +
                          short_number(part) + ": a finer mesh settles it"});
    }
  }
  const Eigen::VectorXd stress = stress_eq_field(workpiece);
  if (is_of_one_point(run, stress, nodal))
    list.push_back(
        {StatementKind::NEEDED, "largest stress", stress.maxCoeff() / nodal, 75,
         "the largest von Mises stress, " + short_number(stress.maxCoeff()) +
             ", is that of one point: " + short_number(nodal) + " at a node, " +
             short_number(100 * options.percentile) + " % of the volume below " +
             short_number(volume_percentile(workpiece.discretization(), stress, options.percentile, 0)) +
             ": a finer mesh settles it"});
}

} // namespace

template <int Dim> std::vector<Statement> not_modelled(const ReportedRun<Dim>& run) {
  List list;
  say_of_ends(run, list);
  say_of_width(run, list);
  say_of_stress(run, list);
  say_of_largest(run, list);
  return list;
}

template std::vector<Statement> not_modelled<2>(const ReportedRun<2>&);
template std::vector<Statement> not_modelled<3>(const ReportedRun<3>&);

} // namespace burnish
