#pragma once
// A law whose owner is not the core: stress and moduli are given to the workpiece after each update (UserPoints). What
// is here are its internal variables and the increments of a step.
#include "material/material_law.hpp"

namespace burnish {

template <int Dim> class UserLaw final : public MaterialLaw<Dim> {
public:
  /// Internal variable plastic_strain_eq (ep in formulas), always there for the files, and one scalar per name.
  /// @throws std::invalid_argument if a name is empty or occurs twice
  /// @param small_strain see MaterialLaw::small_strain
  explicit UserLaw(const std::vector<std::string>& internal = {}, bool small_strain = false);
  /// The point moves; stress and internal variables stay those of the start until they are given.
  PointResult update(const PointStep<Dim>& step, PointTrial& trial, PointUpdate<Dim>& now) const override;
  /// Zero: the owner gives the moduli.
  PiolaTangent<Dim> tangent(TangentKind kind, const PointStep<Dim>& step, const PointTrial& trial,
                            const PointState<Dim>& now) const override;
  bool has_moduli() const override { return false; }
  /// With the Jaumann rate, or of small strains.
  StepIncrements<Dim> increments(const PointStep<Dim>& step) const override;
  bool small_strain() const override { return m_small_strain; }

private:
  bool m_small_strain;
};

/// Names separated by commas; blanks around them do not count. "" gives none.
std::vector<std::string> internal_names(const std::string& list);

} // namespace burnish
