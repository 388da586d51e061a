#include "material/strain_path.hpp"

namespace burnish {

template <int Dim>
StrainPath<Dim> strain_path(const ElasticModuli& elastic, const StepKinematics<Dim>& kin,
                            const Stress<Dim>& elastic_increment, const PathHistory<Dim>& history,
                            PathDerivative<Dim>* derivative) {
  StrainPath<Dim> path{elastic_increment, Stress<Dim>::Zero()};
  if (derivative) *derivative = {deviatoric_moduli<Dim>(elastic), StressByIncrement<Dim>::Zero()};
  if (history.ratio <= 0) return path;

  const Stress<Dim>& dd = kin.strain;
  const bool turns = kin.frame == StrainFrame::END;
  Stress<Dim> before = history.ratio * history.strain_old;
  if (turns) before = rotated(before, kin);
  const Stress<Dim> change = dd - before; // dd - ra dd_p
  double b = 2 * history.ratio / (1 + history.ratio);
  // limiter: no more curvature than L times the step itself
  const double dd2 = contract<Dim>(dd, dd), change2 = contract<Dim>(change, change);
  const bool limited = change2 > history.limit * history.limit * dd2;
  if (limited) b *= history.limit * std::sqrt(dd2 / change2);
  path.curvature = deviatoric_stress<Dim>(elastic, b * change);
  if (!derivative || b == 0) return path;

  StressByIncrement<Dim> change_by = strain_by_increment<Dim>();
  if (turns) change_by.template rightCols<PointTraits<Dim>::num_rotations>() -= spin_rate(before);
  StressByIncrement<Dim> curvature_by = b * change_by;
  if (limited) { // d(b)/b = dd:d(dd)/|dd|^2 - c:dc/|c|^2 with c the change
    const ScalarByIncrement<Dim> b_by = (b / dd2) * contraction_row<Dim>(dd) * strain_by_increment<Dim>() -
                                        (b / change2) * contraction_row<Dim>(change) * change_by;
    curvature_by.noalias() += change * b_by;
  }
  for (int k = 0; k < num_increments<Dim>; ++k)
    derivative->curvature.col(k) = deviatoric_stress<Dim>(elastic, curvature_by.col(k));
  return path;
}

template StrainPath<2> strain_path<2>(const ElasticModuli&, const StepKinematics<2>&, const Stress<2>&,
                                      const PathHistory<2>&, PathDerivative<2>*);
template StrainPath<3> strain_path<3>(const ElasticModuli&, const StepKinematics<3>&, const Stress<3>&,
                                      const PathHistory<3>&, PathDerivative<3>*);

} // namespace burnish
