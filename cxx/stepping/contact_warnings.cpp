#include "stepping/contact_warnings.hpp"
#include "stepping/program_checks.hpp"
#include <algorithm>
#include <sstream>

namespace burnish {

template <int Dim>
void ContactWarnings<Dim>::add(const std::string& subject, const std::string& text, double t,
                               const std::vector<double>& place, double excess) {
  Finding* finding = m_findings.report("contact", subject, Severity::WARNING, excess, t);
  if (!finding) return;
  finding->text = text;
  finding->place = place;
}

template <int Dim> void ContactWarnings<Dim>::check_curvature(const ContactSetup<Dim>& setup) {
  const double h = setup.body().spacing;
  for (const auto& tool : setup.tools()) {
    const double radius = tool->tool().surface().tightest_radius();
    if (!(radius < h)) continue;
    std::ostringstream text;
    text << "the tightest radius of tool \"" << tool->name() << "\", " << radius
         << ", is smaller than the distance of the contact nodes, " << h
         << ": the mesh cannot follow it there, refine the contact surface";
    add("curvature " + tool->name(), text.str());
  }
}

template <int Dim>
void ContactWarnings<Dim>::check_conflicts(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                                           const Eigen::VectorXd& u, double t) {
  const auto& tools = setup.tools();
  if (tools.size() < 2) return;
  const auto poses = setup.model().poses(state.q);
  std::vector<int> touched(static_cast<std::size_t>(setup.mesh().num_nodes), -1);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const int mesh_node = setup.candidates()[i];
    touched[mesh_node] = node.tool;
    const Vector<Dim> x = setup.body().position(u, mesh_node);
    for (int other = 0; other < static_cast<int>(tools.size()); ++other) {
      if (other == node.tool || !setup.model().may_touch(static_cast<int>(i), other)) continue;
      const double gap = setup.model().tools[other]->foot(poses[other], x, Param<Dim>::Zero()).gap;
      if (gap >= -setup.options().offset_tolerance * setup.body().spacing) continue;
      const std::string &a = tools[node.tool]->name(), &b = tools[other]->name();
      std::ostringstream text;
      text << "tools \"" << a << "\" and \"" << b << "\" reach for the same node " << mesh_node << " at "
           << x.transpose().format(PLACE_FORMAT) << ", t = " << t << ": it stays with \"" << a << "\", and \""
           << b << "\" overlaps it by " << -gap << "; a node touches at most one tool";
      add("node " + a + " " + b, text.str(), t, {x.data(), x.data() + Dim});
    }
  }
  check_elements(setup, touched, u, t);
}

template <int Dim>
void ContactWarnings<Dim>::check_elements(const ContactSetup<Dim>& setup,
                                          const std::vector<int>& tool_of_node, const Eigen::VectorXd& u,
                                          double t) {
  const auto& mesh = setup.mesh();
  for (int e = 0; e < mesh.num_elements; ++e) {
    int first = -1;
    for (int a = 0; a < mesh.nodes_per_element; ++a) {
      const int node = mesh.element(e)[a], tool = tool_of_node[node];
      if (tool < 0) continue;
      if (first < 0) first = tool;
      if (tool == first) continue;
      // in the order of the tools, whichever the element names first
      const std::string &low = setup.tools()[std::min(first, tool)]->name(),
                        &high = setup.tools()[std::max(first, tool)]->name();
      std::ostringstream text;
      text << "an element lies between tools \"" << low << "\" and \"" << high << "\" (element " << e
           << " at " << setup.body().position(u, node).transpose().format(PLACE_FORMAT) << ", t = " << t
           << "): refine the workpiece there";
      add("element " + low + " " + high, text.str(), t);
    }
  }
}

template <int Dim>
void ContactWarnings<Dim>::check_ends(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                                      const Eigen::VectorXd& u, double t) {
  constexpr double near = 2, at = 1; // of the spacing: nodes looked at, and contact nodes at the end
  const auto& body = setup.body();
  const auto poses = setup.model().poses(state.q);
  for (int tool = 0; tool < static_cast<int>(setup.tools().size()); ++tool) {
    const auto& placed = *setup.model().tools[tool];
    for (const SurfacePlace<Dim>& place : placed.surface().ends()) {
      const Vector<Dim> end = placed.position(poses[tool], place);
      bool touches = false, beyond = false;
      for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const auto& node = state.nodes[i];
        const Vector<Dim> x = body.position(u, setup.candidates()[i]);
        const double distance = (x - end).norm();
        if (distance > near * body.spacing || !setup.model().may_touch(static_cast<int>(i), tool)) continue;
        if (in_contact(node.state) && node.tool == tool)
          touches = touches || distance <= at * body.spacing;
        else
          beyond = beyond || placed.foot(poses[tool], x, place.hint).on_end;
      }
      if (!touches || !beyond) continue;
      std::ostringstream text;
      text << "the contact has reached the end of tool \"" << setup.tools()[tool]->name() << "\" at "
           << end.transpose().format(PLACE_FORMAT) << ", t = " << t
           << ": the tool is sharp there; let its profile go on, with a fillet";
      add("end " + setup.tools()[tool]->name(), text.str(), t, {end.data(), end.data() + Dim});
    }
  }
}

template class ContactWarnings<2>;
template class ContactWarnings<3>;

} // namespace burnish
