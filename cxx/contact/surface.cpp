#include "contact/surface.hpp"
#include <map>
#include <set>

namespace burnish {

std::vector<int> nodes_along(const std::vector<SurfaceEdge>& edges) {
  std::map<int, std::vector<std::size_t>> at; // edges of each end node
  for (std::size_t e = 0; e < edges.size(); ++e) {
    at[edges[e].a].push_back(e);
    at[edges[e].b].push_back(e);
  }
  std::vector<int> order;
  std::set<int> seen;
  std::vector<char> used(edges.size(), 0);
  const auto add = [&](int node) {
    if (node >= 0 && seen.insert(node).second) order.push_back(node);
  };
  const auto walk = [&](int node) {
    for (bool more = true; more;) {
      add(node);
      more = false;
      for (const std::size_t e : at[node]) {
        if (used[e]) continue;
        used[e] = 1;
        add(edges[e].middle);
        node = edges[e].a == node ? edges[e].b : edges[e].a;
        more = true;
        break;
      }
    }
  };
  for (const auto& [node, list] : at)
    if (list.size() == 1 && !used[list[0]]) walk(node);
  for (const auto& edge : edges) walk(edge.a); // closed chains
  return order;
}

namespace {

template <int Dim>
Eigen::VectorXd tributary_lengths(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                  const std::vector<SurfaceEdge>& edges, const Eigen::VectorXd& u) {
  std::map<int, int> index;
  for (std::size_t i = 0; i < model.candidates.size(); ++i) index[model.candidates[i]] = static_cast<int>(i);
  Eigen::VectorXd length = Eigen::VectorXd::Zero(model.candidates.size());
  const auto add = [&](int node, double part) {
    const auto it = index.find(node);
    if (it != index.end()) length[it->second] += part;
  };
  for (const SurfaceEdge& edge : edges) {
    const Vector<Dim> a = body.position(u, edge.a), b = body.position(u, edge.b);
    if (edge.middle < 0) {
      add(edge.a, 0.5 * (b - a).norm());
      add(edge.b, 0.5 * (b - a).norm());
      continue;
    }
    const Vector<Dim> m = body.position(u, edge.middle);
    const double whole = (m - a).norm() + (b - m).norm();
    add(edge.a, whole / 6);
    add(edge.b, whole / 6);
    add(edge.middle, whole * 2 / 3);
  }
  return length;
}

} // namespace

template <int Dim>
SurfaceReport<Dim> surface_report(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                  const ContactState<Dim>& state, const std::vector<SurfaceEdge>& edges,
                                  const Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  SurfaceReport<Dim> report;
  const Eigen::Index n = static_cast<Eigen::Index>(model.candidates.size());
  report.gap = report.normal_force = report.tangential_force = Eigen::VectorXd::Zero(n);
  report.length = tributary_lengths(model, body, edges, u);
  const auto poses = model.poses(state.q);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& node = state.nodes[i];
    const int mesh_node = model.candidates[i];
    if (!in_contact(node.state)) {
      report.gap[i] = nearest_tool(model, poses, body.position(u, mesh_node), node).foot.gap;
      continue;
    }
    const auto p = model.tools[node.tool]->surface(poses[node.tool], node.s);
    const Vector<Dim> F = R.template segment<Dim>(Dim * mesh_node);
    report.normal_force[i] = F.dot(p.n);
    report.tangential_force[i] = F.dot(p.x_s.col(0).normalized());
  }
  report.pressure = report.normal_force.cwiseQuotient(report.length);
  report.traction_tangential = report.tangential_force.cwiseQuotient(report.length);
  return report;
}

template SurfaceReport<2> surface_report<2>(const ContactModel<2>&, const BodyView<2>&,
                                            const ContactState<2>&, const std::vector<SurfaceEdge>&,
                                            const Eigen::VectorXd&, const Eigen::VectorXd&);

} // namespace burnish
