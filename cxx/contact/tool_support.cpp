#include "contact/tool_support.hpp"
#include "contact/driving_force.hpp"
#include <algorithm>
#include <tuple>

namespace burnish {
namespace {

constexpr double ALONG =
    1e-9; // motion along the normal over the motion itself: below, a coordinate moves along the surface

// Slips of a tool's nodes, and what its coordinates do to them.
struct ToolContact {
  bool any = false, sticks = false;
  int least_slip = -1;          // candidate
  Eigen::VectorXd normal, size; // per coordinate: largest |n.X_k|, |X_k|
};

template <int Dim>
ToolContact contact_of(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                       const ContactState<Dim>& state, int tool, const std::vector<char>& refused) {
  ToolContact result;
  std::tuple<bool, bool, double> smallest;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state) || node.tool != tool || !model.can_slip(static_cast<int>(i))) continue;
    result.sticks = result.sticks || sticks(node.state);
    const auto p = model.tools[tool]->point(poses[tool], node.place);
    const Eigen::VectorXd normal = (p.x_q.transpose() * p.n).cwiseAbs(), size = p.x_q.colwise().norm();
    result.normal = result.any ? Eigen::VectorXd(result.normal.cwiseMax(normal)) : normal;
    result.size = result.any ? Eigen::VectorXd(result.size.cwiseMax(size)) : size;
    result.any = true;
    if (node.tied) continue; // its ends decide
    // weightless vertices come last, then refused nodes
    const bool weightless = model.law(static_cast<int>(i), node).frictionless();
    const std::tuple<bool, bool, double> slip(weightless, !refused.empty() && refused[i],
                                              slip_of(model, node, p.size).norm());
    if (result.least_slip >= 0 && slip >= smallest) continue;
    result.least_slip = static_cast<int>(i);
    smallest = slip;
  }
  return result;
}

// Whether the contact of another tool, with a coordinate that follows k, resists k.
template <int Dim>
bool resisted_through_followers(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses,
                                const ContactState<Dim>& state, int k) {
  for (const int follower : model.followers(k)) {
    const int tool = model.tool_of(follower);
    const ToolContact contact = contact_of(model, poses, state, tool, {});
    const Eigen::Index own = follower - model.first[tool];
    if (contact.any && (contact.sticks || contact.normal[own] > ALONG * contact.size[own])) return true;
  }
  return false;
}

// Whether a force decides where k goes: on itself, or on one that it follows.
template <int Dim>
bool under_force(const ContactModel<Dim>& model, const PrescribedValues& prescribed, int k) {
  const auto free = [&](int i) { return !prescribed.is_motion[i] && !prescribed.is_held(i); };
  const Coupling* coupling = model.coupling_of(k);
  if (!coupling) return free(k);
  const std::vector<int>& arguments = coupling->formula->arguments();
  return std::any_of(arguments.begin(), arguments.end(), free);
}

} // namespace

template <int Dim>
int stick_unsupported(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                      ContactState<Dim>& state, const std::vector<char>& refused,
                      const std::vector<char>& turning, bool geared) {
  const auto poses = model.poses(state.q);
  for (int t = 0; t < static_cast<int>(model.tools.size()); ++t) {
    if (model.laws[t].frictionless() || (!turning.empty() && turning[t])) continue;
    const ToolContact contact = contact_of(model, poses, state, t, refused);
    if (!contact.any || contact.sticks) continue;
    for (Eigen::Index k = 0; k < contact.normal.size(); ++k) {
      const int q = model.first[t] + static_cast<int>(k);
      if (contact.normal[k] > ALONG * contact.size[k] || !under_force(model, prescribed, q)) continue;
      const bool shared = model.coupling_of(q) || resisted_through_followers(model, poses, state, q);
      if (shared && (!geared || refused[contact.least_slip])) continue;
      ContactNode<Dim>& support = state.nodes[contact.least_slip];
      support.bears = model.is_weightless(contact.least_slip) && !support.has_ties;
      make_stick(support);
      return contact.least_slip;
    }
  }
  return -1;
}

template <int Dim> void relieve_vertices(const ContactModel<Dim>& model, ContactState<Dim>& state) {
  std::vector<char> supported(model.tools.size(), 0);
  const auto bears = [](const ContactNode<Dim>& node) { return in_contact(node.state) && node.bears; };
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (sticks(node.state) && !bears(node) && !model.law(static_cast<int>(i), node).frictionless())
      supported[node.tool] = 1;
  }
  for (auto& node : state.nodes)
    if (bears(node) && supported[node.tool]) {
      make_slide<Dim>(node, Vector<Dim>::Zero());
      node.bears = false;
    }
}

template <int Dim>
bool stick_at_neutral_point(const ContactModel<Dim>& model, ContactState<Dim>& state,
                            const std::vector<char>& refused, const std::vector<char>* idle) {
  int best = -1;
  double smallest = 0;
  bool neutral = false;
  const auto poses = model.poses(state.q);
  std::vector<Vector<Dim>> direction(model.tools.size(),
                                     Vector<Dim>::Zero()); // of a tool's first sliding node
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state) || !model.can_slip(static_cast<int>(i))) continue;
    if (model.is_weightless(static_cast<int>(i)) && !node.bears && !node.has_ties) continue;
    if (idle && ((*idle)[node.tool] || model.laws[node.tool].frictionless())) continue;
    if (sticks(node.state) || model.laws[node.tool].frictionless()) return false;
    const Vector<Dim> here = poses[node.tool].R * node.slip_direction;
    if (direction[node.tool].isZero()) direction[node.tool] = here;
    neutral = neutral || direction[node.tool].dot(here) < 0;
    const double slip = slip_of(model, node, poses[node.tool].size).norm();
    if (node.tied || refused[i] || (best >= 0 && slip >= smallest)) continue;
    best = static_cast<int>(i);
    smallest = slip;
  }
  if (best < 0 || !(neutral || idle)) return false;
  make_stick(state.nodes[best]);
  return true;
}

template <int Dim>
void support_after_events(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                          const std::vector<ContactEvent<Dim>>& events, bool pass_on,
                          ContactState<Dim>& state) {
  const std::vector<ContactNode<Dim>> before = state.nodes;
  std::vector<char> refused(before.size(), 0);
  for (const auto& event : events) {
    if (!pass_on || event.candidate < 0 || event.kind != EventKind::STICK_TO_SLIP) continue;
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i].tool == event.tool && before[i].slip_direction.dot(event.slip_direction) > 0)
        refused[i] = 1;
  }
  for (int i; (i = stick_unsupported(model, prescribed, state, refused)) >= 0;) {
    place_at(state.nodes[i], before[i].place); // from here on, not from the start of the step
    state.nodes[i].slip_rate = 0;
  }
}

template <int Dim>
std::vector<int> idle_coordinates(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                  const ContactState<Dim>& state) {
  std::vector<char> touches(model.tools.size(), 0);
  for (const auto& node : state.nodes)
    if (in_contact(node.state)) touches[node.tool] = 1;
  const auto alone = [&](int k) { return !touches[model.tool_of(k)]; };
  std::vector<int> result;
  for (int k = 0; k < model.num_coordinates(); ++k) {
    const std::vector<int> followers = model.followers(k);
    if (!prescribed.is_motion[k] && !prescribed.is_held(k) && !model.coupling_of(k) && alone(k) &&
        std::all_of(followers.begin(), followers.end(), alone))
      result.push_back(k);
  }
  if (result.empty()) return result;
  const DrivingForce drive = driving_force(model, prescribed, state.q);
  result.erase(std::remove_if(result.begin(), result.end(), [&](int k) { return drive.value[k] != 0; }),
               result.end());
  return result;
}

template <int Dim>
std::vector<char> held_by_friction(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                   const ContactState<Dim>& state) {
  std::vector<char> result(model.tools.size(), 0);
  ContactState<Dim> without = state;
  for (auto& node : without.nodes)
    if (sticks(node.state)) node.state = NodeState::SLIDING;
  for (int i; (i = stick_unsupported(model, prescribed, without)) >= 0;) result[without.nodes[i].tool] = 1;
  return result;
}

template <int Dim>
std::vector<int> sole_supports(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                               const ContactState<Dim>& state) {
  std::vector<int> result;
  for (int t = 0; t < static_cast<int>(model.tools.size()); ++t) {
    int last = -1, number = 0;
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
      if (!sticks(state.nodes[i].state) || state.nodes[i].tool != t) continue;
      last = static_cast<int>(i);
      ++number;
    }
    if (number != 1) continue;
    ContactState<Dim> without = state;
    without.nodes[last].state = NodeState::SLIDING;
    if (stick_unsupported(model, prescribed, without) >= 0) result.push_back(last);
  }
  return result;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template int stick_unsupported<Dim>(const ContactModel<Dim>&, const PrescribedValues&, ContactState<Dim>&, \
                                      const std::vector<char>&, const std::vector<char>&, bool);             \
  template void relieve_vertices<Dim>(const ContactModel<Dim>&, ContactState<Dim>&);                         \
  template bool stick_at_neutral_point<Dim>(const ContactModel<Dim>&, ContactState<Dim>&,                    \
                                            const std::vector<char>&, const std::vector<char>*);             \
  template void support_after_events<Dim>(const ContactModel<Dim>&, const PrescribedValues&,                 \
                                          const std::vector<ContactEvent<Dim>>&, bool, ContactState<Dim>&);  \
  template std::vector<int> idle_coordinates<Dim>(const ContactModel<Dim>&, const PrescribedValues&,         \
                                                  const ContactState<Dim>&);                                 \
  template std::vector<char> held_by_friction<Dim>(const ContactModel<Dim>&, const PrescribedValues&,        \
                                                   const ContactState<Dim>&);                                \
  template std::vector<int> sole_supports<Dim>(const ContactModel<Dim>&, const PrescribedValues&,            \
                                               const ContactState<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
