#pragma once
// A law of space for the tests: St Venant-Kirchhoff, S = lambda tr(E) I + 2 mu E with E = (F'F - I)/2, whose
// energy density is kept as an internal variable. It "yields" where a test says so.
#include "material/material_law.hpp"

namespace burnish::test {

class KirchhoffLaw final : public MaterialLaw<3> {
public:
  KirchhoffLaw(double lambda, double mu)
      : MaterialLaw<3>("St Venant-Kirchhoff", {{"second_piola", "", "stress", TensorKind::SYMMETRIC, 0},
                                               {"energy_density", "w", "stress", TensorKind::SCALAR, 0}}),
        m_lambda(lambda), m_mu(mu) {}
  double yield_at = NEVER; ///< fraction of every step at which all points yield

  Tensor<3> second_piola(const Tensor<3>& F) const { return stress_of((F.transpose() * F - I()) / 2); }
  double energy(const Tensor<3>& F) const {
    const Tensor<3> E = (F.transpose() * F - I()) / 2;
    return 0.5 * (stress_of(E).array() * E.array()).sum();
  }

  PointResult update(const PointStep<3>& step, PointTrial&, PointUpdate<3>& now) const override {
    const Tensor<3> F = mesh_part<3>(step.F), S = second_piola(F);
    now.stress = components(F * S * F.transpose());
    Eigen::Map<Stress<3>>(now.internal + internal_variables().offset(0)) = components(S);
    now.internal[internal_variables().offset(1)] = energy(F);
    now.strain_increment = components(F - mesh_part<3>(Gradient<3>(step.old.F)));
    return {};
  }
  /// dP = dF S + F C:sym(F' dF), column by column.
  PiolaTangent<3> tangent(TangentKind, const PointStep<3>&, const PointTrial&,
                          const PointState<3>& now) const override {
    const Gradient<3> gradient = now.F;
    const Tensor<3> F = mesh_part<3>(gradient), S = second_piola(F);
    PiolaTangent<3> A;
    for (int c = 0; c < 9; ++c) {
      const Gradient<3> unit = Gradient<3>::Unit(c);
      const Tensor<3> dF = mesh_part<3>(unit), half = F.transpose() * dF;
      Gradient<3> column;
      mesh_part<3>(column) = dF * S + F * stress_of((half + half.transpose()) / 2);
      A.col(c) = column;
    }
    return A;
  }
  double yield_fraction(const PointStep<3>&, double last, double) const override {
    return yield_at <= last ? yield_at : NEVER;
  }
  double yield_distance(const Stress<3>&, const double*) const override { return 0; }

private:
  static Tensor<3> I() { return Tensor<3>::Identity(); }
  Tensor<3> stress_of(const Tensor<3>& E) const { return m_lambda * E.trace() * I() + 2 * m_mu * E; }
  static Stress<3> components(const Tensor<3>& t) {
    Stress<3> s;
    for (int k = 0; k < 6; ++k) s[k] = t(PointTraits<3>::place[k][0], PointTraits<3>::place[k][1]);
    return s;
  }
  double m_lambda, m_mu;
};

} // namespace burnish::test
