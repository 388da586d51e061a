#include "contact/surface_report.hpp"
#include "contact/corner_shares.hpp"

namespace burnish {
namespace {

// See SHEAR_COMPONENTS.
template <int Dim>
Eigen::Matrix<double, SHEAR_COMPONENTS<Dim>, 1> shear_of(const Tangents<Dim>& E, const Param<Dim>& T) {
  if constexpr (Dim == 2)
    return T;
  else
    return E * T;
}

template <int Dim>
void read_forces(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& state,
                 const Eigen::VectorXd& u, const Eigen::VectorXd& R, SurfaceReport<Dim>& report) {
  const auto n = static_cast<Eigen::Index>(model.candidates.size());
  report.gap = report.normal_force = Eigen::VectorXd::Zero(n);
  report.tangential_force = Eigen::MatrixXd::Zero(SHEAR_COMPONENTS<Dim>, n);
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
    report.tangential_force.col(i) = shear_of<Dim>(p.E, force.part.T);
  }
}

// A vertex on a plane of symmetry has in its shares what one side pulls across the plane; the other side, which is not there, takes
// it off again.
void leave_given_components(const ContactModel<3>& model, SurfaceReport<3>& report) {
  for (Eigen::Index i = 0; i < report.traction_tangential.cols(); ++i)
    for (int c = 0; c < 3; ++c)
      if (model.is_constrained(static_cast<int>(i)) && model.constrained[static_cast<std::size_t>(i)][c])
        report.traction_tangential(c, i) = 0;
}

// See SurfaceReport::stick_share.
template <int Dim>
double share_that_sticks(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                         const CornerShares<Dim>& shares, const SurfaceReport<Dim>& report) {
  double sticking = 0, all = 0;
  const auto add = [&](double area, bool sticks) {
    all += area;
    sticking += sticks ? area : 0;
  };
  for (std::size_t i = 0; shares.empty() && i < state.nodes.size(); ++i)
    if (in_contact(state.nodes[i].state))
      add(report.area[static_cast<Eigen::Index>(i)], sticks(state.nodes[i].state));
  if (!shares.empty()) {
    const Eigen::VectorXd N = shares.shared(report.normal_force);
    Eigen::MatrixXd T(SHEAR_COMPONENTS<Dim>, N.size());
    for (int a = 0; a < SHEAR_COMPONENTS<Dim>; ++a)
      T.row(a) = shares.shared(report.tangential_force.row(a).transpose()).transpose();
    for (Eigen::Index c = 0; c < N.size(); ++c) {
      const int corner = shares.corners()[static_cast<std::size_t>(c)];
      const int tool = state.nodes[corner].tool;
      if (tool < 0) continue; // a vertex on the axis has touched nothing
      const double area = shares.areas()[c];
      const double limit = model.can_slip(corner) ? model.laws[tool].capacity(N[c], area) : 0;
      add(area, T.col(c).norm() < NEAR_LIMIT * limit);
    }
  }
  return all > 0 ? sticking / all : 0;
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
  report.pressure = report.nodal_pressure = report.normal_force.cwiseQuotient(area);
  report.traction_tangential = report.nodal_traction =
      report.tangential_force * area.cwiseInverse().asDiagonal();
  const CornerShares<Dim> shares(model, body, state, facets, u, report.area);
  report.stick_share = share_that_sticks(model, state, shares, report);
  if (shares.empty()) return report;
  report.pressure = shares.traction(report.normal_force, report.nodal_pressure);
  for (int a = 0; a < SHEAR_COMPONENTS<Dim>; ++a)
    report.traction_tangential.row(a) =
        shares.traction(report.tangential_force.row(a), report.nodal_traction.row(a)).transpose();
  if constexpr (Dim == 3) leave_given_components(model, report);
  return report;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template SurfaceReport<Dim> surface_report<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&,            \
                                                  const ContactState<Dim>&, const std::vector<Facet<Dim>>&,  \
                                                  const Eigen::VectorXd&, const Eigen::VectorXd&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
