#include "contact/surface_report.hpp"
#include "contact/facet_fit.hpp"

namespace burnish {
namespace {

template <int Dim>
void read_forces(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
                 const Eigen::VectorXd& u, const Eigen::VectorXd& R, SurfaceReport<Dim>& report) {
  const auto n = static_cast<Eigen::Index>(model.candidates.size());
  report.gap = report.normal_force = Eigen::VectorXd::Zero(n);
  report.tangential_force = Eigen::MatrixXd::Zero(Dim - 1, n);
  const auto poses = model.poses(state.q);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& node = state.nodes[i];
    const int candidate = static_cast<int>(i), mesh_node = model.candidates[i];
    if (!in_contact(node.state)) {
      report.gap[i] = nearest_tool(model, poses, body.position(u, mesh_node), node, candidate).foot.gap;
      continue;
    }
    const auto p = model.tools[node.tool]->point(poses[node.tool], node.place);
    const auto force =
        nodal_force(model, candidate, p, Vector<Dim>(R.template segment<Dim>(Dim * mesh_node)));
    report.normal_force[i] = force.part.N;
    report.tangential_force.col(i) = force.part.T;
  }
}

} // namespace

template <int Dim>
SurfaceReport<Dim> surface_report(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                  const ContactState<Dim>& state, const std::vector<Facet<Dim>>& facets,
                                  const Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  SurfaceReport<Dim> report;
  report.area = tributary_areas(model, body, facets, u);
  read_forces(model, body, state, u, R, report);
  const double least = NO_AREA * report.area.maxCoeff();
  const Eigen::VectorXd area = (report.area.array() > least).select(report.area, INFINITY);
  report.pressure = report.normal_force.cwiseQuotient(area);
  report.traction_tangential = report.tangential_force * area.cwiseInverse().asDiagonal();
  const FacetFit<Dim> facet_fit(model, body, state, facets, u, report.area);
  report.pressure_fit = report.pressure;
  report.traction_fit = report.traction_tangential;
  if (facet_fit.empty()) return report;
  report.pressure_fit = facet_fit.fit(report.normal_force, report.pressure);
  for (int a = 0; a < Dim - 1; ++a)
    report.traction_fit.row(a) =
        facet_fit.fit(report.tangential_force.row(a), report.traction_tangential.row(a)).transpose();
  for (Eigen::Index i = 0; i < area.size(); ++i) {
    if (report.area[i] > least) continue;
    report.pressure[i] = report.pressure_fit[i];
    report.traction_tangential.col(i) = report.traction_fit.col(i);
  }
  return report;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template SurfaceReport<Dim> surface_report<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&,            \
                                                  const ContactState<Dim>&, const std::vector<Facet<Dim>>&,  \
                                                  const Eigen::VectorXd&, const Eigen::VectorXd&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
