// What a session checks before a step, and what it warns of.
#include "base/error.hpp"
#include "stepping/session.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

static const Eigen::IOFormat ROW(Eigen::StreamPrecision, Eigen::DontAlignCols); // places in messages

// Whether a closed tool lies between the nodes altogether, at the reference place of the workpiece.
template <int Dim> bool Session<Dim>::within_body(int tool) const {
  const ParamRange<Dim> range = m_model.tools[tool]->profile().range();
  const auto pose = m_model.tools[tool]->coordinates().pose(m_model.tool_q(m_accepted.q, tool));
  constexpr int POINTS = 32;
  for (int i = 0; i < POINTS; ++i) {
    const Param<Dim> s = range.begin + (range.end - range.begin) * i / POINTS;
    if (m_locator->find(m_model.tools[tool]->surface(pose, s).x, m_candidates[0], 0) < 0) return false;
  }
  return range.closed;
}

// Between steps a tool moves by its program only.
template <int Dim> void Session<Dim>::check_not_placed() const {
  for (std::size_t t = 0; t < m_tools.size(); ++t)
    for (Eigen::Index k = 0; k < m_tools[t]->q().size(); ++k) {
      const int at = m_model.first[t] + static_cast<int>(k);
      if (m_tools[t]->q()[k] == m_accepted.q[at]) continue;
      std::ostringstream text;
      text << m_model.coordinate(at) << " was placed at " << m_tools[t]->q()[k]
           << " during the run, where it is " << m_accepted.q[at] << "; only move and force change it now";
      fail("contact.begin", text.str());
    }
}

template <int Dim> void Session<Dim>::check_not_inside(const Eigen::VectorXd& u) const {
  for (std::size_t t = 0; t < m_tools.size(); ++t)
    if (within_body(static_cast<int>(t)))
      fail("contact.begin", "tool \"" + m_tools[t]->name() +
                                "\" lies within the workpiece, which has no node " +
                                "inside it; place the tool outside and call approach");
  const auto poses = m_model.poses(m_accepted.q);
  const auto& body = m_corrector->body();
  for (std::size_t i = 0; i < m_candidates.size(); ++i) {
    const auto nearest = nearest_tool(m_model, poses, body.position(u, m_candidates[i]), m_accepted.nodes[i],
                                      static_cast<int>(i));
    if (nearest.foot.gap >= -1e-3 * body.spacing) continue;
    std::ostringstream text;
    text << "tool \"" << m_tools[nearest.tool]->name() << "\" starts inside the workpiece: node "
         << m_candidates[i] << " at " << body.position(u, m_candidates[i]).transpose().format(ROW)
         << " penetrates by " << -nearest.foot.gap
         << "; place the tool outside and call approach, or, if its profile has the body on the wrong "
         << "side, turn it: inside=true, or the points in the other order";
    fail("contact.begin", text.str());
  }
}

// Mean normal out of the workpiece of the surface edges at a node; zero if there is none.
template <int Dim> Vector<Dim> Session<Dim>::outward(int node, const Eigen::VectorXd& u) const {
  Vector<Dim> sum = Vector<Dim>::Zero();
  for (const Facet<2>& edge : m_surface) {
    if (edge.vertex[0] != node && edge.vertex[1] != node && edge.middle[0] != node) continue;
    for (int e = 0; e < m_mesh->num_elements; ++e) {
      const int *vertex = m_mesh->element(e), *end = vertex + Dim + 1;
      if (std::find(vertex, end, edge.vertex[0]) == end || std::find(vertex, end, edge.vertex[1]) == end)
        continue;
      const auto& body = m_corrector->body();
      const int opposite =
          *std::find_if(vertex, end, [&](int v) { return v != edge.vertex[0] && v != edge.vertex[1]; });
      const Vector<Dim> a = body.position(u, edge.vertex[0]), away = a - body.position(u, opposite);
      const Vector<Dim> along = (body.position(u, edge.vertex[1]) - a).normalized();
      sum += (away - along.dot(away) * along).normalized();
    }
  }
  return sum.stableNormalized();
}

// A tool inside the workpiece has nodes at a positive gap, too, and reaches the surface from within.
template <int Dim>
void Session<Dim>::check_from_outside(int tool, const std::vector<std::size_t>& touching,
                                      const Eigen::VectorXd& u) const {
  const auto pose = m_model.tools[tool]->coordinates().pose(m_model.tool_q(m_accepted.q, tool));
  for (const std::size_t i : touching) {
    const int node = m_candidates[i];
    if (m_model.tools[tool]->surface(pose, m_accepted.nodes[i].s).n.dot(outward(node, u)) < 0.5) continue;
    std::ostringstream text;
    text << "tool \"" << m_tools[tool]->name()
         << "\" comes to the surface from inside the workpiece, at node " << node << " at "
         << m_corrector->body().position(u, node).transpose().format(ROW)
         << "; place it outside first, or, if its profile has the body on the wrong side, turn it: "
         << "inside=true, or the points in the other order";
    fail("contact.approach", text.str());
  }
}

// A coordinate under zero force that moves no contact point along the normal of a frictionless tool is held.
template <int Dim> void Session<Dim>::drop_unresisted(Program& program) {
  const auto poses = m_model.poses(m_accepted.q);
  for (std::size_t t = 0; t < m_tools.size(); ++t) {
    if (!m_model.friction[t]->frictionless()) continue;
    Eigen::VectorXd along, size;
    for (const auto& node : m_accepted.nodes) {
      if (node.tool != static_cast<int>(t) && node.tool >= 0) continue;
      const auto p = m_model.tools[t]->surface(poses[t], node.s);
      const Eigen::VectorXd a = (p.x_q.transpose() * p.n).cwiseAbs(), b = p.x_q.colwise().norm();
      along = along.size() ? Eigen::VectorXd(along.cwiseMax(a)) : a;
      size = size.size() ? Eigen::VectorXd(size.cwiseMax(b)) : b;
    }
    for (Eigen::Index k = 0; k < along.size(); ++k) {
      const int q = m_model.first[t] + static_cast<int>(k);
      if (program.is_motion[q] || along[k] > 1e-9 * size[k]) continue;
      const std::string what = "coordinate \"" + m_tools[t]->prescription().names()[k] + "\" of tool \"" +
                               m_tools[t]->name() + "\"";
      if (program.value[q] != 0)
        fail("contact.begin",
             what + " has a force but without friction nothing resists it; give it a motion or friction");
      program.is_motion[q] = 1;
      program.value[q] = m_accepted.q[q];
      if (std::find(m_left_out.begin(), m_left_out.end(), what) == m_left_out.end())
        m_left_out.push_back(what);
    }
  }
}

template <int Dim> void Session<Dim>::check_support(const Program& program) const {
  for (std::size_t t = 0; t < m_tools.size(); ++t) {
    bool touches = false;
    for (const auto& node : m_accepted.nodes)
      touches = touches || (in_contact(node.state) && node.tool == static_cast<int>(t));
    if (touches) continue;
    for (int k = 0; k < m_tools[t]->q().size(); ++k)
      if (!program.is_motion[m_model.first[t] + k])
        fail("contact.begin",
             "coordinate \"" + m_tools[t]->prescription().names()[k] + "\" of tool \"" + m_tools[t]->name() +
                 "\" is under force but the tool touches nothing, so it has no support; bring the tool "
                 "into contact by motion or with approach first, or give the coordinate a motion");
  }
}

// Coordinates under force that move their tool alike share a force in no certain way.
template <int Dim> void Session<Dim>::check_independent(const Program& program) const {
  const auto poses = m_model.poses(m_accepted.q);
  const double lever = m_corrector->body().spacing;
  for (std::size_t t = 0; t < m_tools.size(); ++t) {
    std::string names;
    std::vector<Eigen::VectorXd> motions;
    for (int k = 0; k < m_tools[t]->q().size(); ++k) {
      if (program.is_motion[m_model.first[t] + k]) continue;
      Eigen::VectorXd motion(Dim + Dim * Dim);
      motion << poses[t].origin_q[k],
          lever * Eigen::Map<const Eigen::VectorXd>(poses[t].R_q[k].data(), Dim * Dim);
      if (motion.norm() == 0) continue;
      motions.push_back(motion.normalized());
      names += (names.empty() ? "\"" : ", \"") + m_tools[t]->prescription().names()[k] + "\"";
    }
    Eigen::MatrixXd columns(Dim + Dim * Dim, motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = motions[i];
    if (motions.size() < 2 ||
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(columns).setThreshold(1e-9).rank() == columns.cols())
      continue;
    fail("contact.begin", "coordinates " + names + " of tool \"" + m_tools[t]->name() +
                              "\" are under force, but one of them moves the tool as the others do; give one "
                              "of them a motion");
  }
}

// Every node's share of the surface at the start of the step, for laws of pressure and traction.
template <int Dim> void Session<Dim>::share_surface() {
  const Eigen::VectorXd share = surface_shares(m_model, m_corrector->body(), m_surface, m_u);
  for (std::size_t i = 0; i < m_accepted.nodes.size(); ++i)
    m_accepted.nodes[i].area = share[static_cast<Eigen::Index>(i)];
}

template <int Dim> void Session<Dim>::warn(const std::string& subject, const std::string& text) {
  for (const auto& [known, before] : m_warnings)
    if (known == subject) return;
  m_warnings.emplace_back(subject, text);
}

template <int Dim> void Session<Dim>::warn_of_curvature() {
  const double h = m_corrector->body().spacing;
  for (const auto& tool : m_tools) {
    const double radius = tool->tool().profile().tightest_radius();
    if (!(radius < h)) continue;
    std::ostringstream text;
    text << "the tightest radius of tool \"" << tool->name() << "\", " << radius
         << ", is smaller than the distance of the contact nodes, " << h
         << ": the mesh cannot follow it there, refine the contact surface";
    warn("curvature " + tool->name(), text.str());
  }
}

// Nodes in contact with one tool that another tool reaches for too, and elements that touch two tools.
template <int Dim>
void Session<Dim>::note_conflicts(const ContactState<Dim>& state, const Eigen::VectorXd& u) {
  if (m_tools.size() < 2) return;
  const auto& body = m_corrector->body();
  const auto poses = m_model.poses(state.q);
  std::vector<int> touched(static_cast<std::size_t>(m_mesh->num_nodes), -1);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    touched[m_candidates[i]] = node.tool;
    const Vector<Dim> x = body.position(u, m_candidates[i]);
    for (int t = 0; t < static_cast<int>(m_tools.size()); ++t) {
      if (t == node.tool || !m_model.may_touch(static_cast<int>(i), t)) continue;
      const double gap = m_model.tools[t]->closest_point(poses[t], x, Param<Dim>::Zero()).gap;
      if (gap >= -m_corrector->options().offset_tolerance * body.spacing) continue;
      const std::string &a = m_tools[node.tool]->name(), &b = m_tools[t]->name();
      std::ostringstream text;
      text << "tools \"" << a << "\" and \"" << b << "\" reach for the same node " << m_candidates[i]
           << " at " << x.transpose().format(ROW) << ", t = " << m_t + m_dt << ": it stays with \"" << a
           << "\", and \"" << b << "\" overlaps it by " << -gap << "; a node touches at most one tool";
      warn("node " + a + " " + b, text.str());
    }
  }
  for (int e = 0; e < m_mesh->num_elements; ++e) {
    int first = -1;
    for (int a = 0; a < m_mesh->nodes_per_element; ++a) {
      const int node = m_mesh->element(e)[a], tool = touched[node];
      if (tool < 0) continue;
      if (first < 0) first = tool;
      if (tool == first) continue;
      std::ostringstream text;
      text << "an element lies between tools \"" << m_tools[first]->name() << "\" and \""
           << m_tools[tool]->name() << "\" (element " << e << " at "
           << body.position(u, node).transpose().format(ROW) << ", t = " << m_t + m_dt
           << "): refine the workpiece there";
      warn("element " + m_tools[first]->name() + " " + m_tools[tool]->name(), text.str());
    }
  }
}

// Contact at an end of an open profile, beyond which the surface of the body goes on: a sharp edge.
template <int Dim> void Session<Dim>::note_ends(const ContactState<Dim>& state, const Eigen::VectorXd& u) {
  const auto& body = m_corrector->body();
  const auto poses = m_model.poses(state.q);
  for (int t = 0; t < static_cast<int>(m_tools.size()); ++t) {
    const auto range = m_model.tools[t]->profile().range();
    if (range.closed) continue;
    for (const Param<Dim>& s : {range.begin, range.end}) {
      const Vector<Dim> end = m_model.tools[t]->surface(poses[t], s).x;
      bool touches = false, beyond = false;
      for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const auto& node = state.nodes[i];
        const Vector<Dim> x = body.position(u, m_candidates[i]);
        const double distance = (x - end).norm();
        if (distance > 2 * body.spacing || !m_model.may_touch(static_cast<int>(i), t)) continue;
        if (in_contact(node.state) && node.tool == t)
          touches = touches || distance <= body.spacing;
        else
          beyond = beyond || m_model.tools[t]->closest_point(poses[t], x, s).on_end;
      }
      if (!touches || !beyond) continue;
      std::ostringstream text;
      text << "the contact has reached the end of tool \"" << m_tools[t]->name() << "\" at "
           << end.transpose().format(ROW) << ", t = " << m_t + m_dt
           << ": the tool is sharp there; let its profile go on, with a fillet";
      warn("end " + m_tools[t]->name(), text.str());
    }
  }
}

// members of this file; session.cpp instantiates the others
template void Session<2>::check_not_placed() const;
template void Session<2>::check_not_inside(const Eigen::VectorXd&) const;
template Vector<2> Session<2>::outward(int, const Eigen::VectorXd&) const;
template void Session<2>::check_from_outside(int, const std::vector<std::size_t>&,
                                             const Eigen::VectorXd&) const;
template bool Session<2>::within_body(int) const;
template void Session<2>::drop_unresisted(Program&);
template void Session<2>::check_support(const Program&) const;
template void Session<2>::check_independent(const Program&) const;
template void Session<2>::share_surface();
template void Session<2>::warn(const std::string&, const std::string&);
template void Session<2>::warn_of_curvature();
template void Session<2>::note_conflicts(const ContactState<2>&, const Eigen::VectorXd&);
template void Session<2>::note_ends(const ContactState<2>&, const Eigen::VectorXd&);

} // namespace burnish
