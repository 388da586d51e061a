#include "contact/surface.hpp"
#include "contact/surface_share.hpp"
#include <cmath>
#include <map>

namespace burnish {

namespace {

// Quadratic edges in contact: ends x load shares (1/6, 0, 1/3; ...) of the edge's length, fitted to the nodal
// forces.
template <int Dim> class EdgeFit {
public:
  EdgeFit(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
          const std::vector<Facet<2>>& edges, const Eigen::VectorXd& u) {
    std::map<int, int> candidate;
    for (std::size_t i = 0; i < model.candidates.size(); ++i)
      candidate[model.candidates[i]] = static_cast<int>(i);
    const auto of = [&](int node) {
      const auto it = candidate.find(node);
      return it == candidate.end() ? -1 : it->second;
    };
    for (const Facet<2>& edge : edges) {
      const int a = of(edge.vertex[0]), b = of(edge.vertex[1]), m = of(edge.middle[0]);
      if (a < 0 || b < 0 || m < 0) continue;
      if (!in_contact(state.nodes[a].state) && !in_contact(state.nodes[b].state) &&
          !in_contact(state.nodes[m].state))
        continue;
      m_edges.push_back({a, b, m, edge_masses(body, edge, u)});
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
      const int nodes[] = {e.a, e.b, e.m};
      for (int end = 0; end < 2; ++end) {
        const auto column = m_column.find(nodes[end]); // zero at an end that is free
        if (column == m_column.end()) continue;
        for (int i = 0; i < 3; ++i) A(m_row.at(nodes[i]), column->second) += e.mass(i, end);
      }
    }
    for (const auto& [node, row] : m_row) right[row] = force[node];
    const Eigen::VectorXd p = A.colPivHouseholderQr().solve(right);
    for (const auto& [node, column] : m_column) nodal[node] = p[column];
    for (const Edge& e : m_edges) nodal[e.m] = 0.5 * (nodal[e.a] + nodal[e.b]);
    return nodal;
  }

private:
  struct Edge {
    int a, b, m;
    EdgeMasses mass;
  };
  std::vector<Edge> m_edges;
  std::map<int, int> m_column, m_row;
};

} // namespace

template <int Dim>
SurfaceReport<Dim> surface_report(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                  const ContactState<Dim>& state, const std::vector<Facet<2>>& edges,
                                  const Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  SurfaceReport<Dim> report;
  const Eigen::Index n = static_cast<Eigen::Index>(model.candidates.size());
  report.gap = report.normal_force = report.tangential_force = Eigen::VectorXd::Zero(n);
  report.area = surface_shares(model, body, edges, u);
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
  const double smallest = 1e-9 * report.area.maxCoeff(); // a quadratic edge gives its end on the axis nothing
  const Eigen::VectorXd area = (report.area.array() > smallest).select(report.area, INFINITY);
  report.pressure = report.normal_force.cwiseQuotient(area);
  report.traction_tangential = report.tangential_force.cwiseQuotient(area);
  const EdgeFit<Dim> edges_in_contact(model, body, state, edges, u);
  report.pressure_fit = report.pressure;
  report.traction_fit = report.traction_tangential;
  if (edges_in_contact.empty()) return report;
  report.pressure_fit = edges_in_contact.fit(report.normal_force, report.pressure);
  report.traction_fit = edges_in_contact.fit(report.tangential_force, report.traction_tangential);
  return report;
}

template SurfaceReport<2> surface_report<2>(const ContactModel<2>&, const BodyView<2>&,
                                            const ContactState<2>&, const std::vector<Facet<2>>&,
                                            const Eigen::VectorXd&, const Eigen::VectorXd&);

} // namespace burnish
