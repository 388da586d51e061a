#pragma once
// A point with any law, led by the interface that the workpiece uses, for tests of laws with several internal variables.
#include "material/make_law.hpp"
#include "unit/material/j2/point_walk.hpp"

namespace burnish::test {

/// A point between two steps, with all internal variables of its law.
struct LawState {
  Gradient<2> F = undeformed<2>();
  Stress<2> stress = Stress<2>::Zero();
  std::vector<double> internal;
  Stress<2> strain_increment = Stress<2>::Zero();
  bool plastic = false;

  double plastic_strain_eq() const { return internal[0]; }
  Stress<2> backstress() const { return Eigen::Map<const Stress<2>>(internal.data() + 1); }
  PointState<2> view() const {
    return {Eigen::Map<const Gradient<2>>(F.data()), Eigen::Map<const Stress<2>>(stress.data()),
            internal.data(), Eigen::Map<const Stress<2>>(strain_increment.data()), plastic};
  }
};

struct AnyLawPoint {
  std::shared_ptr<const MaterialLaw<2>> law;
  UpdateOptions options;
  LawState old;
  double ratio = 0.8;
  PointTrial trial;

  explicit AnyLawPoint(const LawInput& input, StressUpdate update = StressUpdate::SINGLE)
      : law(make_law<2>(input, "AnyLawPoint")) {
    options.update = update;
    old.internal = law->internal_variables().initial();
  }
  PointStep<2> step(const AnyGradient& F, int iteration = 0) const {
    return {old.view(), F, ratio, iteration, options};
  }
  PointResult update(const AnyGradient& F, LawState& end, int iteration = 0) {
    end.internal.assign(old.internal.size(), std::nan(""));
    PointUpdate<2> now;
    now.internal = end.internal.data();
    const PointResult result = law->update(step(F, iteration), trial, now);
    end.F = F;
    end.stress = now.stress;
    end.strain_increment = now.strain_increment;
    end.plastic = now.plastic;
    return result;
  }
  LawState at(const AnyGradient& F, int iteration = 0) {
    LawState end;
    EXPECT_EQ(update(F, end, iteration).status, UpdateStatus::OK);
    return end;
  }
  void advance(const AnyGradient& F) {
    trial = {};
    old = at(F);
  }
  Gradient<2> piola(const AnyGradient& F, int iteration) {
    return first_piola(at(F, iteration).stress, pull_back<2>(Gradient<2>(F), law->small_strain()));
  }
  /// Relative difference of the consistent tangent at F from finite differences, the number of substeps held.
  double tangent_error(const AnyGradient& F) {
    trial = {};
    const LawState now = at(F);
    PiolaTangent<2> measured;
    for (int c = 0; c < 5; ++c)
      measured.col(c) = finite_difference(
          [&](double t) { return piola(F + t * Gradient<2>::Unit(c), FREEZE_ITERATION); }, 0, 1e-6);
    const PiolaTangent<2> A = law->tangent(TangentKind::CONSISTENT, step(F), trial, now.view());
    return (A - measured).norm() / measured.norm();
  }
  double yield_distance() const { return law->yield_distance(old.stress, old.internal.data()); }
};

/// Elastic numbers of example 1 of the article with others [Pa].
inline LawNumbers with_example_elasticity(LawNumbers numbers) {
  numbers["G"] = 2.7e10;
  numbers["nu"] = 0.32;
  return numbers;
}

} // namespace burnish::test
