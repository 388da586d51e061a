// Script type `contact`: the surface of a workpiece that tools may touch.
//   > contact C = rcContact(Vh, label=3, fixed=held, friction=0.2);
//   > C.add(roller);  C.approach(roller, "y", u[]);
//   contact(...)   contact C = rcContact(...) declares it
//   rcContact(Vh)   the contact of a workpiece
//     Vh        fespace of the displacement | | | [P1,P1] or [P2,P2] of a mesh of triangles, [P1,P1,P1] or [P2,P2,P2] of tetrahedra
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
//     ! the space must be [P1,P1,P1] or [P2,P2,P2]
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
#include "named.hpp"
#include "settings.hpp"
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

std::shared_ptr<const FacetMeasure<2>> measure_of(const Mesh<2>& mesh) {
  return std::make_shared<EdgeMeasure>(mesh.axisymmetric);
}
std::shared_ptr<const FacetMeasure<3>> measure_of(const Mesh<3>&) { return std::make_shared<FaceMeasure>(); }

struct ContactParameters {
  static std::vector<basicAC_F0::name_and_type> list;
  static const int n;
  static basicAC_F0::name_and_type* const names;
};
template <int Dim> struct MakeContact : ContactParameters {
  static std::vector<char> fixed_of(const Named& a, long dofs) {
    std::vector<char> fixed(static_cast<std::size_t>(dofs), 0);
    if (!a.has("fixed")) return fixed;
    const Eigen::VectorXd flags = to_dofs(a.array("fixed"), dofs, "contact", "fixed");
    for (long d = 0; d < dofs; ++d) fixed[static_cast<std::size_t>(d)] = flags[d] != 0;
    return fixed;
  }
  static void place_surface(const Named& a, ContactSetup<Dim>& setup) {
    const auto& X = setup.mesh().X;
    if (a.boolean("straight", false))
      setup.place_surface(Eigen::Map<const Eigen::VectorXd>(X.data(), static_cast<long>(X.size())));
    if (a.has("surfaceplaces"))
      setup.place_surface(
          to_dofs(a.array("surfaceplaces"), setup.mesh().num_dofs(), "contact", "surfaceplaces"));
  }
  static Made<ContactObject> call(const Named& a, typename Freefem<Dim>::Fespace* space) {
    const std::vector<long> labels = labels_of(a, "contact");
    if (labels.empty()) fail("contact", "the contact surface is missing: label=... or labels=...");
    auto mesh = mesh_of<Dim>(space, "contact", a.boolean("axisymmetric", false));
    auto fixed = fixed_of(a, mesh.num_dofs());
    const IterationOptions options = settings_of(a, "rcContact", "contact").iteration;
    require(options.tolerance <= LOOSE || a.boolean("loose", false), "contact", "tolerance",
            options.tolerance,
            "<= 1e-2: beyond it the result may be wrong many times over; loose=true takes it all the same");
    auto object = std::make_shared<ContactOf<Dim>>();
    object->friction = called("rcContact", [&] { return make_coulomb(a.real("friction", 0)); });
    for (const long label : labels) facets_with(mesh, {label}, "contact"); // each must be there
    auto surface = facets_with(mesh, labels, "contact");
    auto measure = measure_of(mesh);
    object->setup = std::make_shared<ContactSetup<Dim>>(std::move(mesh), std::move(surface), std::move(fixed),
                                                        std::move(measure));
    object->options = options;
    place_surface(a, *object->setup);
    return made<ContactObject>(a.stack(), std::move(object));
  }
};
std::vector<basicAC_F0::name_and_type> ContactParameters::list =
    setting_names("rcContact", {{"label", &typeid(long)},
                                {"labels", &typeid(KN_<long>)},
                                {"fixed", &typeid(KN_<double>)},
                                {"friction", &typeid(double)},
                                {"axisymmetric", &typeid(bool)},
                                {"surfaceplaces", &typeid(KN_<double>)},
                                {"straight", &typeid(bool)},
                                {"loose", &typeid(bool)}});
const int ContactParameters::n = static_cast<int>(list.size());
basicAC_F0::name_and_type* const ContactParameters::names = list.data();

// Facets of the labels that a tool may touch; empty: all.
template <int Dim> std::vector<Facet<Dim>> reach_of(const Named& a, const ContactOf<Dim>& contact) {
  const std::vector<long> labels = labels_of(a, "contact.add");
  const auto& surface = contact.setup->surface();
  std::vector<Facet<Dim>> reach;
  for (const long label : labels) {
    const std::size_t before = reach.size();
    std::copy_if(surface.begin(), surface.end(), std::back_inserter(reach),
                 [label](const Facet<Dim>& facet) { return facet.label == label; });
    std::set<long> known;
    for (const Facet<Dim>& facet : surface) known.insert(facet.label);
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
  static bool call(const Named& a, Method<ContactHandle, AddTag> m, ToolHandle* handle) {
    return visit(m->get(), [&](auto& contact) {
      const auto friction = called("contact.add", [&] {
        return make_friction(arguments_of(a, laws), contact.friction, contact.parameters);
      });
      constexpr int Dim = dim_of<decltype(contact)>;
      const char* advice = Dim == 2 ? ": circle=, line=, chain= or cad=, without revolve= and extrude="
                                    : ": sphere=, cylinder=, cone=, torus=, plane=, box=, or a profile with "
                                      "revolve=true or extrude=true";
      auto& object = of_dimension<Dim>(handle->get(), "contact.add", advice);
      contact.setup->add_tool(object.tool, friction, reach_of(a, contact));
      object.added = true;
      tools_of_no_contact().erase(object.tool->name());
      object.contact = m.object->share();
      return true;
    });
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
  return on(h, [&](auto& contact) {
    std::string text;
    for (const Finding& finding : contact.diagnosis.findings().list())
      if (finding.severity == Severity::WARNING) text += finding.text + "\n";
    return new_string(stack, text);
  });
}

struct CoupleTag {};
bool couple(const Method<ContactHandle, CoupleTag>& m, string* const& dependent, string* const& text) {
  return on(m.object, [&](auto& contact) {
    called("contact.couple", [&] { contact.setup->couple(*dependent, *text); });
    return true;
  });
}

struct ApproachTag {};
double approach(const Method<ContactHandle, ApproachTag>& m, ToolHandle* const& tool,
                string* const& coordinate, const KN_<double>& u) {
  return on(m.object, [&](auto& contact) {
    if (contact.under_way)
      fail("contact.approach", "a run is under way: approach before it, or between two runs");
    const auto& added = of_dimension<dim_of<decltype(contact)>>(tool->get(), "contact.approach").tool;
    const auto& tools = contact.setup->tools();
    const auto at = std::find(tools.begin(), tools.end(), added);
    if (at == tools.end())
      fail("contact.approach", "tool \"" + added->name() + "\" was not added, call add first");
    const long n = contact.setup->mesh().num_dofs();
    return contact.run().approach(static_cast<int>(at - tools.begin()), *coordinate,
                                  to_dofs(u, n, "contact.approach", "u"));
  });
}

} // namespace

void register_contact() {
  using H = ContactHandle;
  Dcl_Type<H*>(InitP<H>, Destroy<H>);
  zzzfff->Add("contact", atype<H*>());
  Dcl_Type<Made<ContactObject>>();
  TheOperators->Add("<-", new OneOperator2_<H*, H*, Made<ContactObject>>(take_over<ContactObject>));
  Global.Add("rcContact", "(", new NamedOperator<MakeContact<2>, Made<ContactObject>, pfes*>);
  Global.Add("rcContact", "(", new NamedOperator<MakeContact<3>, Made<ContactObject>, pfes3*>);
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
