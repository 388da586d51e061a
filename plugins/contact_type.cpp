// Script type `contact`: the surface of a workpiece that tools may touch.
//   > contact C = rcContact(Vh, label=3, fixed=held, friction=0.2);
//   > C.add(roller);  C.approach(roller, "y", u[]);
//   contact(...)   contact C = rcContact(...) declares it
//   rcContact(Vh)   the contact of a workpiece
//     Vh        fespace of the displacement | | | [P1,P1] or [P2,P2] of a mesh of triangles
//     label=    boundary label of the surface | - | required, or labels= | a label of the mesh
//     labels=   several of them | - | required, or label= | labels of the mesh
//     fixed=    nonzero where the displacement is given, one per degree of freedom | - | none
//     friction=   Coulomb coefficient of the tools that are added without a law of their own | - | 0 | >= 0
//     axisymmetric=   x is the radius, y the axis, as in rcMaterial | | false
//     surfaceplaces=   where the mid nodes of P2 edges lie on the true curve: Vh [X, Y] = [...]; X[] | length |
//       on the curve through the vertices, arc by arc
//     straight=   P2: mid nodes on the edges of the mesh | | false
//     loose=    true: a tolerance above 1e-2 is taken | | false
//     ! the contact surface is missing: label=... or labels=...
//     ! the space must be [P1,P1] or [P2,P2]
//   C.add(t)   lets a tool touch the surface, or the part of it with the labels; before the first step
//     t         the tool, with coordinates
//     label=    the part that it may touch | - | all | a label of the contact
//     labels=   several of them | - | all | labels of the contact
//     friction=   Coulomb coefficient: largest traction friction*p | - | of the contact | >= 0
//     shearlimit=   with friction=: no traction beyond this shear strength | stress | none | >= 0
//     tresca=   shear traction under any pressure, in place of friction= | stress | | >= 0
//     sticking=   true: a node never slides | | false
//     frictionlaw=   traction as a formula of the pressure p, "0.3*p/(1+p/k)" | stress | | >= 0 for all p
//     ! tools must be added before the first step
//     ! give at most one of
//     ! has no coordinates yet: call coordinates(...) first
//   C.parameter(name, value)   a number by name for the formulas of later calls of add; returns it | its own
//     name      name in the formula | | | not p
//     value     the number | its own | | finite
//   C.warnings   warnings of the run, one line each
//   C.couple(dependent, formula)   a coordinate follows others; before the first step
//     dependent   "tool.coordinate"
//     formula   of other "tool.coordinate"
//     > C.couple("lower.y", "-upper.y");
//     ! relations must be given before the first step and approach
//   C.approach(t, coordinate, u)   moves one coordinate until the tool just touches; returns its value | length, rad
//     t         a tool that was added
//     coordinate   which one
//     u         displacement array, u[] | length
//     ! was not added, call add first
//     ! alone does not bring it to the body
//     ! a run is under way: approach before it, or between two runs
#include "arguments.hpp"
#include "base/error.hpp"
#include "contact/friction_laws.hpp"
#include "formula/formula.hpp"
#include "freefem_solver.hpp"
#include "matrix.hpp"
#include "mesh/mesh_match.hpp"
#include "named.hpp"
#include "settings.hpp"
#include "solver/column_factor.hpp"
#include "types.hpp"
#include <algorithm>
#include <set>

namespace burnish {
namespace {

std::vector<long> labels_of(const Named& a, const char* where) {
  std::vector<long> labels;
  if (a.has("label")) labels.push_back(a.integer("label", 0));
  if (a.has("labels")) {
    const KN_<long> list = a.integers("labels");
    require(list.N() > 0, where, "size of labels", list.N(), ">= 1, or no labels= at all");
    for (long i = 0; i < list.N(); ++i) labels.push_back(list[i]);
  }
  return labels;
}

constexpr double LOOSE = 1e-2; // largest tolerance that nobody has to confirm

struct MakeContact {
  static std::vector<basicAC_F0::name_and_type> list;
  static const int n;
  static basicAC_F0::name_and_type* const names;
  static Made<ContactObject> call(const Named& a, pfes* space) {
    const std::vector<long> labels = labels_of(a, "contact");
    if (labels.empty()) fail("contact", "the contact surface is missing: label=... or labels=...");
    auto mesh = mesh_of(space, "contact", a.boolean("axisymmetric", false));
    std::vector<char> fixed(mesh.num_dofs(), 0);
    if (a.has("fixed")) {
      const Eigen::VectorXd flags =
          to_dofs(a.array("fixed"), static_cast<long>(fixed.size()), "contact", "fixed");
      for (std::size_t d = 0; d < fixed.size(); ++d) fixed[d] = flags[static_cast<long>(d)] != 0;
    }
    const IterationOptions options = settings_of(a, "rcContact", "contact").iteration;
    require(options.tolerance <= LOOSE || a.boolean("loose", false), "contact", "tolerance",
            options.tolerance,
            "<= 1e-2: beyond it the result may be wrong many times over; loose=true takes it all the same");
    auto object = std::make_shared<ContactObject>();
    object->friction = called("rcContact", [&] { return make_coulomb(a.real("friction", 0)); });
    for (const long label : labels) facets_with(mesh, {label}, "contact"); // each must be there
    auto surface = facets_with(mesh, labels, "contact");
    auto measure = std::make_shared<EdgeMeasure>(mesh.axisymmetric);
    object->setup = std::make_shared<ContactSetup<2>>(std::move(mesh), std::move(surface), std::move(fixed),
                                                      std::move(measure));
    object->options = options;
    if (a.boolean("straight", false)) {
      const auto& X = object->setup->mesh().X;
      object->setup->place_surface(Eigen::Map<const Eigen::VectorXd>(X.data(), static_cast<long>(X.size())));
    }
    if (a.has("surfaceplaces"))
      object->setup->place_surface(
          to_dofs(a.array("surfaceplaces"), object->setup->mesh().num_dofs(), "contact", "surfaceplaces"));
    return made(a.stack(), std::move(object));
  }
};
std::vector<basicAC_F0::name_and_type> MakeContact::list =
    setting_names("rcContact", {{"label", &typeid(long)},
                                {"labels", &typeid(KN_<long>)},
                                {"fixed", &typeid(KN_<double>)},
                                {"friction", &typeid(double)},
                                {"axisymmetric", &typeid(bool)},
                                {"surfaceplaces", &typeid(KN_<double>)},
                                {"straight", &typeid(bool)},
                                {"loose", &typeid(bool)}});
const int MakeContact::n = static_cast<int>(list.size());
basicAC_F0::name_and_type* const MakeContact::names = list.data();

// Edges of the labels that a tool may touch; empty: all.
std::vector<Facet<2>> reach_of(const Named& a, const ContactObject& contact) {
  const std::vector<long> labels = labels_of(a, "contact.add");
  const auto& surface = contact.setup->surface();
  std::vector<Facet<2>> reach;
  for (const long label : labels) {
    const std::size_t before = reach.size();
    std::copy_if(surface.begin(), surface.end(), std::back_inserter(reach),
                 [label](const Facet<2>& edge) { return edge.label == label; });
    std::set<long> known;
    for (const Facet<2>& edge : surface) known.insert(edge.label);
    std::string list;
    for (const long one : known) list += " " + std::to_string(one);
    require(reach.size() > before, "contact.add", "label", label, ("a label of the contact:" + list).c_str());
  }
  return reach;
}

struct AddTag {};
struct AddTool {
  static const std::vector<Parameter> laws;
  static std::vector<basicAC_F0::name_and_type> list;
  static const int n;
  static basicAC_F0::name_and_type* const names;
  static bool call(const Named& a, Method<ContactHandle, AddTag> m, ToolHandle* tool) {
    ContactObject& contact = m->get();
    const auto friction = called("contact.add", [&] {
      return make_friction(arguments_of(a, laws), contact.friction, contact.parameters);
    });
    contact.setup->add_tool(tool->get().tool, friction, reach_of(a, contact));
    tool->get().added = true;
    tool->get().contact = m.object->share();
    return true;
  }
};
const std::vector<Parameter> AddTool::laws = friction_parameters();
std::vector<basicAC_F0::name_and_type> AddTool::list =
    names_of(laws, {{"label", &typeid(long)}, {"labels", &typeid(KN_<long>)}});
const int AddTool::n = static_cast<int>(list.size());
basicAC_F0::name_and_type* const AddTool::names = list.data();

struct ParameterTag {};
double parameter(const Method<ContactHandle, ParameterTag>& m, string* const& name, const double& value) {
  return guarded([&] {
    check_formula_names("contact.parameter", {{"p"}, {{*name, value}}});
    return m->get().parameters[*name] = value;
  });
}

string* warnings(Stack stack, ContactHandle* const& h) {
  return guarded([&] {
    std::string text;
    for (const Finding& finding : h->get().diagnosis.findings().list())
      if (finding.severity == Severity::WARNING) text += finding.text + "\n";
    return new_string(stack, text);
  });
}

struct CoupleTag {};
bool couple(const Method<ContactHandle, CoupleTag>& m, string* const& dependent, string* const& text) {
  return guarded([&] {
    called("contact.couple", [&] { m->get().setup->couple(*dependent, *text); });
    return true;
  });
}

struct ApproachTag {};
double approach(const Method<ContactHandle, ApproachTag>& m, ToolHandle* const& tool,
                string* const& coordinate, const KN_<double>& u) {
  return guarded([&] {
    if (m->get().under_way)
      fail("contact.approach", "a run is under way: approach before it, or between two runs");
    const auto& tools = m->get().setup->tools();
    const auto at = std::find(tools.begin(), tools.end(), tool->get().tool);
    if (at == tools.end())
      fail("contact.approach", "tool \"" + tool->get().tool->name() + "\" was not added, call add first");
    const long n = m->get().setup->mesh().num_dofs();
    return m->get().run().approach(static_cast<int>(at - tools.begin()), *coordinate,
                                   to_dofs(u, n, "contact.approach", "u"));
  });
}

} // namespace

ContactRun<2>& ContactObject::run() {
  if (!m_run) m_run = std::make_unique<ContactRun<2>>(setup, options);
  return *m_run;
}

bool ContactObject::take_solver(const std::string& solver, Stack stack, const char* where) {
  const std::string name = solver.empty() ? solver : known_solver(solver, where);
  if (name != m_solver) {
    m_solver = name;
    const auto make = [=]() -> std::unique_ptr<BodySolver<2>> {
      return std::make_unique<ColumnFactor<2>>(freefem_solver(name, stack));
    };
    run().corrector().set_solver(name.empty() ? nullptr
                                              : std::function<std::unique_ptr<BodySolver<2>>()>(make));
  }
  return name.empty() || takes_triangle(name);
}

void ContactObject::require_same_mesh(MaterialObject& material, const char* where) {
  burnish::require_same_mesh<2>(material.workpiece().discretization(), "the material", setup->mesh(),
                                "the contact", where);
}

const NodeBlockMatrix<2>& ContactObject::blocks(const TripletView& K, const char* where) {
  const auto& read = called(where, [&]() -> const NodeBlockMatrix<2>& { return reader.read(K); });
  matrices.require_of(setup->mesh(), read, where);
  return read;
}

double ContactObject::linear_seconds() const {
  if (!m_run) return 0;
  const IterationCounts& counts = m_run->iteration().counts();
  return counts.factorization_seconds + counts.condensation_seconds + counts.solve_seconds;
}

const ContactRun<2>& ContactObject::running(const char* where) const {
  if (!m_run) fail(where, "no state yet: call approach or begin first");
  return *m_run;
}

void register_contact() {
  using H = ContactHandle;
  Dcl_Type<H*>(InitP<H>, Destroy<H>);
  zzzfff->Add("contact", atype<H*>());
  Dcl_Type<Made<ContactObject>>();
  TheOperators->Add("<-", new OneOperator2_<H*, H*, Made<ContactObject>>(take_over<ContactObject>));
  Global.Add("rcContact", "(", new NamedOperator<MakeContact, Made<ContactObject>, pfes*>);
  add_method<H, AddTag>("add",
                        [] { return new NamedOperator<AddTool, bool, Method<H, AddTag>, ToolHandle*>; });
  Add<H*>("warnings", ".", new OneOperator1s_<string*, H*>(warnings));
  add_method<H, ParameterTag>("parameter", [] {
    return new OneOperator3_<double, Method<H, ParameterTag>, string*, double>(parameter);
  });
  add_method<H, CoupleTag>(
      "couple", [] { return new OneOperator3_<bool, Method<H, CoupleTag>, string*, string*>(couple); });
  add_method<H, ApproachTag>("approach", [] {
    return new OneOperator4_<double, Method<H, ApproachTag>, ToolHandle*, string*, KN_<double>>(approach);
  });
}

} // namespace burnish
