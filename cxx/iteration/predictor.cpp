#include "iteration/predictor.hpp"
#include "contact/coupling.hpp"
#include "contact/tied_edges.hpp"
#include "contact/tool_support.hpp"
#include "iteration/nodal_gradients.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double CARRY =
    1.5; // a state is carried from a candidate that stood this many spacings away at most

// Coordinates under motion go to their target, those under force continue at their last rate.
template <int Dim>
Eigen::VectorXd predict_coordinates(const PrescribedValues& prescribed, const Eigen::VectorXd& q,
                                    const StepHistory<Dim>& history, double ratio) {
  Eigen::VectorXd result = q;
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    if (prescribed.is_motion[k])
      result[k] = prescribed.value[k];
    else if (history.dq.size() == q.size())
      result[k] += ratio * history.dq[k];
  }
  return result;
}

template <int Dim>
std::vector<Vector<Dim>> reference_places(const ContactModel<Dim>& model, const BodyView<Dim>& body) {
  std::vector<Vector<Dim>> places;
  for (const int node : model.candidates) places.push_back(body.X.template segment<Dim>(Dim * node));
  return places;
}

// Per tool whether motions lead it along the surface that it is on: nodes that enter do so where they touch.
template <int Dim>
std::vector<char> led_by_motions(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                 const ContactState<Dim>& state) {
  std::vector<char> led(model.tools.size(), 0);
  for (const auto& node : state.nodes)
    if (in_contact(node.state)) led[node.tool] = 1;
  const std::vector<char> held = held_by_friction(model, prescribed, state);
  for (std::size_t t = 0; t < led.size(); ++t) led[t] = led[t] && !held[t];
  return led;
}

} // namespace

// The carrier's motion in the present step, and its turn in the mean with the last one's, for each tool.
template <int Dim> struct Predictor<Dim>::CarrierMotion {
  RigidMotion<Dim> now;
  Tensor<Dim> turn;
  bool turns;
};

template <int Dim>
Predictor<Dim>::Predictor(const Mesh<Dim>& mesh, const ContactModel<Dim>& model, const BodyView<Dim>& body)
    : m_mesh(mesh), m_model(model), m_body(body), m_locator(mesh),
      m_candidates(reference_places(model, body)) {}

template <int Dim>
typename Predictor<Dim>::CarrierMotion
Predictor<Dim>::carrier_motion(int tool, const Eigen::VectorXd& q_older, const Eigen::VectorXd& q_old,
                               const Eigen::VectorXd& q_new) const {
  const auto& coordinates = m_model.tools[tool]->coordinates();
  const auto last = coordinates.carrier(m_model.tool_q(q_older, tool), m_model.tool_q(q_old, tool));
  CarrierMotion motion;
  motion.now = coordinates.carrier(m_model.tool_q(q_old, tool), m_model.tool_q(q_new, tool));
  motion.turn = mean_rotation(motion.now.R, last.R);
  motion.turns = !motion.turn.isIdentity(1e-14);
  return motion;
}

// u + ratio * turned last increment, taken from where the material stood, seen from the tool, one step ago: what the carrier does
// against the material is pulled back into the reference configuration.
template <int Dim>
PredictedWays Predictor<Dim>::carry_increment(const ContactState<Dim>& state, const Eigen::VectorXd& u,
                                              const StepHistory<Dim>& history,
                                              const std::vector<CarrierMotion>& motions, double ratio) const {
  PredictedWays result{u, u};
  const auto poses = m_model.poses(state.q);
  const NodalGradients<Dim> gradients = nodal_gradients(m_mesh, m_body, u, history.du);
  std::vector<double> N(static_cast<std::size_t>(m_mesh.nodes_per_element));
  for (int a = 0; a < m_mesh.num_nodes; ++a) {
    const Vector<Dim> x = m_body.position(u, a), own = history.du.template segment<Dim>(Dim * a);
    int tool = 0;
    if (motions.size() > 1) tool = nearest_tool(m_model, poses, x, ContactNode<Dim>{}, -1).tool;
    const CarrierMotion& motion = motions[tool];
    const Vector<Dim> relative = x - motion.now.inverse()(x + ratio * own);
    const Vector<Dim> P = m_mesh.node(a) - gradients.F[a].inverse() * relative;
    const int element = m_locator.find(P, a);
    // from the middle of the last step to the middle of this one
    const Tensor<Dim> turn = part_of_rotation(gradients.step[a], 0.5 * (1 + ratio));
    Vector<Dim> increment = turn * own;
    if (element >= 0) {
      increment.setZero();
      m_locator.shape(element, P, N.data());
      for (int b = 0; b < m_mesh.nodes_per_element; ++b)
        increment += N[b] * history.du.template segment<Dim>(Dim * m_mesh.element(element)[b]);
      increment = (motion.turns ? motion.turn : turn) * increment;
    }
    for (int c = 0; c < Dim; ++c) {
      if (m_body.fixed[Dim * a + c]) continue;
      result.carried[Dim * a + c] += ratio * increment[c];
      result.own[Dim * a + c] += ratio * turn.row(c).dot(own);
    }
  }
  return result;
}

// Place of a node in contact; of one that its supports hold along the way of its tool the place moves on along the tool by that way,
// and where it sticks across the way is kept (METHOD.md 3.7).
template <int Dim>
SurfacePlace<Dim> Predictor<Dim>::followed_across(const std::vector<Pose<Dim>>& poses, int candidate,
                                                  const ContactNode<Dim>& node, const Vector<Dim>& x) const {
  constexpr double moves = 1e-6; // of a spacing
  if (Dim == 2 || !sticks(node.state) || !m_model.is_constrained(candidate)) return node.place;
  const auto& tool = *m_model.tools[node.tool];
  const SurfacePoint<Dim> p = tool.point(poses[node.tool], node.place);
  const Curvature<Dim> held = Curvature<Dim>::Identity() - slip_space(m_model, candidate, p);
  const Vector<Dim> way = p.E * (held * (p.E.transpose() * (x - p.x)));
  if (!(way.norm() > moves * m_body.spacing)) return node.place;
  return tool.foot(poses[node.tool], p.x + way, node.place.hint).place;
}

// Where each candidate is when the step begins: contact nodes at their place, free ones at their projection.
template <int Dim>
EntryPlaces<Dim> Predictor<Dim>::entry_places(const ContactState<Dim>& state,
                                              const Eigen::VectorXd& u) const {
  EntryPlaces<Dim> result{state.nodes, std::vector<EntryRecord>(state.nodes.size())};
  std::vector<ContactNode<Dim>>& entry = result.nodes;
  const auto poses = m_model.poses(state.q);
  for (std::size_t i = 0; i < entry.size(); ++i) {
    const Vector<Dim> x = m_body.position(u, m_model.candidates[i]);
    if (in_contact(entry[i].state))
      entry[i].place = followed_across(poses, static_cast<int>(i), entry[i], x);
    else {
      const auto nearest = nearest_tool(m_model, poses, x, entry[i], static_cast<int>(i));
      entry[i].tool = nearest.tool;
      entry[i].place = nearest.foot.place;
      result.records[i].gap = nearest.foot.gap;
    }
    place_at(entry[i], entry[i].place);
  }
  return result;
}

// State of the candidate that stood where this one stands now, seen from the tool.
template <int Dim>
void Predictor<Dim>::carry_states(const ContactState<Dim>& old, const std::vector<CarrierMotion>& motions,
                                  bool tied, ContactState<Dim>& state) const {
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    make_free(node);
    const Vector<Dim> X = m_body.X.template segment<Dim>(Dim * m_model.candidates[i]);
    for (int t = 0; t < static_cast<int>(motions.size()); ++t) {
      const auto stood = m_candidates.nearest(motions[t].now.inverse()(X));
      if (stood.index < 0 || !(stood.squared_distance < std::pow(CARRY * m_body.spacing, 2))) continue;
      const ContactNode<Dim>& from = old.nodes[stood.index];
      if (!in_contact(from.state) || from.tool != t) continue;
      node.has_ties = tied && m_model.is_weightless(static_cast<int>(i)) &&
                      !m_model.law(stood.index, from).frictionless(); // until tie_edges knows
      if (node.tool != t) place_at(node, from.place);
      node.tool = t;
      const bool slides = m_model.law(static_cast<int>(i), node).frictionless();
      node.state = slides ? NodeState::SLIDING : from.state;
      node.tied = from.tied;
      if (!slides) node.slip_direction = from.slip_direction;
      break;
    }
  }
}

// Place of a contact node that is not tied: foot of its predicted place, or where it sticks.
template <int Dim>
void Predictor<Dim>::place_contact_node(const std::vector<Pose<Dim>>& poses, int candidate, bool may_stick,
                                        ContactState<Dim>& state, const Eigen::VectorXd& u) const {
  ContactNode<Dim>& node = state.nodes[candidate];
  if (node.state == NodeState::SLIDING) {
    const Vector<Dim> x = m_body.position(u, m_model.candidates[candidate]);
    node.place = m_model.tools[node.tool]->foot(poses[node.tool], x, node.slip_origin.hint).place;
    const Param<Dim> m = contact_point(m_model, poses, node).m;
    if (may_stick && !m_model.law(candidate, node).frictionless() &&
        TangentialLaw<Dim>::slips_back(slip_of(m_model, node, poses[node.tool].size), m, 0))
      node.state = NodeState::STICKING;
  }
  if (!sticks(node.state)) return;
  const NodeState kept = node.state;
  make_stick(node);
  node.state = kept;
}

// Places of the contact nodes at the predicted coordinates: first of the corners, which decide over the ties. The nodes stay where
// they are predicted: the first iteration brings them to their tools by the whole body.
template <int Dim>
void Predictor<Dim>::place_contact_nodes(const CarriedStates& states,
                                         const std::vector<ContactNode<Dim>>& before,
                                         ContactState<Dim>& state, const Eigen::VectorXd& u) const {
  const auto poses = m_model.poses(state.q);
  const int n = static_cast<int>(state.nodes.size());
  const auto place = [&](bool middles) {
    for (int i = 0; i < n; ++i)
      if (in_contact(state.nodes[i].state) && !state.nodes[i].tied && m_model.is_middle(i) == middles)
        place_contact_node(poses, i, states.carry, state, u);
  };
  for (auto& node : state.nodes) node.tied = node.tied && states.tied;
  place(false);
  if (states.tied) states.carry ? tie_edges(m_model, before, state) : keep_ties(m_model, state);
  place(true);
  follow_ends(m_model, state);
}

template <int Dim>
Prediction<Dim> Predictor<Dim>::predict(const PrescribedValues& prescribed, const ContactState<Dim>& state,
                                        const Eigen::VectorXd& u, const StepHistory<Dim>& history, double dt,
                                        const CarriedStates& states) const {
  Prediction<Dim> result;
  const bool known = history.dt > 0 && history.du.size() == u.size();
  const double ratio = known ? dt / history.dt : 0;
  result.u = u;
  result.entry = entry_places(state, u);
  result.state.nodes = result.entry.nodes;
  const std::vector<char> led =
      states.tied ? led_by_motions(m_model, prescribed, state) : std::vector<char>(m_model.tools.size(), 0);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) // others enter at their projection
    if (const int tool = result.entry.nodes[i].tool; tool < 0 || !led[tool]) result.entry.records[i] = {};
  result.state.q = predict_coordinates(prescribed, state.q, history, ratio);
  follow(m_model, result.state.q);
  if (known && states.carry) {
    std::vector<CarrierMotion> motions;
    for (std::size_t t = 0; t < m_model.tools.size(); ++t)
      motions.push_back(carrier_motion(static_cast<int>(t), history.q_old, state.q, result.state.q));
    result.ways = carry_increment(state, u, history, motions, ratio);
    result.u = history.own ? result.ways.own : result.ways.carried;
    carry_states(state, motions, states.tied, result.state);
  } else if (known) {
    for (Eigen::Index d = 0; d < u.size(); ++d)
      if (!m_body.fixed[d]) result.u[d] += ratio * history.du[d];
  }
  for (auto& node : result.state.nodes)
    if (node.state == NodeState::TOUCHED) node.state = NodeState::STICKING;
  // Without a step before, the nodes stay where they are: the first iteration brings them to the tool by an
  // offset.
  if (known)
    place_contact_nodes(states, result.entry.nodes, result.state, result.u);
  else if (states.tied)
    tie_edges(m_model, result.entry.nodes, result.state);
  return result;
}

bool PredictedWays::own_nearer(const Eigen::VectorXd& u, bool before) const {
  constexpr double better = 0.5;
  if (own.size() != u.size()) return before;
  const double a = (u - own).norm(), b = (u - carried).norm();
  return before ? !(b < better * a) : a < better * b;
}

template <int Dim>
Prediction<Dim> Predictor<Dim>::rest(const ContactState<Dim>& state, const Eigen::VectorXd& u) const {
  Prediction<Dim> start{u, state, {}, {}};
  for (auto& node : start.state.nodes) {
    if (node.state == NodeState::TOUCHED) node.state = NodeState::STICKING;
    node.tied = node.has_ties = false;
    node.slip_origin = node.place;
  }
  start.entry = {start.state.nodes, std::vector<EntryRecord>(start.state.nodes.size())};
  return start;
}

template class Predictor<2>;
template class Predictor<3>;

} // namespace burnish
