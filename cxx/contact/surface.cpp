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

// Quadratic edges in contact: ends x load shares (1/6, 0, 1/3; ...) of the edge's length, fitted to the nodal
// forces.
template <int Dim> class EdgeFit {
public:
  EdgeFit(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
          const std::vector<SurfaceEdge>& edges, const Eigen::VectorXd& u) {
    std::map<int, int> candidate;
    for (std::size_t i = 0; i < model.candidates.size(); ++i)
      candidate[model.candidates[i]] = static_cast<int>(i);
    const auto of = [&](int node) {
      const auto it = candidate.find(node);
      return it == candidate.end() ? -1 : it->second;
    };
    for (const SurfaceEdge& edge : edges) {
      const int a = of(edge.a), b = of(edge.b), m = of(edge.middle);
      if (a < 0 || b < 0 || m < 0) continue;
      if (!in_contact(state.nodes[a].state) && !in_contact(state.nodes[b].state) &&
          !in_contact(state.nodes[m].state))
        continue;
      const double length = (body.position(u, edge.middle) - body.position(u, edge.a)).norm() +
                            (body.position(u, edge.b) - body.position(u, edge.middle)).norm();
      m_edges.push_back({a, b, m, length});
      for (const int end : {a, b}) {
        m_row.emplace(end, static_cast<int>(m_row.size()));
        if (in_contact(state.nodes[end].state)) m_column.emplace(end, static_cast<int>(m_column.size()));
      }
      m_row.emplace(m, static_cast<int>(m_row.size()));
    }
  }
  bool empty() const { return m_column.empty(); }
  /// Fitted values at all candidates; `nodal` stays where no edge is in contact.
  Eigen::VectorXd fit(const Eigen::VectorXd& force, Eigen::VectorXd nodal) const {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(m_row.size(), m_column.size());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(A.rows());
    for (const Edge& e : m_edges) {
      for (const int end : {e.a, e.b}) {
        const auto column = m_column.find(end); // zero at an end that is free
        if (column == m_column.end()) continue;
        A(m_row.at(end), column->second) += e.length / 6;
        A(m_row.at(e.middle), column->second) += e.length / 3;
      }
    }
    for (const auto& [node, row] : m_row) right[row] = force[node];
    const Eigen::VectorXd p = A.colPivHouseholderQr().solve(right);
    for (const auto& [node, column] : m_column) nodal[node] = p[column];
    for (const Edge& e : m_edges) nodal[e.middle] = 0.5 * (nodal[e.a] + nodal[e.b]);
    return nodal;
  }

private:
  struct Edge {
    int a, b, middle;
    double length;
  };
  std::vector<Edge> m_edges;
  std::map<int, int> m_column, m_row;
};

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
      report.gap[i] =
          nearest_tool(model, poses, body.position(u, mesh_node), node, static_cast<int>(i)).foot.gap;
      continue;
    }
    const auto p = model.tools[node.tool]->surface(poses[node.tool], node.s);
    const auto force =
        nodal_force(model, static_cast<int>(i), p, Vector<Dim>(R.template segment<Dim>(Dim * mesh_node)));
    report.normal_force[i] = force.N;
    report.tangential_force[i] = force.T;
  }
  report.pressure = report.normal_force.cwiseQuotient(report.length);
  report.traction_tangential = report.tangential_force.cwiseQuotient(report.length);
  const EdgeFit<Dim> edges_in_contact(model, body, state, edges, u);
  report.pressure_fit = report.pressure;
  report.traction_fit = report.traction_tangential;
  if (edges_in_contact.empty()) return report;
  report.pressure_fit = edges_in_contact.fit(report.normal_force, report.pressure);
  report.traction_fit = edges_in_contact.fit(report.tangential_force, report.traction_tangential);
  return report;
}

template SurfaceReport<2> surface_report<2>(const ContactModel<2>&, const BodyView<2>&,
                                            const ContactState<2>&, const std::vector<SurfaceEdge>&,
                                            const Eigen::VectorXd&, const Eigen::VectorXd&);

} // namespace burnish
