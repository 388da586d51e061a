#pragma once
// One triangle with user-defined events, for their tests.
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/point_events.hpp"

namespace burnish::test {

/// One triangle with its events, led from one deformation gradient to the next.
struct Element {
  Workpiece<2> body;
  PointEvents<2> events;
  explicit Element(double yield_stress = 1.93e8, int nodes = 3) : body(mesh(nodes), law(yield_stress)) {}

  static Discretization<2> mesh(int nodes) {
    if (nodes == 3) return triangles(3, {0, 0, 2, 0, 0, 1}, {0, 1, 2});
    return triangles(6, {0, 0, 2, 0, 0, 1, 1, 0.5, 0, 0.5, 1, 0}, {0, 1, 2, 3, 4, 5});
  }
  static std::shared_ptr<const MaterialLaw<2>> law(double yield_stress) {
    return j2_law<2>(example_material(yield_stress));
  }
  double plastic_strain_eq() const { return plastic_strain_eq_at(body.state(), 0); }
  void step_to(const Tensor<2>& F) {
    ASSERT_EQ(body.update(homogeneous(body.discretization(), F), 1, 0).status, UpdateStatus::OK);
  }
  void accept() {
    events.accept(body);
    body.accept();
  }
  void go_to(const Tensor<2>& F) {
    step_to(F);
    accept();
  }
  void add(const std::string& formula, const std::string& name = "user",
           const std::map<std::string, double>& parameters = {}) {
    events.add(body, name, formula, parameters);
  }
  std::vector<ElementEvent<2>> find() const { return events.find(body); }
  double earliest(double overshoot, double least) {
    events.set_overshoot(overshoot);
    return events.earliest(body, least);
  }
  Stress<2> stress() const { return stress_at(body.state(), 0); }
};

inline constexpr double NEVER_YIELDS = 1e15;
inline Tensor<2> stretch(double e) { return tensor(1 + e, 0, 0, 1); }
inline Tensor<2> shear(double gamma) { return tensor(1, gamma, 0, 1); }

} // namespace burnish::test
