#pragma once
// J2 plasticity with isotropic and kinematic hardening and a corotational rate of the Kirchhoff stress, as a law of the
// workpiece (METHOD.md 1.4 to 1.7, ALGORITHMS.md 2).
#include "material/j2/point_update.hpp"
#include "material/material_law.hpp"

namespace burnish {

/// Internal variables: plastic_strain_eq, the accumulated plastic strain ep [-], and with kinematic hardening the back
/// stress backstress, deviatoric [stress].
template <int Dim> class J2Law final : public MaterialLaw<Dim> {
public:
  /// @throws std::invalid_argument "J2Law: ..." see require_valid(J2Parameters)
  explicit J2Law(J2Parameters material);
  const J2Parameters& parameters() const { return m_material; }

  PointResult update(const PointStep<Dim>& step, PointTrial& trial, PointUpdate<Dim>& now) const override;
  /// Several points of the plane at a time where the machine can and j2/batch/kernel.hpp covers the case.
  RangeResult update_range(const RangeStep<Dim>& step, const RangeUpdate<Dim>& now) const override;
  PiolaTangent<Dim> tangent(TangentKind kind, const PointStep<Dim>& step, const PointTrial& trial,
                            const PointState<Dim>& now) const override;
  StepIncrements<Dim> increments(const PointStep<Dim>& step) const override;
  bool small_strain() const override { return m_material.rate == CorotationalRate::SMALL_STRAIN; }
  /// G, K, and C, gamma of the back stress where there is one.
  std::map<std::string, double> moduli() const override;
  YieldStress yield_stress(double plastic_strain_eq) const override {
    return m_material.yield_stress(plastic_strain_eq);
  }
  /// Distances and powers are those of the stress less the back stress.
  double yield_distance(const Stress<Dim>& stress, const double* internal) const override;
  bool loads(const PointState<Dim>& at, const Stress<Dim>& strain_rate) const override;
  double yield_fraction(const PointStep<Dim>& step, double last, double noise) const override;
  PointLoading loading(const PointStep<Dim>& step) const override;

private:
  J2Parameters m_material;
};

/// A J2Law to hand to a workpiece.
template <int Dim> std::shared_ptr<const MaterialLaw<Dim>> j2_law(J2Parameters material) {
  return std::make_shared<J2Law<Dim>>(std::move(material));
}

} // namespace burnish
