#pragma once
// Friction laws: largest tangential nodal force as a function of the normal one.
#include <memory>

namespace burnish {

/// Friction limit g(N) and its slope g'(N); a node sticks while |T| <= g(N) and slides with |T| = g(N),
/// opposing slip.
class FrictionLaw {
public:
  virtual ~FrictionLaw() = default;
  virtual double limit(double N) const = 0; ///< N >= 0 normal nodal force [force]; returns g(N) >= 0 [force]
  virtual double slope(double N) const = 0; ///< dg/dN [-]
  virtual bool frictionless() const { return false; }
};

class NoFriction final : public FrictionLaw {
public:
  double limit(double) const override { return 0; }
  double slope(double) const override { return 0; }
  bool frictionless() const override { return true; }
};

/// Coulomb: g = mu N (linear also for the N < 0 that an iteration may pass through).
class CoulombFriction final : public FrictionLaw {
public:
  /// @throws std::invalid_argument if mu < 0 or not finite
  explicit CoulombFriction(double mu);
  double limit(double N) const override { return m_mu * N; }
  double slope(double) const override { return m_mu; }
  double mu() const { return m_mu; }

private:
  double m_mu;
};

/// NoFriction for mu == 0, else CoulombFriction.
std::shared_ptr<const FrictionLaw> make_coulomb(double mu);

} // namespace burnish
