#include "contact/linearization.hpp"

namespace burnish {

template <int Dim>
NodeLinearization<Dim> linearize_node(const ContactModel<Dim>& model, const ContactNode<Dim>& node,
                                      int candidate, const std::vector<Pose<Dim>>& poses,
                                      const Vector<Dim>& R, GeometricTerms terms) {
  NodeLinearization<Dim> result;
  result.candidate = candidate;
  result.tool = node.tool;
  result.sliding = node.state == NodeState::SLIDING && !model.is_constrained(candidate);
  const ContactPoint<Dim> at = contact_point(model, poses, node);
  const SurfacePoint<Dim>& p = result.point = at.surface;
  result.x_q = p.x_q;
  if (model.is_constrained(candidate))
    result.x_q = admissible_normal(model, candidate, p.n) * (p.n.transpose() * result.x_q);
  const Vector<Dim> F = result.F = nodal_force(model, candidate, p, R).F;
  const Eigen::Index nq = p.x_q.cols();
  for (int k = 0; k < nq; ++k) result.at.push_back(model.first[node.tool] + k);
  result.geo_sq = result.geo_qs = Eigen::MatrixXd::Zero(Dim - 1, nq);
  result.geo_qq = Eigen::MatrixXd::Zero(nq, nq);
  if (result.sliding) {
    const SlidingRows<Dim> rows = model.law(candidate, node.tool).rows(p, F, at.m, node.tributary_area);
    result.W = rows.W;
    result.constant = rows.constant;
    if (terms != GeometricTerms::NONE) {
      result.geo_ss = rows.by_slip;
      result.geo_sq = rows.by_q;
    }
    for (Eigen::Index a = 0; terms == GeometricTerms::COMPLETE && a < Dim - 1; ++a)
      result.geo_qs.row(a) = F.transpose() * p.E_q[static_cast<std::size_t>(a)];
  }
  if (terms == GeometricTerms::COMPLETE)
    for (Eigen::Index k = 0; k < nq; ++k) result.geo_qq.row(k) = F.transpose() * p.x_qq[k];
  return result;
}

template NodeLinearization<2> linearize_node<2>(const ContactModel<2>&, const ContactNode<2>&, int,
                                                const std::vector<Pose<2>>&, const Vector<2>&,
                                                GeometricTerms);
template NodeLinearization<3> linearize_node<3>(const ContactModel<3>&, const ContactNode<3>&, int,
                                                const std::vector<Pose<3>>&, const Vector<3>&,
                                                GeometricTerms);

} // namespace burnish
