#include "contact/surface_share.hpp"
#include <cmath>
#include <map>

namespace burnish {

EdgeMasses edge_masses(const BodyView<2>& body, const Facet<2>& edge, const Eigen::VectorXd& u) {
  const bool quadratic = edge.middle[0] >= 0;
  const Vector<2> a = body.position(u, edge.vertex[0]), b = body.position(u, edge.vertex[1]);
  const Vector<2> m = quadratic ? body.position(u, edge.middle[0]) : Vector<2>(0.5 * (a + b));
  const double length = (m - a).norm() + (b - m).norm();
  const double point[] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)},
               weight[] = {5. / 18, 4. / 9, 5. / 18};
  EdgeMasses mass = EdgeMasses::Zero();
  for (int g = 0; g < 3; ++g) {
    const double s = point[g], t = 1 - s;
    Eigen::Vector3d N(t, s, 0);
    if (quadratic) N = {t * (t - s), s * (s - t), 4 * s * t};
    const double r = quadratic ? N[0] * a.x() + N[1] * b.x() + N[2] * m.x() : t * a.x() + s * b.x();
    const double area = weight[g] * length * (body.axisymmetric ? 2 * std::acos(-1.) * r : 1);
    mass += area * N * Eigen::RowVector2d(t, s);
  }
  return mass;
}

template <int Dim>
Eigen::VectorXd surface_shares(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                               const std::vector<Facet<2>>& edges, const Eigen::VectorXd& u) {
  std::map<int, int> index;
  for (std::size_t i = 0; i < model.candidates.size(); ++i) index[model.candidates[i]] = static_cast<int>(i);
  Eigen::VectorXd area = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.candidates.size()));
  for (const Facet<2>& edge : edges) {
    const Eigen::Vector3d share = edge_masses(body, edge, u).rowwise().sum();
    const int nodes[] = {edge.vertex[0], edge.vertex[1], edge.middle[0]};
    for (int i = 0; i < 3; ++i) {
      const auto it = index.find(nodes[i]);
      if (it != index.end()) area[it->second] += share[i];
    }
  }
  return area;
}

template Eigen::VectorXd surface_shares<2>(const ContactModel<2>&, const BodyView<2>&,
                                           const std::vector<Facet<2>>&, const Eigen::VectorXd&);

} // namespace burnish
