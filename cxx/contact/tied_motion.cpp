#include "contact/tied_motion.hpp"

namespace burnish {
namespace {

template <int Dim> bool slides(const ContactNode<Dim>& node) { return node.state == NodeState::SLIDING; }

const Surface<3>& surface_of(const ContactModel<3>& model, const ContactNode<3>& node) {
  return model.tools[static_cast<std::size_t>(node.tool)]->surface();
}

// Its origin and half of the chords of the ends that slide, in the tool's frame.
Vector<3> half_way(const ContactModel<3>& model, const ContactState<3>& state, int middle) {
  Vector<3> y = state.nodes[middle].slip_origin.y;
  for (const int end : model.edge_ends[middle]) {
    const ContactNode<3>& node = state.nodes[end];
    if (slides(node)) y += 0.5 * (node.place.y - node.slip_origin.y);
  }
  return y;
}

} // namespace

template <> Curvature<2> foot_slope(const ContactModel<2>&, const ContactState<2>&, int) {
  return Curvature<2>::Identity();
}
template <> Curvature<3> foot_slope(const ContactModel<3>& model, const ContactState<3>& state, int middle) {
  const ContactNode<3>& node = state.nodes[middle];
  const SurfaceFrame<3> frame = surface_of(model, node).frame(node.place);
  const double height = frame.n.dot(half_way(model, state, middle) - node.place.y);
  return (Curvature<3>::Identity() + height * frame.B).inverse();
}

template <>
TiedEnd<2> tied_end(const ContactModel<2>&, const ContactState<2>&, const std::vector<Pose<2>>&, int, int) {
  return {};
}
template <>
TiedEnd<3> tied_end(const ContactModel<3>& model, const ContactState<3>& state,
                    const std::vector<Pose<3>>& poses, int middle, int end) {
  const ContactNode<3>&at = state.nodes[middle], &node = state.nodes[end];
  const SurfaceFrame<3> m = surface_of(model, at).frame(at.place),
                        e = surface_of(model, node).frame(node.place);
  TiedEnd<3> tied;
  tied.follows = foot_slope(model, state, middle) * (m.E.transpose() * e.E);
  tied.lift = e.E.transpose() * m.n;
  tied.normal = m.E.transpose() * e.n;
  tied.B = e.B / poses[node.tool].size;
  if (!model.is_constrained(end)) return tied;
  const Curvature<3> free = slip_space(
      model, end, model.tools[static_cast<std::size_t>(node.tool)]->point(poses[node.tool], node.place));
  tied.follows = (tied.follows * free).eval();
  tied.lift = (free * tied.lift).eval();
  tied.B = (free * tied.B * free).eval();
  return tied;
}

template <>
SurfacePlace<2> tied_place(const ContactModel<2>& model, const ContactState<2>& state, int middle) {
  const ContactNode<2>& node = state.nodes[middle];
  Param<2> slip = Param<2>::Zero();
  for (const int end : model.edge_ends[middle])
    if (slides(state.nodes[end])) slip += 0.5 * slip_of(model, state.nodes[end], 1); // in the tool's frame
  return model.tools[static_cast<std::size_t>(node.tool)]->surface().moved(node.slip_origin, slip);
}
template <>
SurfacePlace<3> tied_place(const ContactModel<3>& model, const ContactState<3>& state, int middle) {
  const ContactNode<3>& node = state.nodes[middle];
  return surface_of(model, node).foot(half_way(model, state, middle), node.slip_origin.hint).place;
}

} // namespace burnish
