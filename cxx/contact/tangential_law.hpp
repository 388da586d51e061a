#pragma once
// What happens along the surface at a node in contact: the cone of friction, stick, slip and release. The only place
// that knows them (METHOD.md 3.1, 3.10).
#include "contact/contact_state.hpp"
#include "contact/friction.hpp"
#include "kinematics/tool.hpp"

namespace burnish {

/// Force of the tool on a node, in the frame of its surface point: T = E'F, N = n.F [force].
template <int Dim> struct SurfaceForce {
  double N = 0;
  Param<Dim> T = Param<Dim>::Zero();
};

/// Force and area by which stick and slip of a contact node are decided: its own, and half of those of the mid nodes that
/// are tied to it (tied_edges.hpp).
template <int Dim> struct DecidingForce {
  SurfaceForce<Dim> force; ///< [force]
  double area = 1;         ///< [length or area]
  double normal =
      0; ///< by which it is released: its own N, of a weightless vertex with the shares of all mid nodes [force]
  bool unpressed =
      false; ///< a weightless vertex that the shares of the mid nodes tied to it do not press: it slides, T = 0
};

/// What a node in contact is found to do next.
enum class Change : char { NONE, RELEASE, STICK, SLIDE };

/// Absolute tolerances of the tests.
struct ContactTolerance {
  double force = 0; ///< tension and excess over the cone that do not count [force]
  double slip = 0;  ///< slip against the friction that does not count [length]
};

/// The cone at a normal force, linear in it: g(N) = slope N + constant.
struct ConeTangent {
  double slope = 0, constant = 0; ///< [-], [force]
};

/// How the direction of slip turns, METHOD.md (3.14) to (3.16): dm = -H (dT - c dD)/g. Zero in the plane.
template <int Dim> struct SlipTurn {
  Curvature<Dim> H = Curvature<Dim>::Zero();   ///< g/|tau| (I - m m') [-]
  Param<Dim> held = Param<Dim>::Zero();        ///< c H D [force]
  Curvature<Dim> cHD = Curvature<Dim>::Zero(); ///< c H dD/d(eta) of the node's own slip [force/length]
};

/// Rows of a sliding node and their geometric terms, see NodeLinearization.
template <int Dim> struct SlidingRows {
  Tangents<Dim> W;        ///< rows W'F + constant = 0
  Param<Dim> constant;    ///< [force]
  Curvature<Dim> by_slip; ///< change with the node's own slip, at constant F [force/length]
  Eigen::MatrixXd by_q;   ///< change with the coordinates of its tool, Dim-1 x q
};

/// A friction law along the surface. m is the direction of slip in the tangents E of the surface point, a unit vector,
/// zero without friction; slip and traction are vectors of Dim-1 numbers.
///   sticks   |T| <= g(N)      slides   T = -m g(N), m along the slip
/// g goes on below N = 0 as the friction law says; a node there is released or slides before that matters.
/// In space m turns with slip and force: the derivative (METHOD.md 3.12) is in rows(), and nowhere else.
template <int Dim> class TangentialLaw {
public:
  /// @throws std::invalid_argument for a null law
  explicit TangentialLaw(std::shared_ptr<const FrictionLaw> friction);
  const FrictionLaw& friction() const { return *m_friction; }
  bool frictionless() const { return m_friction->frictionless(); }

  /// State test of a node in contact.
  ///   slides: released at tension, sticks when it has slipped against its direction
  ///   sticks: slides outside the cone; at tension it slides while it has friction, in space more than a pressure as large would
  ///   allow, else, or where it never slides, it is released
  ///   unpressed: slides and does not stick
  /// (METHOD.md 5.4)
  /// @param N the node's own normal force, which tells tension [force]; @param slip of the step, in E [length]
  Change test(NodeState state, double N, const DecidingForce<Dim>& deciding, const Param<Dim>& slip,
              const Param<Dim>& m, const ContactTolerance& tolerance) const;
  /// Unbalanced tangential force of a sliding node, |T + m g(N)| [force].
  double sliding_residual(const DecidingForce<Dim>& deciding, const Param<Dim>& m) const;
  /// g(N) - |T|: what a sticking node has left before it slides; negative outside the cone [force].
  double reserve(const DecidingForce<Dim>& deciding) const;
  /// Largest tangential force; for N < 0 that at N = 0 [force].
  double capacity(double N, double area) const;
  double capacity(const DecidingForce<Dim>& at) const {
    return at.unpressed ? 0 : capacity(at.force.N, at.area);
  }
  /// Direction of slip of a node that begins to slide under T: against it; zero without friction.
  Param<Dim> slip_against(const Param<Dim>& T) const;
  /// Slip along the direction; negative: against the friction force's own sense [length].
  static double advance(const Param<Dim>& slip, const Param<Dim>& m) { return slip.dot(m); }
  /// Whether a node has slipped against its direction by more than the tolerance: it sticks.
  static bool slips_back(const Param<Dim>& slip, const Param<Dim>& m, double tolerance) {
    return advance(slip, m) < -tolerance;
  }

  /// Linearization of T + m g(N) = 0 at the force F on the node (Dim numbers, space).
  SlidingRows<Dim> rows(const SurfacePoint<Dim>& point, const Vector<Dim>& F, const Param<Dim>& m,
                        double area) const {
    return rows(point, F, m, cone(F.dot(point.n), area));
  }
  /// The same with the cone of a node that other nodes hand their forces to, and the turn of its slip. cHD stays out: it
  /// counts once where several nodes share a row.
  static SlidingRows<Dim> rows(const SurfacePoint<Dim>& point, const Vector<Dim>& F, const Param<Dim>& m,
                               const ConeTangent& cone, const SlipTurn<Dim>& turn = {});
  /// @param slip D, and its derivative by the node's own eta; @param c of METHOD.md (3.14); it does not turn at 0 [force/length]
  SlipTurn<Dim> turn(const DecidingForce<Dim>& deciding, const Param<Dim>& m, const Param<Dim>& slip,
                     const Curvature<Dim>& slip_by_eta, double c) const;
  /// The c of one node: that of the state, or where states are fixed METHOD.md (3.14e) [force/length]
  double slip_stiffness(const DecidingForce<Dim>& deciding, const Param<Dim>& slip,
                        const ContactState<Dim>& state) const;
  /// The same of a node that begins to slide along m, METHOD.md (3.14d); zero of one that has slipped against m.
  static SlipTurn<Dim> first_turn(const Param<Dim>& m, const Param<Dim>& slip, double c);
  ConeTangent cone(double N, double area) const;
  ConeTangent cone(const DecidingForce<Dim>& deciding) const;

private:
  std::shared_ptr<const FrictionLaw> m_friction;
};

} // namespace burnish
