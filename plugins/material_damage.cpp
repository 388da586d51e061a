// Damage and healing of points by user-defined events (METHOD.md 1.12; the events: material_events.cpp).
// Formulas of events, M.yielddistance and element events see the effective stress, that of the law; M.stress (unless the law is the
// script's), M.stresseq, M.piola, M.moduli and the forces are those of the body. Not with scheme article; a law of the script is damaged,
// it does not heal, since the core cannot forget the stress that it keeps.
//   M.damage(event)   where the event happens, the integrity of the point falls from 1 in equal parts of some accepted steps;
//       stress, moduli and yield stress are that part of those of the law
//     event     its name, of M.event
//     integrity=   what is left | - | 1e-3 | 0 < integrity < 1
//     steps=    accepted steps that it takes | - | 5 | 1 to 1000000
//     ! damages or heals already, expected one rule an event
//   M.heal(event)   where this one happens, the integrity grows to 1 again; what heals is free of stress and new (plastic
//       strain 0) as it stands
//     event     its name, of M.event
//     steps=    accepted steps that it takes | - | 5 | 1 to 1000000
//     ! has nothing to heal, expected damage to be defined before
//   M.heal()   between steps, as in record: all damaged points begin to heal now; returns their number | -
//     steps=    accepted steps that it takes | - | 5 | 1 to 1000000
//     ! nothing to heal, expected damage to be defined before
//   M.integrity   per quadrature point, 1 without damage | -
//   M.damaged   number of points with integrity below 1 | -
//   M.hasdamage   some damage is defined
#include "named.hpp"
#include "types.hpp"
#include "workpiece/healing.hpp"
#include "workpiece/point_fields.hpp"

namespace burnish {
namespace {

using M = MaterialHandle;
struct DamageTag {};
struct HealTag {};

constexpr double LEAST_INTEGRITY = 1e-3;
constexpr long STEPS = 5, MOST_STEPS = 1000000;

struct Damage {
  static const int n = 2;
  static basicAC_F0::name_and_type names[n];
  static bool call(const Named& a, Method<M, DamageTag> m, string* event) {
    const int steps = static_cast<int>(a.integer("steps", STEPS, 1, MOST_STEPS, "material.damage"));
    return visit(m->get(), [&](auto& material) {
      auto& body = *material.body;
      called("material.damage", [&] {
        body.damage().damage(body.workpiece(), body.user(), *event, a.real("integrity", LEAST_INTEGRITY),
                             steps);
      });
      return true;
    });
  }
};
basicAC_F0::name_and_type Damage::names[] = {{"integrity", &typeid(double)}, {"steps", &typeid(long)}};

struct Heal {
  static const int n = 1;
  static basicAC_F0::name_and_type names[n];
  static bool call(const Named& a, Method<M, HealTag> m, string* event) {
    const int steps = static_cast<int>(a.integer("steps", STEPS, 1, MOST_STEPS, "material.heal"));
    return visit(m->get(), [&](auto& material) {
      called("material.heal", [&] { material.body->damage().heal(material.body->user(), *event, steps); });
      return true;
    });
  }
};
basicAC_F0::name_and_type Heal::names[] = {{"steps", &typeid(long)}};

struct HealAll {
  static const int n = 1;
  static basicAC_F0::name_and_type names[n];
  static long call(const Named& a, Method<M, HealTag> m) {
    const int steps = static_cast<int>(a.integer("steps", STEPS, 1, MOST_STEPS, "material.heal"));
    return visit(m->get(), [&](auto& material) -> long {
      return called("material.heal", [&] { return heal_all(material.workpiece(), steps); });
    });
  }
};
basicAC_F0::name_and_type HealAll::names[] = {{"steps", &typeid(long)}};

KN_<double> integrity(Stack stack, M* const& h) {
  return on(h, [&](auto& material) { return new_array(stack, integrity_field(material.workpiece())); });
}
long damaged(M* const& h) {
  return on(h, [](auto& material) {
    return static_cast<long>((integrity_field(material.workpiece()).array() < 1).count());
  });
}
bool has_damage(M* const& h) {
  return on(h, [](auto& material) { return material.body->has_damage(); });
}

} // namespace

void register_point_damage() {
  add_method<M, DamageTag>("damage",
                           [] { return new NamedOperator<Damage, bool, Method<M, DamageTag>, string*>; });
  add_method<M, HealTag>(
      "heal", [] { return new NamedOperator<Heal, bool, Method<M, HealTag>, string*>; },
      [] { return new NamedOperator<HealAll, long, Method<M, HealTag>>; });
  Add<M*>("integrity", ".", new OneOperator1s_<KN_<double>, M*>(integrity));
  Add<M*>("damaged", ".", new OneOperator1_<long, M*>(damaged));
  Add<M*>("hasdamage", ".", new OneOperator1_<bool, M*>(has_damage));
}

} // namespace burnish
