#include "checkpoint/identity.hpp"
#include "base/error.hpp"
#include "contact/formula_friction.hpp"
#include "mesh/mesh_match.hpp"
#include "script/words.hpp"
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <zlib.h>

namespace burnish {
namespace {

constexpr int POSES =
    5; // of a tool, and yield stresses from 0 to 1 of the law: what tells formulas from others
constexpr int YIELDS = 101;
constexpr int SAMPLES = 64; // places on a tool's surface that tell it from others
// Options that only decide what becomes of the results.
const char* const OF_THE_OUTPUT[] = {"-out",   "-pictures",   "-movie",  "-check",
                                     "-model", "-checkpoint", "-resume", "-options"};

template <class... Words> std::string words(const Words&... parts) {
  std::ostringstream text;
  text << std::setprecision(17);
  (text << ... << parts);
  return text.str();
}

template <class Number> std::string mark_of(const std::vector<Number>& numbers) {
  std::ostringstream text;
  text << std::hex
       << crc32_z(0, reinterpret_cast<const Bytef*>(numbers.data()), numbers.size() * sizeof(Number));
  return text.str();
}

// A law by formula goes by its text, too: its values may agree where they are taken.
template <int Dim> std::string friction_words(const TangentialLaw<Dim>& law) {
  const auto* formula = dynamic_cast<const FormulaFriction*>(&law.friction());
  std::string text = formula ? " by \"" + formula->text() + "\"" : "";
  for (const double N : {1., 2.}) {
    try {
      text += words(" ", law.friction().limit(N, 1));
    } catch (const std::exception&) { // a formula without a value there
      text += " none";
    }
  }
  return text;
}

// Places and turns of the tool for a row of values of its coordinates, which formulas of them change.
template <int Dim> std::string pose_mark(const Coordinates<Dim>& coordinates) {
  std::vector<double> numbers;
  for (int k = 0; k < POSES; ++k) {
    Eigen::VectorXd q(coordinates.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = std::sin(1. + k + 0.7 * static_cast<double>(i));
    try {
      const Pose<Dim> pose = coordinates.pose(q);
      numbers.insert(numbers.end(), pose.origin.data(), pose.origin.data() + Dim);
      numbers.insert(numbers.end(), pose.R.data(), pose.R.data() + Dim * Dim);
      numbers.push_back(pose.size);
    } catch (const std::exception&) { // a formula without a value there
      numbers.push_back(k);
    }
  }
  return mark_of(numbers);
}

// Motions and forces by formula that the script has given before the run.
template <int Dim> std::string drive_words(DrivenTool<Dim>& tool) {
  std::string text;
  const Prescription& given = tool.prescription();
  for (std::size_t k = 0; k < given.entries().size(); ++k) {
    const Prescription::Entry& entry = given.entries()[k];
    if (!entry.formula && entry.relation.empty()) continue;
    text +=
        ", " + given.names()[k] + " by \"" + (entry.formula ? entry.formula->text() : entry.relation) + "\"";
    if (!entry.formula) continue;
    for (const auto& [name, value] : entry.formula->source().names.parameters)
      text += words(" ", name, " ", value);
  }
  return text;
}

template <int Dim> std::string tool_words(const ContactSetup<Dim>& setup, std::size_t t) {
  const ContactModel<Dim>& model = setup.model();
  std::vector<double> places;
  for (const auto& place : model.tools[t]->surface().samples(SAMPLES))
    places.insert(places.end(), place.y.data(), place.y.data() + Dim);
  std::string names;
  for (const std::string& name : model.tools[t]->coordinates().names()) names += " " + name;
  return words("coordinates", names, ", surface of mark ", mark_of(places), " and size ",
               model.tools[t]->surface().length_scale(), ", poses of mark ",
               pose_mark(model.tools[t]->coordinates()), ", largest friction of unit forces",
               friction_words(model.laws[t]), drive_words(*setup.tools()[t]));
}

// First line in which two texts differ.
std::string line_words(const std::string& then, const std::string& now) {
  std::istringstream a(then), b(now);
  for (std::string old, line;;) {
    const bool was = static_cast<bool>(std::getline(a, old)), is = static_cast<bool>(std::getline(b, line));
    if (!was && !is) return "";
    if (was && is && old == line) continue;
    return "says `" + (is ? line : "") + "`, expected `" + (was ? old : "") + "`";
  }
}

} // namespace

template <int Dim> std::string mesh_words(const Mesh<Dim>& mesh) {
  std::ostringstream text;
  text << mesh.num_nodes << " nodes, " << mesh.num_elements << " elements of " << mesh.nodes_per_element
       << " nodes" << (mesh.axisymmetric ? ", axisymmetric" : "") << ", mark " << std::hex
       << mesh_fingerprint(mesh);
  return text.str();
}

template <int Dim> std::string material_words(const Workpiece<Dim>& workpiece) {
  const MaterialLaw<Dim>& law = workpiece.law();
  const UpdateOptions& options = workpiece.options();
  std::string text = law.name();
  for (const auto& [name, value] : law.moduli()) text += words(", ", name, " ", value);
  for (const double strain : {0., 0.01, 0.1, 1.})
    text += words(", ", law.yield_stress(strain).value, " at ", strain);
  std::vector<double> yields;
  for (int k = 0; k < YIELDS; ++k) yields.push_back(law.yield_stress(k / (YIELDS - 1.)).value);
  text += ", hardening of mark " + mark_of(yields);
  return text + words(", keeps ", law.internal_variables().names(), ", update ",
                      static_cast<int>(options.update), " ", static_cast<int>(options.strain_frame), " ",
                      options.path_limit, " ", options.min_substeps, " ", options.max_substeps,
                      workpiece.user_defined() ? ", user-defined" : "");
}

template <int Dim>
std::vector<IdentityPart> identity_of(const ContactRun<Dim>& run, const RunBody<Dim>& body,
                                      const StepControlOptions& steps, bool forms_only) {
  const ContactModel<Dim>& model = run.setup().model();
  std::vector<IdentityPart> parts{{"mesh", mesh_words(run.setup().mesh())}};
  parts.push_back(
      {"contact surface", words(model.candidates.size(), " nodes, mark ", mark_of(model.candidates),
                                ", supports of mark ", mark_of(run.setup().body().fixed))});
  for (std::size_t t = 0; t < model.tools.size(); ++t)
    parts.push_back({"tool \"" + run.setup().tools()[t]->name() + "\"", tool_words(run.setup(), t)});
  parts.push_back({"material", forms_only ? "of the script" : material_words(body.workpiece())});
  for (const auto& [name, formula] : body.user().words())
    parts.push_back({"event \"" + name + "\"", formula + body.damage().words(name)});
  parts.push_back({"steps", words("to t = ", steps.t_end, ", at most ", steps.dt_max, ", at least ",
                                  steps.dt_min, ", first ", steps.dt_first, ", accuracy ", steps.accuracy)});
  return parts;
}

std::vector<IdentityPart> identity_of(const ScriptOptions& options, const std::string& folders) {
  std::vector<IdentityPart> parts;
  for (const auto& [file, code] : script_code(options.script(), folders))
    parts.push_back({"script \"" + file + "\"", code});
  for (const ScriptOptions::Option& option : options.options()) {
    const auto same = [&](const char* name) { return option.name == name; };
    if (std::none_of(std::begin(OF_THE_OUTPUT), std::end(OF_THE_OUTPUT), same))
      parts.push_back({"option " + option.name, option.value});
  }
  return parts;
}

void require_same(const std::string& path, const std::vector<IdentityPart>& then,
                  const std::vector<IdentityPart>& now) {
  const auto find = [](const std::vector<IdentityPart>& parts, const std::string& name) {
    return std::find_if(parts.begin(), parts.end(), [&](const auto& part) { return part.name == name; });
  };
  std::string differ;
  const auto add = [&](const std::string& text) { differ += (differ.empty() ? "" : "; ") + text; };
  for (const IdentityPart& part : now) {
    const auto old = find(then, part.name);
    if (old == then.end())
      add(part.name + " is new");
    else if (old->value != part.value)
      add(part.name + (part.name.rfind("script", 0) == 0 ? " " + line_words(old->value, part.value)
                                                         : " = " + part.value + ", expected " + old->value));
  }
  for (const IdentityPart& part : then)
    if (find(now, part.name) == now.end()) add(part.name + " is missing");
  if (!differ.empty()) fail_at("checkpoint \"" + path + "\"", "is of another run: " + differ);
}

template std::vector<IdentityPart> identity_of<2>(const ContactRun<2>&, const RunBody<2>&,
                                                  const StepControlOptions&, bool);
template std::vector<IdentityPart> identity_of<3>(const ContactRun<3>&, const RunBody<3>&,
                                                  const StepControlOptions&, bool);

template std::string mesh_words<2>(const Mesh<2>&);
template std::string mesh_words<3>(const Mesh<3>&);
template std::string material_words<2>(const Workpiece<2>&);
template std::string material_words<3>(const Workpiece<3>&);

} // namespace burnish
