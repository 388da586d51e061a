// Resultants of what acts on the workpiece, accepted state: in the plane [Fx, Fy, Mz], force and moment about the point
// (x0, y0), counter-clockwise [force, force*length]; axisymmetric: of the whole ring, [0, Fy, 0]; in space
// [Fx, Fy, Fz, Mx, My, Mz] about (x0, y0, z0). METHOD.md 3.14
//   C.reaction(x0, y0), C.reaction(x0, y0, z0)   of the supports, all nodes of fixed= | force, force*length
//     x0        point of the moment | length
//     y0        point of the moment | length
//     z0        its third coordinate in space | length
//     label=    only those on this boundary | - | all supports | a label of the mesh
//     labels=   on these | - | all supports | labels of the mesh
//   C.contactforce(i, x0, y0), C.contactforce(i, x0, y0, z0)   of a tool | force, force*length
//     i         tool, in the order of C.add | - | | 0 to toolnumber-1
//     x0        point of the moment | length
//     y0        point of the moment | length
//     z0        its third coordinate in space | length
//   C.externalforce(M, x0, y0), C.externalforce(M, x0, y0, z0)   of the forces of the script, C.external | force, force*length
//     M         the material
//     x0        point of the moment | length
//     y0        point of the moment | length
//     z0        its third coordinate in space | length
//   C.holdforce(x0, y0), C.holdforce(x0, y0, z0)   of the soft hold, C.hold | force, force*length
//     x0        point of the moment | length
//     y0        point of the moment | length
//     z0        its third coordinate in space | length
//   C.imbalance(M)   largest component of their sum: forces over the load, moment over load and size | -
//     M         the material
#include "base/error.hpp"
#include "named.hpp"
#include "run/force_balance.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;
using Array = KN_<double>;

// f of the run's forces about the point; nothing acts before the run. In the plane [Fx, Fy, Mz], in space
// [Fx, Fy, Fz, Mx, My, Mz].
template <class F>
Array resultant_of(Stack stack, ContactHandle* handle, const char* where, const std::vector<double>& about,
                   F f) {
  return visit(handle->get(), [&](auto& contact) {
    constexpr int Dim = dim_of<decltype(contact)>;
    require(about.size() == Dim, where, "number of coordinates of the point of the moment", about.size(),
            Dim == 2 ? "2: x0, y0" : "3: x0, y0, z0");
    Vector<Dim> place;
    for (int i = 0; i < Dim; ++i) place[i] = about.at(static_cast<std::size_t>(i));
    Resultant<Dim> sum;
    if (contact.started()) sum = called(where, [&] { return f(ForceBalance<Dim>(contact.run(), place)); });
    std::vector<double> values(sum.force.data(), sum.force.data() + sum.force.size());
    values.insert(values.end(), sum.moment.data(), sum.moment.data() + sum.moment.size());
    return new_array(stack, values);
  });
}

struct ReactionTag {};
struct Reaction {
  static const int n = 2;
  static basicAC_F0::name_and_type names[n];
  static std::vector<long> labels_of(const Named& a) {
    std::vector<long> labels;
    if (a.has("label")) labels.push_back(a.integer("label", 0));
    if (a.has("labels")) {
      const std::vector<double> list = a.numbers("labels");
      require(!list.empty(), "contact.reaction", "size of labels", 0, ">= 1, or no labels= at all");
      for (const double label : list) labels.push_back(std::lround(label));
    }
    return labels;
  }
  static std::vector<int> nodes_of(const Method<H, ReactionTag>& m, const std::vector<long>& labels) {
    return visit(m->get(), [&](auto& contact) {
      const auto& mesh = contact.setup->mesh();
      for (const long label : labels) facets_with(mesh, {label}, "contact.reaction");
      return labels.empty() ? std::vector<int>() : nodes_along(facets_with(mesh, labels, "contact.reaction"));
    });
  }
  template <class... Place> static Array call(const Named& a, Method<H, ReactionTag> m, Place... about) {
    const std::vector<int> nodes = nodes_of(m, labels_of(a));
    return resultant_of(a.stack(), m.object, "contact.reaction", {about...},
                        [&](const auto& forces) { return forces.reaction(nodes); });
  }
};
basicAC_F0::name_and_type Reaction::names[] = {{"label", &typeid(long)}, {"labels", &typeid(NumberList*)}};

struct ContactForceTag {};
struct ContactForce {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  template <class... Place>
  static Array call(const Named& a, Method<H, ContactForceTag> m, long tool, Place... about) {
    const long tools =
        visit(m->get(), [](auto& contact) { return static_cast<long>(contact.setup->tools().size()); });
    require(tool >= 0 && tool < tools, "contact.contactforce", "tool", tool,
            ("0 to toolnumber-1 = " + std::to_string(tools - 1)).c_str());
    return resultant_of(a.stack(), m.object, "contact.contactforce", {about...},
                        [&](const auto& forces) { return forces.contact_force(static_cast<int>(tool)); });
  }
};

struct ExternalTag {};
struct External {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  template <class... Place>
  static Array call(const Named& a, Method<H, ExternalTag> m, MaterialHandle* material, Place... about) {
    const Eigen::VectorXd internal = visit(m->get(), [&](auto& contact) {
      return contact.with_material(material->get(), "contact.externalforce").workpiece().internal_force();
    });
    return resultant_of(a.stack(), m.object, "contact.externalforce", {about...},
                        [&](const auto& forces) { return forces.external_force(internal); });
  }
};

struct HoldForceTag {};
struct HoldForce {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  template <class... Place> static Array call(const Named& a, Method<H, HoldForceTag> m, Place... about) {
    return resultant_of(a.stack(), m.object, "contact.holdforce", {about...},
                        [](const auto& forces) { return forces.hold_force(); });
  }
};

struct ImbalanceTag {};
double imbalance(const Method<H, ImbalanceTag>& m, MaterialHandle* const& material) {
  return on(m.object, [&](auto& contact) {
    constexpr int Dim = dim_of<decltype(contact)>;
    auto& object = contact.with_material(material->get(), "contact.imbalance");
    if (!contact.started()) return 0.;
    const Eigen::VectorXd internal = object.workpiece().internal_force();
    return called("contact.imbalance",
                  [&] { return ForceBalance<Dim>(contact.run(), Vector<Dim>::Zero()).imbalance(internal); });
  });
}

// With the point of the moment of the plane, and of space.
template <class Verb, class Tag, class... Before> void add_resultant(const char* name) {
  using M = Method<H, Tag>;
  add_method<H, Tag>(
      name, [] { return new NamedOperator<Verb, Array, M, Before..., double, double>; },
      [] { return new NamedOperator<Verb, Array, M, Before..., double, double, double>; });
}

} // namespace

void register_contact_forces() {
  add_resultant<HoldForce, HoldForceTag>("holdforce");
  add_resultant<Reaction, ReactionTag>("reaction");
  add_resultant<ContactForce, ContactForceTag, long>("contactforce");
  add_resultant<External, ExternalTag, MaterialHandle*>("externalforce");
  add_method<H, ImbalanceTag>("imbalance", [] {
    return new OneOperator2_<double, Method<H, ImbalanceTag>, MaterialHandle*>(imbalance);
  });
}

} // namespace burnish
