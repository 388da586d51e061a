#include "contact/linearization.hpp"

namespace burnish {
namespace {

// Rows and (s,.) terms of a sliding node in the plane.
void add_sliding_terms(NodeLinearization<2>& node, const FrictionLaw& law, double area, double sgn,
                       const Vector<2>& F, GeometricTerms terms) {
  const auto& p = node.point;
  const Vector<2> x_s = p.x_s.col(0), x_ss = p.x_ss[0].col(0), n_s = p.n_s.col(0);
  const double length = x_s.norm(), N = F.dot(p.n);
  const double g = law.limit(N, area), slope = law.slope(N, area);
  node.tau = x_s + sgn * length * slope * p.n;
  node.constant = sgn * length * (g - slope * N);
  if (terms == GeometricTerms::NONE) return;
  const double length_s = x_s.dot(x_ss) / length;
  node.geo_ss = F.dot(x_ss) + sgn * (length_s * g + length * slope * F.dot(n_s));
  for (Eigen::Index k = 0; k < p.x_q.cols(); ++k) {
    const Vector<2> x_qs = p.x_qs[0].col(k), n_q = p.n_q.col(k);
    const double length_q = x_s.dot(x_qs) / length;
    node.geo_sq[k] = F.dot(x_qs) + sgn * (length_q * g + length * slope * F.dot(n_q));
    if (terms == GeometricTerms::COMPLETE) node.geo_qs[k] = F.dot(x_qs);
  }
}

} // namespace

template <int Dim>
NodeLinearization<Dim> linearize_node(const ContactModel<Dim>& model, const ContactNode<Dim>& node,
                                      int candidate, const std::vector<Pose<Dim>>& poses,
                                      const Vector<Dim>& R, GeometricTerms terms) {
  static_assert(Dim == 2, "sliding in space needs the rows r_j of method.md section 3");
  NodeLinearization<Dim> result;
  result.candidate = candidate;
  result.tool = node.tool;
  result.sliding = node.state == NodeState::SLIDING && !model.is_held(candidate);
  result.point = model.tools[node.tool]->surface(poses[node.tool], node.s);
  result.x_q = result.point.x_q;
  if (model.is_held(candidate))
    result.x_q = normal_lift(model, candidate, result.point.n) * (result.point.n.transpose() * result.x_q);
  const Vector<Dim> F = nodal_force(model, candidate, result.point, R).F;
  const Eigen::Index nq = result.point.x_q.cols();
  result.geo_sq = result.geo_qs = Eigen::VectorXd::Zero(nq);
  result.geo_qq = Eigen::MatrixXd::Zero(nq, nq);
  if (result.sliding)
    add_sliding_terms(result, *model.friction[node.tool], node.area, node.slip_sign, F, terms);
  if (terms == GeometricTerms::COMPLETE)
    for (Eigen::Index k = 0; k < nq; ++k) result.geo_qq.row(k) = F.transpose() * result.point.x_qq[k];
  return result;
}

template <int Dim> double sliding_residual(const NodeLinearization<Dim>& node, const Vector<Dim>& F) {
  return node.tau.dot(F) + node.constant;
}

template NodeLinearization<2> linearize_node<2>(const ContactModel<2>&, const ContactNode<2>&, int,
                                                const std::vector<Pose<2>>&, const Vector<2>&,
                                                GeometricTerms);
template double sliding_residual<2>(const NodeLinearization<2>&, const Vector<2>&);

} // namespace burnish
