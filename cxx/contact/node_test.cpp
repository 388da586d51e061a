#include "contact/node_test.hpp"

namespace burnish {
namespace {

constexpr double ENTRY_SLIP =
    10; // of the tolerance of gaps: a node that enters with more has moved along the tool

} // namespace

template <int Dim>
bool NodeTest<Dim>::test_contact(int candidate, const ContactNode<Dim>& solved, const Vector<Dim>& F,
                                 const DecidingForce<Dim>& deciding, ContactNode<Dim>& node) const {
  const TangentialLaw<Dim>& law = m_model.law(candidate, node);
  const ContactPoint<Dim> at = contact_point(m_model, m_poses, solved);
  const double N = m_model.is_weightless(candidate) ? deciding.normal
                                                    : nodal_force(m_model, candidate, at.surface, F).part.N;
  const ContactTolerance tolerance = m_tolerances.of(node.tool);
  if (node.tied) {
    if (N < -tolerance.force) make_free(node);
    return !in_contact(node.state);
  }
  switch (law.test(node.state, N, deciding, slip_of(m_model, solved, at.surface.size), at.m, tolerance)) {
  case Change::NONE:
    return false;
  case Change::RELEASE:
    make_free(node);
    return true;
  case Change::STICK:
    make_stick(node);
    return true;
  case Change::SLIDE: // friction opposes slip: the tangential force tells its direction
    make_slide(node, in_tool_frame(m_poses[node.tool], at.surface, law.slip_against(deciding.force.T)));
    return true;
  }
  return false;
}

// A free node that would penetrate comes into contact.
template <int Dim>
bool NodeTest<Dim>::test_free(int candidate, const Vector<Dim>& x, ContactNode<Dim>& node) const {
  const ContactNode<Dim>& entry = m_entry.nodes[candidate];
  const auto nearest = nearest_tool(m_model, m_poses, x, entry, candidate);
  if (!(nearest.foot.gap < -m_tolerances.gap)) return false;
  const auto foot = m_model.tools[nearest.tool]->point(m_poses[nearest.tool], nearest.foot.place);
  if (admissible_normal(m_model, candidate, foot.n).isZero()) return false; // the supports block it
  node.tool = nearest.tool;
  enter(candidate, nearest.foot, node);
  return true;
}

// In space with ties that of touching, a free node's gap closes linearly; else that at the start of the step, ALGORITHMS.md 4.
template <int Dim>
SurfacePlace<Dim> NodeTest<Dim>::touching_place(int candidate, const SurfaceFoot<Dim>& foot) const {
  const ContactNode<Dim>& entry = m_entry.nodes[candidate];
  const double gap = m_entry.records[candidate].gap;
  if (Dim == 2 || in_contact(entry.state) || !(gap > 0)) return entry.slip_origin;
  return m_model.tools[entry.tool]->surface().between(entry.slip_origin, foot.place, gap / (gap - foot.gap));
}

// Where it would have touched, sticking; or, if it has moved along the tool since then, at its foot, sliding on (METHOD.md 5.4).
// One that always sticks and could not stay there (released twice in this step) sticks where it is now.
template <int Dim>
void NodeTest<Dim>::enter(int candidate, const SurfaceFoot<Dim>& foot, ContactNode<Dim>& node) const {
  const ContactNode<Dim>& entry = m_entry.nodes[candidate];
  const int releases = m_entry.records[candidate].releases;
  const TangentialLaw<Dim>& law = m_model.law(candidate, node);
  const bool sticks_always = law.friction().sticks_always(), known = entry.tool == node.tool;
  node.slip_origin = known && !(releases > 1 && sticks_always) ? touching_place(candidate, foot) : foot.place;
  node.place = foot.place;
  if (law.frictionless()) return make_slide<Dim>(node, Vector<Dim>::Zero());
  if (!sticks_always && releases > 0 && !entry.slip_direction.isZero())
    return make_slide(node, entry.slip_direction);
  const auto point = m_model.tools[node.tool]->point(m_poses[node.tool], foot.place);
  const Param<Dim> slip = slip_space(m_model, candidate, point) * slip_of(m_model, node, point.size);
  if (!sticks_always && known && slip.norm() > ENTRY_SLIP * m_tolerances.gap) {
    return make_slide(node, in_tool_frame(m_poses[node.tool], point, Param<Dim>(slip.normalized())));
  }
  make_stick(node);
}

template <int Dim>
bool NodeTest<Dim>::operator()(int candidate, const ContactNode<Dim>& solved, const Vector<Dim>& F,
                               const DecidingForce<Dim>& deciding, const Vector<Dim>& x,
                               ContactNode<Dim>& node) const {
  if (!in_contact(node.state)) return test_free(candidate, x, node);
  const Vector<Dim> direction = node.slip_direction;
  const bool changed = test_contact(candidate, solved, F, deciding, node);
  if (in_contact(node.state)) return changed;
  ++m_entry.records[candidate].releases;
  if (!direction.isZero()) m_entry.nodes[candidate].slip_direction = direction;
  return changed;
}

template class NodeTest<2>;
template class NodeTest<3>;

} // namespace burnish
