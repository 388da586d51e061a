#include "run/approach.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "diagnosis/before/wrong_side.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr int ITERATIONS = 1000;  // bound; a far tool advances by half its gap or more each time
constexpr double TOUCH = 1e-9;    // gap that counts as touch, over the spacing of candidates
constexpr double SAME_GAP = 1e-9; // nodes whose gaps differ by less touch together, same scale
constexpr double NO_SLOPE =
    1e-9; // change of the gap over the motion: below, the coordinate does not close it
constexpr double GAP_SHARE =
    1.5; // no point of the tool moves further than this part of the gap in an iteration ...
constexpr double LEAST_WAY = 0.05;  // ... or this part of the spacing
constexpr double FROM_INSIDE = 0.5; // cosine between the tool's normal and the body's outward normal

struct SmallestGap {
  double gap = 0, slope = 0, lever = 0; // gap, its change with the coordinate, motion of the foot with it
  bool parallel() const { return std::abs(slope) < NO_SLOPE * lever; }
  double fastest = 0, second_order = 0; // largest |X_,k| and |X_,kk|/2 of all candidates' feet
  std::vector<std::size_t> nodes;       // candidates that have it
};

// Smallest gap of a tool, and its change with coordinate k; places the candidates' feet in the state.
template <int Dim>
SmallestGap smallest_gap(const ContactSetup<Dim>& setup, ContactState<Dim>& state, const Eigen::VectorXd& u,
                         int tool, int k) {
  const auto& model = setup.model();
  const auto pose = model.tools[tool]->coordinates().pose(model.tool_q(state.q, tool));
  const double same = SAME_GAP * setup.body().spacing;
  SmallestGap result;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    if (!model.may_touch(static_cast<int>(i), tool)) continue;
    auto& node = state.nodes[i];
    const auto foot =
        model.tools[tool]->foot(pose, setup.body().position(u, model.candidates[i]), node.place.hint);
    const auto p = model.tools[tool]->point(pose, foot.place);
    result.fastest = std::max(result.fastest, p.x_q.col(k).norm());
    result.second_order =
        std::max(result.second_order, 0.5 * p.x_qq[static_cast<std::size_t>(k)].col(k).norm());
    if (!result.nodes.empty() && foot.gap >= result.gap + same) continue;
    if (result.nodes.empty() || foot.gap < result.gap - same) result.nodes.clear();
    result.gap = result.nodes.empty() ? foot.gap : std::min(result.gap, foot.gap);
    result.slope = -p.n.dot(p.x_q.col(k));
    result.lever = p.x_q.col(k).norm();
    result.nodes.push_back(i);
    if (node.tool == tool || !in_contact(node.state))
      node.place = foot.place; // not where another tool touches
  }
  return result;
}

// Mean normal out of the workpiece of the facets at a node; zero if there is none.
template <int Dim> Vector<Dim> outward(const ContactSetup<Dim>& setup, int node, const Eigen::VectorXd& u) {
  Vector<Dim> sum = Vector<Dim>::Zero();
  const auto& mesh = setup.mesh();
  for (const Facet<Dim>& facet : setup.surface()) {
    const std::vector<int> nodes = nodes_of(facet);
    if (facet.element < 0 || std::find(nodes.begin(), nodes.end(), node) == nodes.end()) continue;
    const auto& vertex = facet.vertex;
    const int* corner = mesh.element(facet.element);
    const int opposite = *std::find_if(corner, corner + Dim + 1, [&](int v) {
      return std::find(vertex.begin(), vertex.end(), v) == vertex.end();
    });
    const Vector<Dim> a = setup.body().position(u, vertex[0]);
    Tangents<Dim> along;
    for (int v = 1; v < Dim; ++v) along.col(v - 1) = setup.body().position(u, vertex[v]) - a;
    Vector<Dim> away = a - setup.body().position(u, opposite);
    for (int v = 0; v < Dim - 1; ++v) { // what is left of it across the facet
      for (int w = 0; w < v; ++w) along.col(v) -= along.col(w).dot(along.col(v)) * along.col(w);
      along.col(v).normalize();
      away -= along.col(v).dot(away) * along.col(v);
    }
    sum += away.normalized();
  }
  return sum.stableNormalized();
}

// A tool inside the workpiece has nodes at a positive gap, too, and reaches the surface from within.
template <int Dim>
void check_from_outside(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                        const Eigen::VectorXd& u, int tool, const std::vector<std::size_t>& touching) {
  const auto& model = setup.model();
  const auto pose = model.tools[tool]->coordinates().pose(model.tool_q(state.q, tool));
  for (const std::size_t i : touching) {
    const int node = model.candidates[i];
    const Vector<Dim> n = pose.R * model.tools[tool]->surface().frame(state.nodes[i].place).n;
    if (n.dot(outward(setup, node, u)) < FROM_INSIDE) continue;
    std::ostringstream text;
    text << "tool \"" << setup.tools()[tool]->name()
         << "\" comes to the surface from inside the workpiece, at node " << node << " at "
         << place_text(setup.body().position(u, node)) << "; place it outside first, or, "
         << turned_to_the_body<Dim>();
    fail("contact.approach", text.str());
  }
}

// Whether the whole workpiece lies inside a tool, on the wrong side of all of its surface.
template <int Dim>
bool swallows(const ContactSetup<Dim>& setup, const Eigen::VectorXd& q, const Eigen::VectorXd& u, int tool) {
  const Tool<Dim>& placed = *setup.model().tools[tool];
  const auto pose = placed.coordinates().pose(setup.model().tool_q(q, tool));
  Param<Dim> hint = Param<Dim>::Zero();
  for (int node = 0; node < static_cast<int>(setup.body().X.size()) / Dim; ++node) {
    const auto foot = placed.foot(pose, setup.body().position(u, node), hint);
    if (foot.on_end || foot.gap > -TOUCH * setup.body().spacing) return false;
    hint = foot.place.hint;
  }
  return true;
}

// A tool that faces away passes through the whole workpiece and comes to rest behind it.
template <int Dim>
[[noreturn]] void fail_behind(const ContactSetup<Dim>& setup, int tool, int node, const Eigen::VectorXd& u) {
  std::ostringstream text;
  text << "tool \"" << setup.tools()[tool]->name()
       << "\" is placed with the whole workpiece inside it, and would come out on its far side, at node "
       << node << " at " << place_text(setup.body().position(u, node)) << "; place it outside first, or, "
       << turned_to_the_body<Dim>();
  fail("contact.approach", text.str());
}

// A coordinate that follows others cannot move alone, nor one that another of the same tool follows.
template <int Dim> void check_independent_approach(const ContactSetup<Dim>& setup, int q) {
  const auto& model = setup.model();
  if (const Coupling* coupling = model.coupling_of(q))
    fail("contact.approach", model.coordinate(q) + " follows \"" + coupling->formula->text() +
                                 "\"; approach along " + model.coordinate(coupling->formula->arguments()[0]));
  for (const int follower : model.followers(q))
    if (model.tool_of(follower) == model.tool_of(q))
      fail("contact.approach", model.coordinate(follower) + " follows " + model.coordinate(q) +
                                   ", which cannot approach alone; place it by hand");
}

template <int Dim> [[noreturn]] void fail_approach(const ContactSetup<Dim>& setup, int tool, int k) {
  const Tool<Dim>& placed = *setup.model().tools[tool];
  const double h = setup.body().spacing, radius = placed.coordinates().pose(setup.tools()[tool]->q()).size *
                                                  placed.surface().tightest_radius();
  std::ostringstream small;
  if (radius < h)
    small << " (its tightest radius, " << radius << ", is smaller than the distance of the contact nodes, "
          << h << ": it may pass between them)";
  fail("contact.approach", setup.model().coordinate(setup.model().first[tool] + k) +
                               " alone does not bring it to the body" + small.str() +
                               "; place the tool opposite the contact surface first (" +
                               side_of_the_body<Dim>() + "); " + turned_to_the_body<Dim>());
}

// Moves the tool to its first touch in a direction; 0: in which its smallest gap closes. @returns the nodes, none: it passes by
template <int Dim>
std::vector<std::size_t> to_touch(const ContactSetup<Dim>& setup, ContactState<Dim>& state,
                                  const Eigen::VectorXd& u, int tool, int k, double direction) {
  double& q = state.q[setup.model().first[tool] + k];
  const double spacing = setup.body().spacing;
  const auto X = setup.body().X.reshaped(Dim, setup.body().X.size() / Dim);
  const double size = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).norm();
  double left = std::numeric_limits<double>::infinity(); // gap beyond which the tool has left the body
  for (int iteration = 0; iteration < ITERATIONS; ++iteration) {
    const SmallestGap least = smallest_gap(setup, state, u, tool, k);
    if (std::abs(least.gap) < TOUCH * spacing) return least.nodes;
    if (iteration == 0) left = std::abs(least.gap) + size;
    if (least.gap > left || (least.parallel() && (direction == 0 || least.gap < 0))) break;
    const double newton = least.parallel() ? 0 : -least.gap / least.slope;
    if (direction == 0 && least.gap > 0) direction = std::copysign(1, newton);
    // no point of the tool moves much further than the gap, to second order, lest a leap past a dead center
    // or through the body ends at another touch than the first one
    const double way = std::max(GAP_SHARE * std::abs(least.gap), LEAST_WAY * spacing);
    const double most =
        2 * way / (least.fastest + std::sqrt(least.fastest * least.fastest + 4 * least.second_order * way));
    const bool passes = least.gap > 0 && newton * direction <= 0; // the nearest nodes; others are in its way
    q += passes ? direction * most : std::clamp(newton, -most, most);
  }
  return {};
}

// At the place that the node has on the tool.
template <int Dim>
void touch(const ContactSetup<Dim>& setup, int candidate, int tool, ContactState<Dim>& state) {
  auto& node = state.nodes[candidate];
  node.tool = tool;
  place_at(node, node.place);
  node.state = setup.model().law(candidate, tool).frictionless() ? NodeState::SLIDING : NodeState::STICKING;
}

} // namespace

template <int Dim>
ContactState<Dim> approached(const ContactSetup<Dim>& setup, ContactState<Dim> state,
                             const Eigen::VectorXd& u, int tool, int k) {
  const int at = setup.model().first[tool] + k;
  check_independent_approach(setup, at);
  const double from = state.q[at];
  const bool behind_all = swallows(setup, state.q, u, tool);
  const SmallestGap least = smallest_gap(setup, state, u, tool, k);
  const bool both = least.gap > TOUCH * setup.body().spacing && least.parallel();
  std::vector<std::size_t> touching = to_touch(setup, state, u, tool, k, both ? 1 : 0);
  if (both) {
    ContactState<Dim> back = state;
    back.q[at] = from;
    auto behind = to_touch(setup, back, u, tool, k, -1);
    if (!behind.empty() && (touching.empty() || from - back.q[at] < state.q[at] - from)) {
      state = std::move(back);
      touching = std::move(behind);
    }
  }
  if (touching.empty()) fail_approach(setup, tool, k);
  check_from_outside(setup, state, u, tool, touching);
  if (behind_all) fail_behind(setup, tool, setup.model().candidates[touching.front()], u);
  for (const std::size_t i : touching) touch(setup, static_cast<int>(i), tool, state);
  return state;
}

template <int Dim>
void touch_in_place(const ContactSetup<Dim>& setup, const Eigen::VectorXd& u, ContactState<Dim>& state) {
  if (constrains_rigid_motions(setup.body())) return;
  const auto& model = setup.model();
  const auto poses = model.poses(state.q);
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
    if (in_contact(state.nodes[i].state)) continue;
    const auto nearest =
        nearest_tool(model, poses, setup.body().position(u, model.candidates[i]), state.nodes[i], i);
    if (nearest.foot.gap > TOUCH * setup.body().spacing) continue;
    state.nodes[i].place = nearest.foot.place;
    touch(setup, i, nearest.tool, state);
  }
}

template ContactState<2> approached<2>(const ContactSetup<2>&, ContactState<2>, const Eigen::VectorXd&, int,
                                       int);
template ContactState<3> approached<3>(const ContactSetup<3>&, ContactState<3>, const Eigen::VectorXd&, int,
                                       int);
template void touch_in_place<2>(const ContactSetup<2>&, const Eigen::VectorXd&, ContactState<2>&);
template void touch_in_place<3>(const ContactSetup<3>&, const Eigen::VectorXd&, ContactState<3>&);

} // namespace burnish
