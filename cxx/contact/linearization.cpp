#include "contact/linearization.hpp"

namespace burnish {
namespace {

// Quarter of the change of an end's row with the slip of an end, at constant F, METHOD.md (3.23a).
template <int Dim>
Curvature<Dim> tied_by_slip(const SurfacePoint<Dim>& p, const Vector<Dim>& F,
                            const Curvature<Dim>& foot_slope, const typename NodeCones<Dim>::End& row,
                            const typename NodeCones<Dim>::End& end) {
  const double N = F.dot(p.n);
  const Param<Dim> T = p.E.transpose() * F, t = foot_slope * T, Bt = p.B * t;
  const Curvature<Dim>&a = row.motion.follows, &b = end.motion.follows;
  Curvature<Dim> turned = -N * (a.transpose() * p.B * b);
  turned -=
      row.motion.lift * (b.transpose() * Bt).transpose() + a.transpose() * Bt * end.motion.lift.transpose();
  if (row.candidate == end.candidate) turned -= 2 * t.dot(row.motion.normal) * row.motion.B;
  const Curvature<Dim> kept = Curvature<Dim>::Identity() - row.turn.H;
  return kept * turned + row.cone.slope * row.m * (b.transpose() * (p.B * T)).transpose();
}

// Half of the rows and terms of a sliding node, in the rows of an end; a quarter where a slip counts twice.
template <int Dim>
TiedRow<Dim> tied_row(const SurfacePoint<Dim>& p, const Vector<Dim>& F, const NodeCones<Dim>& cones,
                      const typename NodeCones<Dim>::End& end, GeometricTerms terms) {
  const Curvature<Dim> kept = Curvature<Dim>::Identity() - end.turn.H;
  const Curvature<Dim>& follows = end.motion.follows;
  const Eigen::Index nq = p.x_q.cols();
  TiedRow<Dim> tied;
  tied.end = end.candidate;
  tied.A = 0.5 * (p.E * follows);
  tied.W = 0.5 * (p.E * follows * kept + end.cone.slope * p.n * end.m.transpose());
  tied.geo_sq = tied.geo_qs = Eigen::MatrixXd::Zero(Dim - 1, nq);
  for (const auto& other : cones.ends)
    tied.geo_ss.push_back(terms == GeometricTerms::NONE
                              ? Curvature<Dim>(Curvature<Dim>::Zero())
                              : Curvature<Dim>(0.25 * tied_by_slip(p, F, cones.foot_slope, end, other)));
  if (terms == GeometricTerms::NONE) return tied;
  Eigen::MatrixXd turned(Dim - 1, nq);
  for (Eigen::Index a = 0; a < Dim - 1; ++a)
    turned.row(a) = F.transpose() * p.E_q[static_cast<std::size_t>(a)];
  turned = (follows.transpose() * turned).eval();
  tied.geo_sq = 0.5 * (kept * turned + end.m * (end.cone.slope * F.transpose() * p.n_q));
  if (terms != GeometricTerms::COMPLETE) return tied;
  tied.geo_qs = 0.5 * turned;
  if (p.growth.size() > 0) tied.geo_qs += 0.5 * (follows.transpose() * (p.E.transpose() * F)) * p.growth;
  return tied;
}

// A surface point as the node's supports let it move there: with its admissible normal, tangents and motions.
template <int Dim>
SurfacePoint<Dim> admitted(const ContactModel<Dim>& model, int candidate, SurfacePoint<Dim> p,
                           const Curvature<Dim>& free) {
  if (!model.is_constrained(candidate)) return p;
  const Vector<Dim> n = admissible_normal(model, candidate, p.n);
  p.E = (p.E * free).eval();
  p.x_q = (n * (p.n.transpose() * p.x_q) + p.E * (p.E.transpose() * p.x_q)).eval();
  p.n = n;
  return p;
}

// Rows and geometric terms of a node's own slip.
template <int Dim>
void add_slip(const SurfacePoint<Dim>& p, const SlidingRows<Dim>& rows, const Curvature<Dim>& turning,
              GeometricTerms terms, NodeLinearization<Dim>& node) {
  node.W = rows.W;
  node.constant = rows.constant;
  node.geo_ss = turning;
  if (terms != GeometricTerms::NONE) {
    node.geo_ss += rows.by_slip;
    node.geo_sq = rows.by_q;
  }
  for (Eigen::Index a = 0; terms == GeometricTerms::COMPLETE && a < Dim - 1; ++a)
    node.geo_qs.row(a) = node.F.transpose() * p.E_q[static_cast<std::size_t>(a)];
  if (terms == GeometricTerms::COMPLETE && p.growth.size() > 0)
    node.geo_qs += p.E.transpose() * node.F * p.growth;
}

// The slip across the free direction of a guided node is zero: its row has `diagonal` alone.
template <int Dim> void guide(const Curvature<Dim>& free, double diagonal, NodeLinearization<Dim>& node) {
  node.geo_ss = free * node.geo_ss * free + diagonal * (Curvature<Dim>::Identity() - free);
  node.geo_sq = (free * node.geo_sq).eval();
  node.geo_qs = (free * node.geo_qs).eval();
  node.W = (node.W * free).eval();
  node.constant = (free * node.constant).eval();
}

// Rows of the sliding ends of a tied node, by what its own supports leave.
template <int Dim>
void add_ties(const SurfacePoint<Dim>& p, const Curvature<Dim>& free, NodeCones<Dim> cones,
              GeometricTerms terms, NodeLinearization<Dim>& node) {
  for (auto& end : cones.ends) end.motion.follows = (free * end.motion.follows).eval();
  for (const auto& end : cones.ends) node.ties.push_back(tied_row(p, node.F, cones, end, terms));
}

} // namespace

template <int Dim>
NodeLinearization<Dim> linearize_node(const ContactModel<Dim>& model, const ContactNode<Dim>& node,
                                      int candidate, const std::vector<Pose<Dim>>& poses,
                                      const Vector<Dim>& R, GeometricTerms terms,
                                      const NodeCones<Dim>* cones) {
  NodeLinearization<Dim> result;
  result.candidate = candidate;
  result.tool = node.tool;
  const bool tied = cones && cones->tied, constrained = model.is_constrained(candidate);
  result.sliding = node.state == NodeState::SLIDING && model.can_slip(candidate) && !tied;
  const ContactPoint<Dim> at = contact_point(model, poses, node);
  result.point = at.surface;
  const Vector<Dim> F = result.F = nodal_force(model, candidate, at.surface, R).F;
  const Curvature<Dim> free =
      constrained ? slip_space(model, candidate, at.surface) : Curvature<Dim>::Identity();
  const SurfacePoint<Dim> p = admitted(model, candidate, at.surface, free);
  result.x_q = p.x_q;
  result.E = p.E;
  const Eigen::Index nq = p.x_q.cols();
  for (int k = 0; k < nq; ++k) result.at.push_back(model.first[node.tool] + k);
  result.geo_sq = result.geo_qs = Eigen::MatrixXd::Zero(Dim - 1, nq);
  result.geo_qq = Eigen::MatrixXd::Zero(nq, nq);
  if (result.sliding) {
    const TangentialLaw<Dim>& law = model.law(candidate, node);
    const ConeTangent cone = cones ? cones->own : law.cone(F.dot(p.n), node.tributary_area);
    const SlipTurn<Dim> turn = cones ? cones->turn : SlipTurn<Dim>();
    add_slip(p, law.rows(p, F, at.m, cone, turn), turn.cHD, terms, result);
    if (constrained) guide(free, std::max(1., F.norm()), result);
  }
  if (tied) add_ties(p, free, *cones, terms, result);
  for (Eigen::Index k = 0; terms == GeometricTerms::COMPLETE && k < nq; ++k)
    result.geo_qq.row(k) = F.transpose() * p.x_qq[k];
  return result;
}

template NodeLinearization<2> linearize_node<2>(const ContactModel<2>&, const ContactNode<2>&, int,
                                                const std::vector<Pose<2>>&, const Vector<2>&, GeometricTerms,
                                                const NodeCones<2>*);
template NodeLinearization<3> linearize_node<3>(const ContactModel<3>&, const ContactNode<3>&, int,
                                                const std::vector<Pose<3>>&, const Vector<3>&, GeometricTerms,
                                                const NodeCones<3>*);

} // namespace burnish
