#pragma once
// Friction laws: largest tangential nodal force as a function of the normal one.
#include <memory>

namespace burnish {

/// Friction limit g(N, A) and its slope dg/dN; a node sticks while |T| <= g and slides with |T| = g, opposing
/// slip. A is the node's tributary area (METHOD.md 3.9), so that laws of pressure p = N/A and traction read
/// g = A t(N/A) [A: length per unit thickness in plane strain, area of the whole ring when axisymmetric].
/// Every law goes on continuously below N = 0, with the slope that it has there: an iteration passes through
/// N < 0, and a node that has just touched starts from N = 0.
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

/// Tresca: a sliding node feels the shear traction k under any pressure, g = A k. The same for N <= 0, where
/// the law itself jumps to zero: the contact test releases such a node, so that the jump is that release.
/// With the jump inside the law, or a ramp from zero to A k over small pressures (0.01 k, 0.1 k), dragging a
/// roller over a block took up to twice the iterations, and event stepping did not get through.
/// Where k is much above the pressure (light loads, ends of the contact) a node may find no equilibrium: it
/// is released with its whole traction. LimitedCoulombFriction has no such jump.
class TrescaFriction final : public FrictionLaw {
public:
  /// @param k shear traction [stress]; @throws std::invalid_argument if k < 0 or not finite
  explicit TrescaFriction(double k);
  double limit(double, double area) const override { return area * m_k; }
  double slope(double, double) const override { return 0; }
  double k() const { return m_k; }

private:
  double m_k;
};

/// Coulomb limited by the shear strength k of the softer side: g = min(mu N, A k); the kink is at p = k/mu.
class LimitedCoulombFriction final : public FrictionLaw {
public:
  /// @param k shear strength [stress]; @throws std::invalid_argument if mu < 0, k < 0 or one is not finite
  LimitedCoulombFriction(double mu, double k);
  double limit(double N, double area) const override;
  /// mu below the kink and in it, 0 above.
  double slope(double N, double area) const override;
  double mu() const { return m_mu; }
  double k() const { return m_k; }

private:
  double m_mu, m_k;
};

/// Full sticking: infinite limit, slope 0.
class StickingFriction final : public FrictionLaw {
public:
  double limit(double, double) const override;
  double slope(double, double) const override { return 0; }
  bool sticks_always() const override { return true; }
};

/// Entries of the table in friction_laws.hpp.
struct FrictionKind;
FrictionKind coulomb_kind(); ///< friction=, shearlimit=
FrictionKind tresca_kind();
FrictionKind sticking_kind();

/// NoFriction for mu == 0, else CoulombFriction.
std::shared_ptr<const FrictionLaw> make_coulomb(double mu);
/// NoFriction for k == 0, else TrescaFriction.
std::shared_ptr<const FrictionLaw> make_tresca(double k);
/// NoFriction for mu == 0 or k == 0, else LimitedCoulombFriction.
std::shared_ptr<const FrictionLaw> make_limited_coulomb(double mu, double k);

} // namespace burnish
