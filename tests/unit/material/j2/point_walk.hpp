#pragma once
// One step of one quadrature point, and the walk along a path of deformation gradients, for the material's
// tests.
#include "material/j2/law.hpp"
#include "unit/finite_difference.hpp"
#include <functional>

namespace burnish::test {

/// Example 1 of the article [Pa].
inline J2Parameters example_material() { return J2Parameters::from_shear(2.7e10, 0.32, 1.93e8, 9.62e8); }

inline Tensor<2> tensor(double xx, double xy, double yx, double yy) {
  Tensor<2> t;
  t << xx, xy, yx, yy;
  return t;
}

inline Tensor<2> rotation(double angle) {
  return tensor(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
}

/// Gradient in the plane and the stretch out of it, which is 1 in plane strain.
inline Gradient<2> gradient(const Tensor<2>& in_plane, double zz = 1) {
  Gradient<2> F;
  F << in_plane(0, 0), in_plane(0, 1), in_plane(1, 0), in_plane(1, 1), zz;
  return F;
}

inline Tensor<2> in_plane(const Gradient<2>& F) { return tensor(F[0], F[1], F[2], F[3]); }
inline Tensor<2> in_plane(const Stress<2>& t) { return tensor(t[0], t[3], t[3], t[1]); }

/// A gradient, given as such or by its part in the plane.
struct AnyGradient : Gradient<2> {
  template <class Derived> AnyGradient(const Eigen::MatrixBase<Derived>& F) {
    if constexpr (Derived::ColsAtCompileTime == 1)
      Gradient<2>::operator=(F);
    else
      Gradient<2>::operator=(gradient(F));
  }
};
inline StepKinematics<2> kinematics(const AnyGradient& F_old, const AnyGradient& F, StrainFrame frame) {
  return step_kinematics(F_old, F, frame);
}

/// R t R' by tensor products.
inline Stress<2> turned(const Stress<2>& t, const Tensor<2>& R) {
  const Tensor<2> T = R * tensor(t[0], t[3], t[3], t[1]) * R.transpose();
  return {T(0, 0), T(1, 1), t[2], T(0, 1)};
}

/// Its elasticity with another yield stress and modulus, or as they are.
inline J2Parameters example_material(double yield_stress, double hardening_modulus = 9.62e8) {
  return J2Parameters::from_shear(2.7e10, 0.32, yield_stress, hardening_modulus);
}

/// A point between two steps.
struct Point {
  Gradient<2> F = undeformed<2>();
  Stress<2> stress = Stress<2>::Zero();
  double plastic_strain_eq = 0;
  Stress<2> strain_increment = Stress<2>::Zero();
  bool plastic = false;
};

struct PointWalk {
  J2Parameters material = example_material();
  PointScheme scheme;
  StrainFrame frame = StrainFrame::MIDPOINT;
  Point old;

  StepKinematics<2> kinematics(const AnyGradient& F) const { return step_kinematics(old.F, F, frame); }
  J2Start<2> start() const {
    return {Eigen::Map<const Stress<2>>(old.stress.data()), old.plastic_strain_eq,
            Eigen::Map<const Stress<2>>(old.strain_increment.data()), old.plastic};
  }
  ElasticTrial<2> trial(const AnyGradient& F) const {
    return elastic_trial<2>(material.elastic, kinematics(F), old.stress);
  }
  J2End<2> at(const AnyGradient& F) const {
    return updated_point<2>(material, scheme, start(), kinematics(F), trial(F));
  }
  Gradient<2> piola(const AnyGradient& F) const { return first_piola(at(F).stress, inverse(F)); }
  PiolaTangent<2> tangent(const AnyGradient& F) const {
    return consistent_tangent<2>(material, scheme, start(), kinematics(F), F, at(F).stress);
  }
  /// dP/dF by finite differences.
  PiolaTangent<2> measured_tangent(const AnyGradient& F, double step) const {
    PiolaTangent<2> A;
    for (int c = 0; c < A.cols(); ++c) {
      const auto P = [&](double t) { return piola(F + t * Gradient<2>::Unit(c)); };
      A.col(c) = finite_difference(P, 0, step);
    }
    return A;
  }
  /// The end of the step to F becomes the start of the next one.
  void advance(const AnyGradient& F) {
    const J2End<2> now = at(F);
    old = {F, now.stress, now.plastic_strain_eq, kinematics(F).strain, now.plastic};
  }
};

/// Walks F(t), t = 0..1, in n equal steps; substeps(step) of them run where the point is plastic.
inline Point walk(PointWalk point, int n, const std::function<AnyGradient(double)>& F, int substeps) {
  const UpdateOptions options;
  point.old.F = F(0);
  for (int k = 1; k <= n; ++k) {
    const AnyGradient end = F(static_cast<double>(k) / n);
    const bool runs = substeps_needed<2>(point.material, options, point.trial(end),
                                         point.old.plastic_strain_eq, point.old.plastic) > 0;
    point.scheme.substeps = runs ? substeps : 0;
    point.scheme.ratio = k > 1 ? 1 : 0;
    point.advance(end);
  }
  return point.old;
}

/// s on the yield surface in a given direction.
inline Stress<2> on_surface(const J2Parameters& material, const Stress<2>& direction,
                            double plastic_strain_eq) {
  const Stress<2> s = deviator<2>(direction);
  return material.yield_stress(plastic_strain_eq).value / equivalent<2>(s) * s;
}

} // namespace burnish::test
