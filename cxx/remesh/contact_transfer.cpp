#include "remesh/contact_transfer.hpp"
#include "base/error.hpp"
#include "contact/tributary_area.hpp"
#include "mesh/point_tree.hpp"
#include "remesh/field_transfer.hpp"
#include "remesh/support_transfer.hpp"
#include <cmath>
#include <set>

namespace burnish {
namespace {

constexpr double TOUCHES = 0.02; // gap over the spacing up to which a new candidate takes over a contact

template <int Dim>
std::vector<Vector<Dim>> candidate_places(const ContactSetup<Dim>& setup, const Eigen::VectorXd& u) {
  std::vector<Vector<Dim>> places;
  for (const int node : setup.candidates()) places.push_back(setup.body().position(u, node));
  return places;
}

// Takes over the contact of the nearest old candidate.
template <int Dim>
void take_over(const ContactSetup<Dim>& setup, const std::vector<Pose<Dim>>& poses, const Vector<Dim>& x,
               const ContactNode<Dim>& old, int candidate, ContactNode<Dim>& node) {
  const auto& model = setup.model();
  if (!in_contact(old.state) || !model.may_touch(candidate, old.tool)) return;
  const auto foot = model.tools[old.tool]->foot(poses[old.tool], x, old.place.hint);
  if (std::abs(foot.gap) > TOUCHES * setup.body().spacing) return;
  node.tool = old.tool;
  place_at(node, foot.place);
  node.slip_rate = old.slip_rate;
  const auto point = model.tools[old.tool]->point(poses[old.tool], foot.place);
  if (model.law(candidate, old.tool).frictionless()) return make_slide<Dim>(node, Vector<Dim>::Zero());
  const Param<Dim> m = point.E.transpose() * (poses[old.tool].R * old.slip_direction);
  if (old.state == NodeState::SLIDING && m.norm() > 0)
    make_slide(node, in_tool_frame(poses[old.tool], point, Param<Dim>(m.normalized())));
  else
    node.state = NodeState::STICKING;
}

// Springs on the new mesh that pull with the force of the old ones at every place.
template <int Dim>
HoldState hold_on(const ContactRun<Dim>& old, const ContactSetup<Dim>& setup, const Eigen::VectorXd& start) {
  HoldState hold = old.loads().hold.state();
  if (hold.origin.size() == 0) return hold; // none, or one that begins with the next step
  const Eigen::VectorXd& u = old.accepted().u;
  Mesh<Dim> there = old.setup().mesh();
  for (Eigen::Index d = 0; d < u.size(); ++d) there.X[static_cast<std::size_t>(d)] += u[d];
  std::vector<Vector<Dim>> nodes;
  for (int a = 0; a < setup.mesh().num_nodes; ++a) nodes.push_back(setup.body().position(start, a));
  hold.origin = start - nodal_transfer<Dim>(there, u - hold.origin, nodes);
  return hold;
}

} // namespace

template <int Dim>
std::shared_ptr<ContactSetup<Dim>> setup_on(const ContactSetup<Dim>& old, Mesh<Dim> mesh,
                                            std::vector<char> fixed) {
  std::set<long> labels;
  for (const Facet<Dim>& facet : old.surface()) labels.insert(facet.label);
  for (const long label : labels) facets_with(mesh, {label}, "remesh"); // each must be there
  auto surface = facets_with(mesh, std::vector<long>(labels.begin(), labels.end()), "remesh");
  const Eigen::VectorXd straight =
      Eigen::Map<const Eigen::VectorXd>(mesh.X.data(), static_cast<Eigen::Index>(mesh.X.size()));
  auto setup = std::make_shared<ContactSetup<Dim>>(std::move(mesh), std::move(surface), std::move(fixed),
                                                   old.body().measure);
  setup->place_surface(straight);
  setup->take_tools(old);
  return setup;
}

template <int Dim>
ContactRunState<Dim> contact_state_on(const ContactRun<Dim>& old, const ContactRun<Dim>& fresh,
                                      const Eigen::VectorXd& start, const Eigen::VectorXd& du) {
  const ContactSetup<Dim>& setup = fresh.setup();
  ContactRunState<Dim> state = old.state(), clean = fresh.state();
  const std::vector<ContactNode<Dim>> before = state.contact.nodes;
  const PointTree<Dim> tree(candidate_places(old.setup(), state.u));
  state.contact.nodes = clean.contact.nodes;
  const auto poses = setup.model().poses(state.contact.q);
  const auto places = candidate_places(setup, start);
  for (std::size_t i = 0; i < places.size(); ++i)
    take_over(setup, poses, places[i], before[static_cast<std::size_t>(tree.nearest(places[i]).index)],
              static_cast<int>(i), state.contact.nodes[i]);
  const Eigen::VectorXd area = tributary_areas(setup.model(), setup.body(), setup.surface(), start);
  for (std::size_t i = 0; i < places.size(); ++i)
    state.contact.nodes[i].tributary_area = area[static_cast<Eigen::Index>(i)];
  state.u = start;
  state.R = clean.R;
  state.history.du = du;
  state.support_displacement = state.support_origin = supports_on(old, setup);
  state.external = Eigen::VectorXd();
  state.external_lost = old.loads().external.act() || old.loads().external.lost();
  state.hold = hold_on(old, setup, start);
  state.factor = clean.factor;
  return state;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template std::shared_ptr<ContactSetup<Dim>> setup_on<Dim>(const ContactSetup<Dim>&, Mesh<Dim>,             \
                                                            std::vector<char>);                              \
  template ContactRunState<Dim> contact_state_on<Dim>(const ContactRun<Dim>&, const ContactRun<Dim>&,        \
                                                      const Eigen::VectorXd&, const Eigen::VectorXd&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
