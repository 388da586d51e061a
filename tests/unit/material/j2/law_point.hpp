#pragma once
// A point with any law, led by the interface that the workpiece uses, for tests of laws with several internal variables.
#include "material/make_law.hpp"
#include "unit/material/j2/point_walk.hpp"

namespace burnish::test {

/// Dim 2: see AnyGradient.
template <int Dim> using AnyGradientOf = std::conditional_t<Dim == 2, AnyGradient, Gradient<Dim>>;

/// A point between two steps, with all internal variables of its law.
template <int Dim> struct LawStateOf {
  Gradient<Dim> F = undeformed<Dim>();
  Stress<Dim> stress = Stress<Dim>::Zero();
  std::vector<double> internal;
  Stress<Dim> strain_increment = Stress<Dim>::Zero();
  bool plastic = false;

  double plastic_strain_eq() const { return internal[0]; }
  Stress<Dim> backstress() const { return Eigen::Map<const Stress<Dim>>(internal.data() + 1); }
  PointState<Dim> view() const {
    return {Eigen::Map<const Gradient<Dim>>(F.data()), Eigen::Map<const Stress<Dim>>(stress.data()),
            internal.data(), Eigen::Map<const Stress<Dim>>(strain_increment.data()), plastic};
  }
};

template <int Dim> struct LawPointOf {
  std::shared_ptr<const MaterialLaw<Dim>> law;
  UpdateOptions options;
  LawStateOf<Dim> old;
  double ratio = 0.8;
  PointTrial trial;

  explicit LawPointOf(const LawInput& input, StressUpdate update = StressUpdate::SINGLE)
      : law(make_law<Dim>(input, "LawPointOf")) {
    options.update = update;
    old.internal = law->internal_variables().initial();
  }
  PointStep<Dim> step(const AnyGradientOf<Dim>& F, int iteration = 0) const {
    return {old.view(), Gradient<Dim>(F), ratio, iteration, options};
  }
  PointResult update(const AnyGradientOf<Dim>& F, LawStateOf<Dim>& end, int iteration = 0) {
    end.internal.assign(old.internal.size(), std::nan(""));
    PointUpdate<Dim> now;
    now.internal = end.internal.data();
    const PointResult result = law->update(step(F, iteration), trial, now);
    end.F = F;
    end.stress = now.stress;
    end.strain_increment = now.strain_increment;
    end.plastic = now.plastic;
    return result;
  }
  LawStateOf<Dim> at(const AnyGradientOf<Dim>& F, int iteration = 0) {
    LawStateOf<Dim> end;
    EXPECT_EQ(update(F, end, iteration).status, UpdateStatus::OK);
    return end;
  }
  void advance(const AnyGradientOf<Dim>& F) {
    trial = {};
    old = at(F);
  }
  Gradient<Dim> piola(const AnyGradientOf<Dim>& F, int iteration) {
    return first_piola(at(F, iteration).stress, pull_back<Dim>(Gradient<Dim>(F), law->small_strain()));
  }
  /// Relative difference of the consistent tangent at F from finite differences, the number of substeps held.
  double tangent_error(const AnyGradientOf<Dim>& F) {
    trial = {};
    const LawStateOf<Dim> now = at(F);
    PiolaTangent<Dim> measured;
    for (int c = 0; c < num_gradient<Dim>; ++c)
      measured.col(c) = finite_difference(
          [&](double t) { return piola(F + t * Gradient<Dim>::Unit(c), FREEZE_ITERATION); }, 0, 1e-6);
    const PiolaTangent<Dim> A = law->tangent(TangentKind::CONSISTENT, step(F), trial, now.view());
    return (A - measured).norm() / measured.norm();
  }
  double yield_distance() const { return law->yield_distance(old.stress, old.internal.data()); }
};

using LawState = LawStateOf<2>;
using AnyLawPoint = LawPointOf<2>;

/// Elastic numbers of example 1 of the article with others [Pa].
inline LawNumbers with_example_elasticity(LawNumbers numbers) {
  numbers["G"] = 2.7e10;
  numbers["nu"] = 0.32;
  return numbers;
}

} // namespace burnish::test
