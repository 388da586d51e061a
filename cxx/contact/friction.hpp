#pragma once
// Friction laws: largest tangential nodal force as a function of the normal one.
#include <memory>

namespace burnish {

/// Friction limit g(N, A) and its slope dg/dN; a node sticks while |T| <= g and slides with |T| = g, opposing
/// slip. A is the node's share of the surface, so that laws of pressure p = N/A and traction read
/// g = A t(N/A) [A: length per unit thickness in plane strain, area of the whole ring when axisymmetric].
class FrictionLaw {
public:
  virtual ~FrictionLaw() = default;
  /// @param N normal nodal force; an iteration may pass through N < 0 [force]; @param area A > 0
  /// @return g [force], >= 0 for N >= 0
  virtual double limit(double N, double area) const = 0;
  virtual double slope(double N, double area) const = 0; ///< dg/dN [-]
  virtual bool frictionless() const { return false; }
  /// True for full sticking: the limit is infinite, a node never slides, it is released directly.
  virtual bool sticks_always() const { return false; }
};

class NoFriction final : public FrictionLaw {
public:
  double limit(double, double) const override { return 0; }
  double slope(double, double) const override { return 0; }
  bool frictionless() const override { return true; }
};

/// Coulomb: g = mu N (linear also for the N < 0 that an iteration may pass through).
class CoulombFriction final : public FrictionLaw {
public:
  /// @throws std::invalid_argument if mu < 0 or not finite
  explicit CoulombFriction(double mu);
  double limit(double N, double) const override { return m_mu * N; }
  double slope(double, double) const override { return m_mu; }
  double mu() const { return m_mu; }

private:
  double m_mu;
};

/// NoFriction for mu == 0, else CoulombFriction.
std::shared_ptr<const FrictionLaw> make_coulomb(double mu);

} // namespace burnish
