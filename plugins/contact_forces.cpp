// Resultants of what acts on the workpiece, accepted state: [Fx, Fy, Mz], force and moment about the point (x0, y0),
// counter-clockwise [force, force*length]; axisymmetric: of the whole ring, [0, Fy, 0]. METHOD.md 3.14
//   C.reaction(x0, y0)   of the supports, all nodes of fixed= | force, force*length
//     x0        point of the moment | length
//     y0        point of the moment | length
//     label=    only those on this boundary | - | all supports | a label of the mesh
//     labels=   on these | - | all supports | labels of the mesh
//   C.contactforce(i, x0, y0)   of a tool | force, force*length
//     i         tool, in the order of C.add | - | | 0 to toolnumber-1
//     x0        point of the moment | length
//     y0        point of the moment | length
//   C.externalforce(M, x0, y0)   of the forces of the script, C.external | force, force*length
//     M         the material
//     x0        point of the moment | length
//     y0        point of the moment | length
//   C.holdforce(x0, y0)   of the soft hold, C.hold | force, force*length
//     x0        point of the moment | length
//     y0        point of the moment | length
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

// f of the run's forces about the point; nothing acts before the run.
template <class F>
Array three(Stack stack, ContactObject& contact, const char* where, double x0, double y0, F f) {
  Resultant<2> sum;
  if (contact.started()) sum = called(where, [&] { return f(ForceBalance<2>(contact.run(), {x0, y0})); });
  return new_array(stack, std::vector<double>{sum.force[0], sum.force[1], sum.moment[0]});
}

struct ReactionTag {};
struct Reaction {
  static const int n = 2;
  static basicAC_F0::name_and_type names[n];
  static Array call(const Named& a, Method<H, ReactionTag> m, double x0, double y0) {
    ContactObject& contact = m->get();
    std::vector<long> labels;
    if (a.has("label")) labels.push_back(a.integer("label", 0));
    if (a.has("labels")) {
      const std::vector<double> list = a.numbers("labels");
      require(!list.empty(), "contact.reaction", "size of labels", 0, ">= 1, or no labels= at all");
      for (const double label : list) labels.push_back(std::lround(label));
    }
    std::vector<int> nodes;
    for (const long label : labels) facets_with(contact.setup->mesh(), {label}, "contact.reaction");
    if (!labels.empty()) nodes = nodes_along(facets_with(contact.setup->mesh(), labels, "contact.reaction"));
    return three(a.stack(), contact, "contact.reaction", x0, y0,
                 [&](const auto& forces) { return forces.reaction(nodes); });
  }
};
basicAC_F0::name_and_type Reaction::names[] = {{"label", &typeid(long)}, {"labels", &typeid(NumberList*)}};

struct ContactForceTag {};
struct ContactForce {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  static Array call(const Named& a, Method<H, ContactForceTag> m, long tool, double x0, double y0) {
    const long tools = static_cast<long>(m->get().setup->tools().size());
    require(tool >= 0 && tool < tools, "contact.contactforce", "tool", tool,
            ("0 to toolnumber-1 = " + std::to_string(tools - 1)).c_str());
    return three(a.stack(), m->get(), "contact.contactforce", x0, y0,
                 [&](const auto& forces) { return forces.contact_force(static_cast<int>(tool)); });
  }
};

struct ExternalTag {};
struct External {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  static Array call(const Named& a, Method<H, ExternalTag> m, MaterialHandle* material, double x0,
                    double y0) {
    m->get().require_same_mesh(material->get(), "contact.externalforce");
    const Eigen::VectorXd internal = material->get().workpiece().internal_force();
    return three(a.stack(), m->get(), "contact.externalforce", x0, y0,
                 [&](const auto& forces) { return forces.external_force(internal); });
  }
};

struct HoldForceTag {};
struct HoldForce {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  static Array call(const Named& a, Method<H, HoldForceTag> m, double x0, double y0) {
    return three(a.stack(), m->get(), "contact.holdforce", x0, y0,
                 [](const auto& forces) { return forces.hold_force(); });
  }
};

struct ImbalanceTag {};
double imbalance(const Method<H, ImbalanceTag>& m, MaterialHandle* const& material) {
  return guarded([&] {
    m->get().require_same_mesh(material->get(), "contact.imbalance");
    if (!m->get().started()) return 0.;
    const Eigen::VectorXd internal = material->get().workpiece().internal_force();
    return called("contact.imbalance", [&] {
      return ForceBalance<2>(m->get().run(), {0, 0}).imbalance(internal);
    });
  });
}

} // namespace

void register_contact_forces() {
  add_method<H, HoldForceTag>("holdforce", [] {
    return new NamedOperator<HoldForce, Array, Method<H, HoldForceTag>, double, double>;
  });
  add_method<H, ReactionTag>(
      "reaction", [] { return new NamedOperator<Reaction, Array, Method<H, ReactionTag>, double, double>; });
  add_method<H, ContactForceTag>("contactforce", [] {
    return new NamedOperator<ContactForce, Array, Method<H, ContactForceTag>, long, double, double>;
  });
  add_method<H, ExternalTag>("externalforce", [] {
    return new NamedOperator<External, Array, Method<H, ExternalTag>, MaterialHandle*, double, double>;
  });
  add_method<H, ImbalanceTag>("imbalance", [] {
    return new OneOperator2_<double, Method<H, ImbalanceTag>, MaterialHandle*>(imbalance);
  });
}

} // namespace burnish
