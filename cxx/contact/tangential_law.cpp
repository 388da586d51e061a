#include "contact/tangential_law.hpp"
#include "base/error.hpp"
#include "contact/mean_slip.hpp"
#include <algorithm>

namespace burnish {

template <int Dim>
TangentialLaw<Dim>::TangentialLaw(std::shared_ptr<const FrictionLaw> friction)
    : m_friction(std::move(friction)) {
  if (!m_friction) fail("TangentialLaw", "no friction law");
}

template <int Dim>
Change TangentialLaw<Dim>::test(NodeState state, double N, const DecidingForce<Dim>& deciding,
                                const Param<Dim>& slip, const Param<Dim>& m,
                                const ContactTolerance& tolerance) const {
  const SurfaceForce<Dim>& force = deciding.force;
  const bool tension = N < -tolerance.force;
  if (state == NodeState::SLIDING) {
    if (tension) return Change::RELEASE;
    const bool may_stick = !frictionless() && !deciding.unpressed;
    return may_stick && slips_back(slip, m, tolerance.slip) ? Change::STICK : Change::NONE;
  }
  if (tension) { // with little friction to take off, the direction of sliding would be one of rounding
    const double drawn = Dim == 3 ? capacity(-N, deciding.area) : 0;
    const bool held = force.T.norm() > std::max(drawn, tolerance.force);
    return m_friction->sticks_always() || !held ? Change::RELEASE : Change::SLIDE;
  }
  if (deciding.unpressed) return Change::SLIDE;
  return force.T.norm() > capacity(deciding) + tolerance.force ? Change::SLIDE : Change::NONE;
}

template <int Dim>
double TangentialLaw<Dim>::sliding_residual(const DecidingForce<Dim>& deciding, const Param<Dim>& m) const {
  const SurfaceForce<Dim>& force = deciding.force;
  return deciding.unpressed ? force.T.norm()
                            : (force.T + m * m_friction->limit(force.N, deciding.area)).norm();
}

template <int Dim> double TangentialLaw<Dim>::reserve(const DecidingForce<Dim>& deciding) const {
  const SurfaceForce<Dim>& force = deciding.force;
  return (deciding.unpressed ? 0 : m_friction->limit(force.N, deciding.area)) - force.T.norm();
}

template <int Dim> double TangentialLaw<Dim>::capacity(double N, double area) const {
  return m_friction->limit(std::max(N, 0.), area);
}

template <int Dim> Param<Dim> TangentialLaw<Dim>::slip_against(const Param<Dim>& T) const {
  if (frictionless()) return Param<Dim>::Zero();
  const double size = T.norm();
  return size > 0 ? Param<Dim>(-T / size) : Param<Dim>(Param<Dim>::Unit(0)); // without a force: any direction
}

template <int Dim> ConeTangent TangentialLaw<Dim>::cone(double N, double area) const {
  const double slope = m_friction->slope(N, area);
  return {slope, m_friction->limit(N, area) - slope * N};
}

template <int Dim> ConeTangent TangentialLaw<Dim>::cone(const DecidingForce<Dim>& deciding) const {
  return deciding.unpressed ? ConeTangent{} : cone(deciding.force.N, deciding.area);
}

template <int Dim>
SlidingRows<Dim> TangentialLaw<Dim>::rows(const SurfacePoint<Dim>& p, const Vector<Dim>& F,
                                          const Param<Dim>& m, const ConeTangent& cone,
                                          const SlipTurn<Dim>& turn) {
  const double N = F.dot(p.n), slope = cone.slope;
  const Param<Dim> T = p.E.transpose() * F;
  const Curvature<Dim> kept = Curvature<Dim>::Identity() - turn.H;
  SlidingRows<Dim> rows;
  rows.W = p.E * kept + slope * p.n * m.transpose();
  rows.constant = cone.constant * m + turn.held;
  rows.by_slip = -N * (kept * p.B) + slope * m * (p.B * T).transpose();
  rows.by_q.resize(Dim - 1, p.x_q.cols());
  for (Eigen::Index a = 0; a < rows.by_q.rows(); ++a)
    rows.by_q.row(a) = F.transpose() * p.E_q[static_cast<std::size_t>(a)];
  rows.by_q = (kept * rows.by_q).eval();
  rows.by_q += m * (slope * F.transpose() * p.n_q);
  return rows;
}

template <int Dim>
SlipTurn<Dim> TangentialLaw<Dim>::turn(const DecidingForce<Dim>& deciding, const Param<Dim>& m,
                                       const Param<Dim>& slip, const Curvature<Dim>& slip_by_eta,
                                       double c) const {
  constexpr double aligned = 1e-6; // of unit vectors
  SlipTurn<Dim> turn;
  const Param<Dim> tau = deciding.force.T - c * slip;
  const double size = tau.norm();
  if (Dim == 2 || !(c > 0) || !(size > 0) || frictionless() || deciding.unpressed) return turn;
  if ((tau + size * m).norm() > aligned * size)
    return turn; // it begins to slide, that way: METHOD.md (3.14) has not been taken
  const double part = std::min(1., capacity(deciding) / size);
  turn.H = part * (Curvature<Dim>::Identity() - m * m.transpose());
  turn.held = c * turn.H * slip; // H (T - c D) = 0
  turn.cHD = c * turn.H * slip_by_eta;
  return turn;
}

template <int Dim>
double TangentialLaw<Dim>::slip_stiffness(const DecidingForce<Dim>& deciding, const Param<Dim>& slip,
                                          const ContactState<Dim>& state) const {
  const double c = state.slip_stiffness, size = slip.norm();
  if (!state.fixed || !(c > 0)) return c;
  const double own = c / SLIP_STIFFNESS, g = capacity(deciding.force.N, deciding.area);
  return g > 0 ? std::max(c, g * own / (g + own * size)) : c;
}

template <int Dim>
SlipTurn<Dim> TangentialLaw<Dim>::first_turn(const Param<Dim>& m, const Param<Dim>& slip, double c) {
  SlipTurn<Dim> turn;
  if (Dim == 2 || !(c > 0) || slips_back(slip, m, 0)) return turn;
  turn.H = Curvature<Dim>::Identity() - m * m.transpose();
  turn.cHD = c * turn.H;
  turn.held = turn.cHD * slip;
  return turn;
}

template class TangentialLaw<2>;
template class TangentialLaw<3>;

} // namespace burnish
