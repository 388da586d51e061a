#include "output/summary.hpp"
#include "base/version.hpp"
#include "base/whole_file.hpp"
#include "contact/surface_report.hpp"
#include "contact/tool_report.hpp"
#include "run/contact_motion.hpp"
#include "run/force_balance.hpp"
#include "solver/asymmetry.hpp"
#include "solver/blas_info.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/volume_percentile.hpp"
#include <sstream>

namespace burnish {

namespace {

constexpr double FLOWING = 1e-4, PERCENTILE = 0.99; // of plastic_strain_eq_p99
const char* const PLASTIC_STRAIN = "plastic_strain_eq";

template <class Numbers> void add_numbers(const Numbers& numbers, Json& list) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) list.push_back(numbers[i]);
}

template <int Dim> Json components(const Resultant<Dim>& sum) {
  Json list = Json::array();
  add_numbers(sum.force, list);
  add_numbers(sum.moment, list);
  return list;
}

// Of the run, the worst of each check and subject, then of the material's numbers.
template <int Dim> Json warnings(const SummarizedRun<Dim>& run) {
  Json list = Json::array();
  for (const Finding& finding : run.diagnosis.findings().list())
    if (finding.severity == Severity::WARNING) list.push_back(finding.text);
  std::istringstream lines(run.warnings);
  for (std::string line; std::getline(lines, line);) list.push_back(line);
  return list;
}

template <int Dim> Json checks(const FindingList& findings) {
  Json list = Json::array();
  for (const Finding& f : findings.list()) {
    Json place = Json::array();
    for (std::size_t axis = 0; axis < Dim; ++axis)
      place.push_back(axis < f.place.size() ? f.place[axis] : Finding::NONE);
    list.push_back({{"check", f.check},
                    {"severity", name_of(f.severity)},
                    {"value", f.value},
                    {"bound", f.bound},
                    {"place", place},
                    {"t", f.t},
                    {"first", f.first},
                    {"count", f.count},
                    {"text", f.text}});
  }
  return list;
}

Json report(const std::vector<Statement>& statements) {
  Json list = Json::array();
  for (const Statement& s : statements)
    list.push_back({{"kind", name_of(s.kind)}, {"name", s.name}, {"value", s.value}, {"text", s.text}});
  return list;
}

// Coordinates of all tools and their forces.
template <int Dim> void add_coordinates(const ContactSetup<Dim>& setup, Json& state) {
  std::vector<std::shared_ptr<const Tool<Dim>>> tools;
  for (const auto& tool : setup.tools()) tools.push_back(tool->shared_tool());
  const std::vector<std::string> names = coordinate_names<Dim>(tools);
  std::size_t k = 0;
  for (const auto& tool : setup.tools())
    for (Eigen::Index i = 0; i < tool->q().size(); ++i, ++k) {
      state[names[k]] = tool->q()[i];
      state["Q_" + names[k]] = tool->generalized_force()[i];
    }
}

template <int Dim>
void add_largest(const Workpiece<Dim>& workpiece, const std::string& name, const Eigen::VectorXd& values,
                 Json& state) {
  state[name + "_max"] = values.maxCoeff();
  state[name + "_nodal_max"] = nodal_average(workpiece.discretization(), values).maxCoeff();
}

template <int Dim> Json final_state(const SummarizedRun<Dim>& run) {
  const ContactRunState<Dim>& end = run.contact.accepted();
  const ContactSetup<Dim>& setup = run.contact.setup();
  const auto count = [&](const char* state) { return count_nodes(end.contact, state, "summary"); };
  Json state{{"t", run.control.time()}};
  add_coordinates(setup, state);
  state["sticking"] = count("sticking") + count("touched");
  state["sliding"] = count("sliding");
  state["stick_share"] =
      surface_report(setup.model(), setup.body(), end.contact, setup.surface(), end.u, end.R).stick_share;
  if (run.has_damage) state["damaged"] = (integrity_field(run.workpiece).array() < 1).count();
  const Eigen::VectorXd strain = internal_field(run.workpiece, PLASTIC_STRAIN);
  add_largest(run.workpiece, "stress_eq", stress_eq_field(run.workpiece), state);
  add_largest(run.workpiece, PLASTIC_STRAIN, strain, state);
  state["plastic_strain_eq_p99"] =
      volume_percentile(run.workpiece.discretization(), strain, PERCENTILE, FLOWING);
  return state;
}

Json way(const CondensedSystem* system) {
  if (!system) return Json::object();
  const SparseView view{system->n, system->row_start.data(), system->col.data(), system->value.data(),
                        system->half};
  return {{"matrix_size", system->n},
          {"matrix_nonzeros", system->row_start[static_cast<std::size_t>(system->n)]},
          {"matrix_asymmetry", largest_asymmetry(view)}};
}

template <int Dim> Json counts(const ContactRun<Dim>& run) {
  Json events;
  for (int kind = 0; kind < static_cast<int>(EventKind::USER); ++kind)
    events[name_of(static_cast<EventKind>(kind))] = 0;
  for (const ContactEvent<Dim>& event : run.accepted().log.events) {
    Json& number = events[kind_of(event)];
    number = number.is_null() ? 1 : number.get<long>() + 1;
  }
  const IterationCounts counts = run.iteration().counts();
  return {{"iterations", counts.iterations},
          {"factorizations", counts.factorizations + counts.condensations},
          {"solves", counts.solves},
          {"analyses", counts.analyses},
          {"backtracks", counts.backtracks},
          {"factor_entries", counts.factor_entries},
          {"events", events}};
}

Json steps(const StepControl& control, const StepLoop* stepper) {
  return {{"last_dt", control.dt()},
          {"rejected_dt", stepper ? stepper->rejected_dt() : 0},
          {"last_rejection", stepper ? stepper->last_rejection() : ""},
          {"error_estimate", stepper ? stepper->error() : -1},
          {"nodes_per_step", stepper ? stepper->counts().nodes_per_step() : 0}};
}

template <int Dim> Json balance(const SummarizedRun<Dim>& run) {
  const ForceBalance<Dim> forces(run.contact, run.about);
  Json of_tools = Json::object();
  Json point = Json::array();
  add_numbers(run.about, point);
  int number = 0;
  for (const auto& tool : run.contact.setup().tools())
    of_tools[tool->name()] = components(forces.contact_force(number++));
  return {{"moment_point", point},
          {"support", components(forces.reaction())},
          {"contact", of_tools},
          {"external", components(forces.external_force(run.workpiece.internal_force()))},
          {"hold", components(forces.hold_force())}};
}

template <int Dim> std::string left_out_text(const ContactRun<Dim>& run) {
  std::string text;
  for (const std::string& what : left_out(run)) text += (text.empty() ? "" : "; ") + what;
  return text;
}

} // namespace

template <int Dim> Json run_summary(const SummarizedRun<Dim>& run) {
  const Discretization<Dim>& space = run.workpiece.discretization();
  const StepBalance<Dim>& balanced = run.contact.iteration().balance();
  return {{"warnings", warnings(run)},
          {"report", report(run.report)},
          {"checks", checks<Dim>(run.diagnosis.findings())},
          {"measured", run.stepper ? Json(run.diagnosis.findings().measured()) : Json::object()},
          {"final", final_state(run)},
          {"way", way(run.condensed)},
          {"counts", counts(run.contact)},
          {"steps", steps(run.control, run.stepper)},
          {"cpu_seconds", run.seconds},
          {"residual", {{"last", balanced.last().residual}, {"load", balanced.memory().scale}}},
          {"balance", balance(run)},
          {"left_out", left_out_text(run.contact)},
          {"mesh",
           {{"nodes", space.num_nodes},
            {"elements", space.num_elements},
            {"points", space.num_points()},
            {"axisymmetric", space.axisymmetric}}}};
}

template Json run_summary<2>(const SummarizedRun<2>&);
template Json run_summary<3>(const SummarizedRun<3>&);

Json versions() {
  std::ostringstream eigen;
  eigen << EIGEN_WORLD_VERSION << "." << EIGEN_MAJOR_VERSION << "." << EIGEN_MINOR_VERSION;
  return {{"burnish", BURNISH_VERSION},
          {"eigen", eigen.str()},
          {"sparse", sparse_solver_versions()},
          {"blas", blas_name()},
          {"compiler", __VERSION__}};
}

void save_summary(const Json& summary, const std::string& path) {
  const auto line = [](const Json& value) { // bytes of an option that are no UTF-8 are replaced
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  std::string text;
  for (const auto& [key, value] : summary.items())
    text += (text.empty() ? "{\n  " : ",\n  ") + line(key) + ": " + line(value);
  write_whole(path, text + "\n}\n");
}

} // namespace burnish
