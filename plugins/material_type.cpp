// Script type `material`: plasticity with isotropic and kinematic hardening, plane strain, axisymmetric or in space, of
// degree 1 or 2.
//   > material M = rcMaterial(Vh, G=2.7e10, nu=0.32, sigY=1.93e8, H=9.62e8);
//   material(...)   material M = rcMaterial(...) declares it
//   rcMaterial(Vh)   the material of a workpiece
//     Vh        fespace of the displacement | | | [P1,P1] or [P2,P2] of a mesh of triangles, [P1,P1,P1] or [P2,P2,P2] of tetrahedra
//     G=        shear modulus; G= or E= | stress | required, or E= | finite > 0
//     E=        Young's modulus | stress | required, or G= | finite > 0
//     nu=       Poisson's ratio | - | required | -1 < nu < 0.5
//     sigY=     initial yield stress | stress | required, unless by formula or table | finite > 0
//     H=        hardening modulus, 0: perfect plasticity, < 0: softening | stress | required with "linear" | finite
//     hardening=   "linear": sigY + H*ep; "perfect": sigY; any other text: a formula in ep | stress | "linear" |
//       as "193e6*(1 + ep/0.002)^0.2"; of "200 + 400*ep^0.3", whose slope at 0 is infinite, the chord up to ep = 1e-5
//     plasticstrain=   table of the yield stress, straight between, constant behind: its plastic strains | - | none | 0, then
//       growing
//     yieldstress=   its yield stresses | stress | none | > 0, not falling without softening=true
//     softening=   true: the yield stress may fall; the result then depends on the mesh | | false
//     backstress=   kinematic hardening, beside any of the above | | "none" | "none", "prager", "armstrongfrederick"
//     C=        modulus of the back stress | stress | required with a backstress | finite > 0
//     gamma=    recovery of the back stress, armstrongfrederick | - | required with it | finite >= 0
//     rate=     corotational rate of the stress | | "jaumann" | "jaumann", "greennaghdi", "logarithmic"
//     strain=   "small": geometrically linear body, P = stress, strain = sym grad u, as of laws and forms of textbooks; the
//       contact follows the deformed surface as ever | | "large" | "large", "small"
//     axisymmetric=   x >= 0 is the radius, y the axis, [u, v] = [u_r, u_z], no torsion; forces are those of the whole ring.
//       The script prescribes u_r = 0 on the axis: on(axis, u=0) | | false
//     law=      "user": the script gives stress and moduli, M.stress, M.moduli; with G, nu, sigY, H it has J2's yield
//       surface for the events of elements | | "J2" | "J2", "user"
//     internal=   law="user": names of its internal variables, "damage,s" | | ""
//     ! , expected J2 or user
//     ! , expected large or small
//     ! , or a formula in ep
//     ! give either hardening or plasticstrain and yieldstress
//   M.update(u, dt, iteration)   stress at u from the accepted state; 0, or 1: inverted element, or no return to the yield
//       surface, rcLastError says which | -
//     u         displacement | length
//     dt        length of the step | time
//     iteration   number of the iteration in the step, from 0 | -
//   M.force(R)   internal nodal forces of the last update into R; returns the largest | force
//     R         out, as long as u | force
//   M.accept()   the end of the step becomes the accepted state
//   M.revert()   back to the accepted state
//   M.tangent()   tangent matrix of the last update, lower triangle of its symmetric part | force/length
//     kind=     which moduli | | "consistent" | "consistent", "rate", "elastic"
//     blend=    part of elastic moduli in plastic points | - | 0 | 0 to 1
//     full=     true: the whole matrix, with the antisymmetric part of a finite step, for studies | | false
//     ! , expected "consistent", "rate" or "elastic"
//   M.events()   earliest yield or unloading of the step that the last update made, all of the step found, for the log;
//       fraction of the step, 2: none | -
//   M.events(tolerance)   those within the tolerance of the earliest one | -
//     tolerance   fraction of the step | - | | >= 0
//   M.events(tolerance, noise)   without changes of q near the surface below the noise | -
//     tolerance   fraction of the step | - | | >= 0
//     noise     over the yield stress | - | | >= 0
//   M.keepplastic(noise)   before accept: points that flowed in the step and rest within the noise of the surface stay plastic
//     noise     over the yield stress | - | | >= 0
//   M.acceptevents()   after accept or revert: the points of the events found yield or unload; returns how many | -
//   M.dropevents()   drops the events found
//   M.seconds(phase)   CPU time | s
//     phase     "update", "assembly"
//     ! , expected update or assembly
#include "base/error.hpp"
#include "material/make_law.hpp"
#include "material/unit_warnings.hpp"
#include "material/user_law.hpp"
#include "matrix.hpp"
#include "mesh/mesh_match.hpp"
#include "named.hpp"
#include "settings.hpp"
#include "types.hpp"

namespace burnish {
namespace {

struct MaterialParameters {
  static std::vector<basicAC_F0::name_and_type> all_names() {
    std::vector<basicAC_F0::name_and_type> list;
    for (const LawParameter& parameter : law_parameters()) list.push_back({parameter.name, &typeid(double)});
    for (const char* name : {"law", "internal", "hardening", "backstress", "rate", "strain"})
      list.push_back({name, &typeid(string*)});
    for (const char* name : {"plasticstrain", "yieldstress"}) list.push_back({name, &typeid(NumberList*)});
    list.push_back({"softening", &typeid(bool)});
    list.push_back({"axisymmetric", &typeid(bool)});
    return setting_names("rcMaterial", list);
  }
  static bool law_is_users(const Named& a) {
    const std::string law = a.text("law", "J2");
    if (law != "J2" && law != "user") fail("rcMaterial", "unknown law \"" + law + "\", expected J2 or user");
    if (law == "J2" && a.has("internal"))
      fail("rcMaterial", "internal= names the internal variables of law=\"user\", J2 has its own");
    return law == "user";
  }
  static bool strain_is_small(const Named& a) {
    const std::string strain = a.text("strain", "large");
    if (strain != "large" && strain != "small")
      fail("rcMaterial", "unknown strain \"" + strain + "\", expected large or small");
    return strain == "small";
  }
  static std::vector<basicAC_F0::name_and_type> list;
  static basicAC_F0::name_and_type* const names;
  static const int n;
  static LawInput input_of(const Named& a) {
    LawInput input;
    for (const LawParameter& parameter : law_parameters())
      if (a.has(parameter.name)) input.numbers[parameter.name] = a.real(parameter.name, 0);
    input.hardening = a.text("hardening", input.hardening);
    input.backstress = a.text("backstress", input.backstress);
    input.rate = a.text("rate", input.rate);
    input.small_strain = strain_is_small(a);
    input.softening = a.boolean("softening", input.softening);
    if (a.has("plasticstrain")) input.plastic_strain = a.numbers("plasticstrain");
    if (a.has("yieldstress")) input.yield_stress = a.numbers("yieldstress");
    return input;
  }
};
template <int Dim> struct MakeMaterial : MaterialParameters {
  static std::shared_ptr<const MaterialLaw<Dim>> user_law(const Named& a) {
    return std::make_shared<UserLaw<Dim>>(internal_names(a.text("internal", "")), strain_is_small(a));
  }
  static Made<MaterialObject> call(const Named& a, typename Freefem<Dim>::Fespace* space) {
    const LawInput input = input_of(a);
    const bool user = law_is_users(a);
    // a user-defined law with elastic moduli and a yield stress has J2's yield surface for the events of elements
    auto law = user && input.numbers.empty() ? user_law(a) : make_law<Dim>(input, "rcMaterial");
    const UpdateOptions options = settings_of(a, "rcMaterial", "material").update;
    const bool axisymmetric = a.boolean("axisymmetric", false);
    auto object = std::make_shared<MaterialOf<Dim>>();
    auto workpiece = std::make_unique<Workpiece<Dim>>(
        called("material", [&] { return discretized(mesh_of<Dim>(space, "material", axisymmetric)); }),
        std::move(law), options);
    if (user) workpiece->set_user_defined(true);
    object->mesh = shared_mesh<Dim>(space, "material");
    object->fingerprint = mesh_fingerprint<Dim>(workpiece->discretization());
    if (!user) object->warnings = unit_warnings(input.numbers, "rcMaterial", input.plastic_strain);
    if (!object->warnings.empty()) cout << "burnish: warning: " << object->warnings << std::flush;
    object->body = std::make_unique<RunBody<Dim>>(std::move(workpiece));
    return made<MaterialObject>(a.stack(), std::move(object));
  }
};
std::vector<basicAC_F0::name_and_type> MaterialParameters::list = MaterialParameters::all_names();
basicAC_F0::name_and_type* const MaterialParameters::names = MaterialParameters::list.data();
const int MaterialParameters::n = static_cast<int>(MaterialParameters::list.size());

struct UpdateTag {};
struct ForceTag {};
struct AcceptTag {};
struct RevertTag {};
struct TangentTag {};

long update(Stack, const Method<MaterialHandle, UpdateTag>& m, const KN_<double>& u, const double& dt,
            const long& it) {
  return on(m.object, [&](auto& material) {
    const CpuTimer timer(material.update_seconds);
    const auto result = called("material.update", [&] {
      auto& body = material.changed().workpiece();
      return body.update(to_dofs(u, body.discretization().num_dofs(), "material.update", "u"), dt,
                         static_cast<int>(it));
    });
    if (result.status == UpdateStatus::OK) return 0L;
    std::ostringstream text;
    if (result.status == UpdateStatus::NO_RETURN)
      text << "no return to the yield surface from ep = " << result.value
           << ": the yield stress is not > 0 there or falls faster than -3G";
    else
      text << "inverted element: det F = " << result.value;
    text << " at quadrature point " << result.point;
    last_error() = text.str();
    return 1L;
  });
}
double force(Stack, const Method<MaterialHandle, ForceTag>& m, const KN_<double>& R) {
  return on(m.object, [&](auto& material) {
    const CpuTimer timer(material.assembly_seconds);
    const Eigen::VectorXd f = material.workpiece().internal_force();
    to_array(f, R, "material.force");
    return f.lpNorm<Eigen::Infinity>();
  });
}
bool accept(const Method<MaterialHandle, AcceptTag>& m) {
  return on(m.object, [](auto& material) { return material.changed().accept(), true; });
}
bool revert(const Method<MaterialHandle, RevertTag>& m) {
  return on(m.object, [](auto& material) { return material.changed().revert(), true; });
}

struct EventsTag {};
struct AcceptEventsTag {};
struct DropTag {};
struct KeepTag {};
double events_but_noise(const Method<MaterialHandle, EventsTag>& m, const double& tolerance,
                        const double& noise) {
  return on(m.object, [&](auto& material) {
    require(tolerance >= 0, "material.events", "tolerance", tolerance, ">= 0");
    require(noise >= 0, "material.events", "noise", noise, ">= 0");
    return material.body->find_earliest(tolerance, noise);
  });
}
double earliest_events(const Method<MaterialHandle, EventsTag>& m, const double& tolerance) {
  return events_but_noise(m, tolerance, 0);
}
double all_events(const Method<MaterialHandle, EventsTag>& m) {
  return on(m.object, [](auto& material) {
    material.body->find_all();
    return first_fraction(material.body->pending());
  });
}
bool drop_events(const Method<MaterialHandle, DropTag>& m) {
  return on(m.object, [](auto& material) { return material.body->drop_events(), true; });
}
bool keep_plastic(const Method<MaterialHandle, KeepTag>& m, const double& noise) {
  return on(m.object, [&](auto& material) {
    called("material.keepplastic", [&] { burnish::keep_plastic(noise, material.workpiece()); });
    return true;
  });
}
long accept_events(const Method<MaterialHandle, AcceptEventsTag>& m) {
  return on(m.object, [](auto& material) -> long { return material.changed().accept_events(); });
}

struct SecondsTag {};
double seconds(const Method<MaterialHandle, SecondsTag>& m, string* const& phase) {
  return guarded([&] {
    if (*phase == "update") return m->get().update_seconds;
    if (*phase == "assembly") return m->get().assembly_seconds;
    fail("material.seconds", "unknown phase \"" + *phase + "\", expected update or assembly");
  });
}
struct Tangent {
  static const int n = 3;
  static basicAC_F0::name_and_type names[n];
  static newpMatrice_Creuse<double> call(const Named& a, Method<MaterialHandle, TangentTag> m) {
    return visit(m->get(), [&](auto& object) {
      auto K = object.workpiece().pattern();
      const bool full = a.boolean("full", false);
      called("material.tangent", [&] {
        const TangentKind kind = tangent_kind(a.text("kind", "consistent"));
        object.workpiece().tangent(K, kind, a.real("blend", 0));
        if (full) object.workpiece().add_antisymmetric_tangent(K, kind, a.real("blend", 0));
      });
      note_tangent(K, object.fingerprint, object.workpiece().discretization().axisymmetric);
      return to_freefem(a.stack(), K, full);
    });
  }
};
basicAC_F0::name_and_type Tangent::names[] = {
    {"kind", &typeid(string*)}, {"blend", &typeid(double)}, {"full", &typeid(bool)}};

void register_material_events() {
  using H = MaterialHandle;
  add_method<H, EventsTag>(
      "events", [] { return new OneOperator2_<double, Method<H, EventsTag>, double>(earliest_events); },
      [] { return new OneOperator3_<double, Method<H, EventsTag>, double, double>(events_but_noise); },
      [] { return new OneOperator1_<double, Method<H, EventsTag>>(all_events); });
  add_method<H, AcceptEventsTag>(
      "acceptevents", [] { return new OneOperator1_<long, Method<H, AcceptEventsTag>>(accept_events); });
  add_method<H, KeepTag>("keepplastic",
                         [] { return new OneOperator2_<bool, Method<H, KeepTag>, double>(keep_plastic); });
  add_method<H, DropTag>("dropevents",
                         [] { return new OneOperator1_<bool, Method<H, DropTag>>(drop_events); });
}

} // namespace

TangentKind tangent_kind(const std::string& name) {
  if (name == "consistent") return TangentKind::CONSISTENT;
  if (name == "rate") return TangentKind::RATE;
  if (name == "elastic") return TangentKind::ELASTIC;
  fail("material.tangent", "unknown kind \"" + name + "\", expected \"consistent\", \"rate\" or \"elastic\"");
}

void register_material() {
  using H = MaterialHandle;
  Dcl_Type<H*>(InitP<H>, Destroy<H>);
  zzzfff->Add("material", atype<H*>());
  Dcl_Type<Made<MaterialObject>>();
  TheOperators->Add("<-", new OneOperator2_<H*, H*, Made<MaterialObject>>(take_over<MaterialObject>));
  Global.Add("rcMaterial", "(", new NamedOperator<MakeMaterial<2>, Made<MaterialObject>, pfes*>);
  Global.Add("rcMaterial", "(", new NamedOperator<MakeMaterial<3>, Made<MaterialObject>, pfes3*>);
  add_method<H, UpdateTag>("update", [] {
    return new OneOperator4s_<long, Method<H, UpdateTag>, KN_<double>, double, long>(update);
  });
  add_method<H, ForceTag>("force",
                          [] { return new OneOperator2s_<double, Method<H, ForceTag>, KN_<double>>(force); });
  add_method<H, AcceptTag>("accept", [] { return new OneOperator1_<bool, Method<H, AcceptTag>>(accept); });
  add_method<H, RevertTag>("revert", [] { return new OneOperator1_<bool, Method<H, RevertTag>>(revert); });
  register_material_events();
  add_method<H, TangentTag>("tangent", [] {
    return new NamedOperator<Tangent, newpMatrice_Creuse<double>, Method<H, TangentTag>>;
  });
  add_method<H, SecondsTag>(
      "seconds", [] { return new OneOperator2_<double, Method<H, SecondsTag>, string*>(seconds); });
}

} // namespace burnish
