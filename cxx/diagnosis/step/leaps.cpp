#include "diagnosis/step/leaps.hpp"
#include "diagnosis/step/unheld_workpiece.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr double SAMPLE = 0.25;      // motion between two looks at the tools, over the thickness of the tool
constexpr int MOST_SAMPLES = 400;    // looks in one step
constexpr double LEAST_TRAVEL = 0.5; // of the thickness: a shorter way passes nothing
constexpr double LEAST_DEPTH = 0.1;  // on the way, over the thickness, or one spacing if that is less
constexpr double HELD_JUMP = 0.05;   // way of a body on its hold that counts, over the spacing
constexpr int OUTLINE = 64;          // places that the thickness is measured with
constexpr int MOST_BETWEEN = 8;      // places looked at between two nodes

// Across a closed profile: twice its area over half its length, the diameter of a circle; else its length.
template <int Dim> double thickness(const Surface<Dim>& surface) {
  if (Dim != 2 || !surface.closed()) return surface.length_scale();
  double area = 0, length = 0;
  const auto places = surface.samples(OUTLINE);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector<Dim>&a = places[i].y, &b = places[(i + 1) % places.size()].y;
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    length += (b - a).norm();
  }
  return 4 * std::abs(area) / length;
}

// Places of the contact surface at both ends: its nodes, and places between those that lie farther apart than `apart`.
template <int Dim> struct SurfacePoints {
  std::vector<Vector<Dim>> start, end;
  std::vector<int> candidate; // the node, or the first of the two
};

template <int Dim>
SurfacePoints<Dim> points_of_surface(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path,
                                     double apart) {
  SurfacePoints<Dim> points;
  const auto free = [&](int i) {
    return i >= 0 && !in_contact(path.end->nodes[i].state) && !in_contact(path.start->nodes[i].state);
  };
  const auto add = [&](int a, int b, double f, int candidate) {
    const auto at = [&](const Eigen::VectorXd& u) -> Vector<Dim> {
      return (1 - f) * setup.body().position(u, a) + f * setup.body().position(u, b);
    };
    points.start.push_back(at(*path.u_start));
    points.end.push_back(at(*path.u_end));
    points.candidate.push_back(candidate);
  };
  const std::vector<int> candidate = candidate_of_node(setup.model().candidates, setup.mesh().num_nodes);
  for (const int node : setup.candidates())
    if (free(candidate[node])) add(node, node, 0, candidate[node]);
  for (const Facet<Dim>& facet : setup.surface())
    for (int v = 0; v < Dim * (Dim - 1) / 2; ++v) { // its edges
      const int a = facet.vertex[v], b = facet.vertex[(v + 1) % Dim];
      if (!free(candidate[a]) || !free(candidate[b])) continue;
      const double length =
          (setup.body().position(*path.u_end, b) - setup.body().position(*path.u_end, a)).norm();
      const int pieces = std::min(MOST_BETWEEN, static_cast<int>(std::ceil(length / apart)));
      for (int i = 1; i < pieces; ++i) add(a, b, static_cast<double>(i) / pieces, candidate[a]);
    }
  return points;
}

// Largest distance that points of the tool and of the surface move against one another.
template <int Dim> double travel(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path, int tool) {
  const auto& model = setup.model();
  const auto poses = model.poses(path.start->q), end = model.poses(path.end->q);
  const double size = model.tools[tool]->surface().length_scale();
  double way = pose_change(poses[tool], end[tool], size);
  for (int k = model.first[tool]; k < model.first[tool + 1]; ++k) // a turn that ends where it began
    way = std::max(way, std::abs(path.end->q[k] - path.start->q[k]) * lever(model, poses, k));
  double body = 0;
  for (const int node : setup.candidates())
    body = std::max(
        body, (setup.body().position(*path.u_end, node) - setup.body().position(*path.u_start, node)).norm());
  return way + body;
}

// First place that the tool passes, -1 if none.
template <int Dim>
int passed_point(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path, int t, double size, double way,
                 const SurfacePoints<Dim>& points) {
  const auto& model = setup.model();
  const auto& tool = *model.tools[t];
  const double depth = LEAST_DEPTH * std::min(size, setup.body().spacing / LEAST_DEPTH);
  const auto gap = [&](const Pose<Dim>& pose, const Vector<Dim>& x) {
    return tool.foot(pose, x, Param<Dim>::Zero()).gap;
  };
  const int samples = std::min(MOST_SAMPLES, static_cast<int>(std::ceil(way / (SAMPLE * size))));
  const auto first = model.poses(path.start->q), last = model.poses(path.end->q);
  std::vector<std::size_t> outside;
  for (std::size_t i = 0; i < points.start.size(); ++i)
    if (model.may_touch(points.candidate[i], t) && gap(first[t], points.start[i]) >= 0 &&
        gap(last[t], points.end[i]) >= 0)
      outside.push_back(i);
  for (int s = 1; s < samples && !outside.empty(); ++s) {
    const double f = static_cast<double>(s) / samples;
    const auto poses = model.poses(path.start->q + f * (path.end->q - path.start->q));
    for (const std::size_t i : outside)
      if (gap(poses[t], (1 - f) * points.start[i] + f * points.end[i]) < -depth) return static_cast<int>(i);
  }
  return -1;
}

// Whether the tool of a coordinate is in contact.
template <int Dim> bool touches(const ContactModel<Dim>& model, const ContactState<Dim>& state, int k) {
  const int tool = model.tool_of(k);
  for (const ContactNode<Dim>& node : state.nodes)
    if (in_contact(node.state) && node.tool == tool) return true;
  return false;
}

} // namespace

template <int Dim> double lever(const ContactModel<Dim>& model, const std::vector<Pose<Dim>>& poses, int k) {
  const int tool = model.tool_of(k);
  const auto own = static_cast<std::size_t>(k - model.first[tool]);
  return point_rate(poses[tool], own, model.tools[tool]->surface().length_scale());
}

template <int Dim> Failure tool_passage(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path) {
  for (int t = 0; t < static_cast<int>(setup.tools().size()); ++t) {
    const double grown =
        setup.model().tools[t]->coordinates().pose(setup.model().tool_q(path.start->q, t)).size;
    const double way = travel(setup, path, t),
                 length = grown * setup.model().tools[t]->surface().length_scale();
    if (way <= SAMPLE * std::min(length, setup.body().spacing)) continue; // cheap, for nearly all steps
    const double size = grown * thickness(setup.model().tools[t]->surface());
    if (way <= LEAST_TRAVEL * size) continue;
    const auto points = points_of_surface(setup, path, SAMPLE * size);
    const int i = passed_point(setup, path, t, size, way, points);
    if (i < 0) continue;
    Failure failure(Cause::PASSAGE);
    failure.tool = t;
    failure.place.assign(points.start[i].data(), points.start[i].data() + Dim);
    return failure;
  }
  return {};
}

template <int Dim>
Failure sudden_jump(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path,
                    const PrescribedValues& prescribed, const StepRates& rates) {
  const auto& model = setup.model();
  const auto poses = model.poses(path.start->q);
  const Eigen::VectorXd dq = path.end->q - path.start->q;
  const bool known = rates.last_dt > 0 && rates.last_dq.size() == dq.size();
  if (!known && rates.first_dq.size() != dq.size()) return {};
  Eigen::VectorXd way(dq.size()), expected(dq.size());
  double driven = 0; // by the coordinates under motion
  for (int k = 0; k < static_cast<int>(dq.size()); ++k) {
    const double arm = lever(model, poses, k);
    way[k] = arm * std::abs(dq[k]);
    expected[k] = arm * std::abs(known ? rates.last_dq[k] * rates.dt / rates.last_dt : rates.first_dq[k]);
    if (prescribed.is_motion[k]) driven = std::max(driven, way[k]);
  }
  for (int k = 0; k < static_cast<int>(dq.size()); ++k) {
    if (prescribed.is_motion[k] || model.coupling_of(k)) continue;
    if (!touches(model, *path.end, k)) continue; // its drive alone says where it goes
    if (way[k] <= JUMP_LENGTH * setup.body().spacing) continue;
    if (way[k] <= JUMP_RATE * std::max(expected[k], driven)) continue;
    Failure failure(Cause::TOOL_JUMP);
    failure.coordinate = k;
    failure.value = dq[k];
    return failure;
  }
  return {};
}

template <int Dim>
Failure body_jump(const ContactSetup<Dim>& setup, const SteppedPath<Dim>& path, const StepRates& rates,
                  bool on_hold) {
  const auto touching = [](const ContactNode<Dim>& node) { return in_contact(node.state); };
  const BodyView<Dim>& body = setup.body();
  if (constrains_rigid_motions(body)) return {};
  if (std::none_of(path.start->nodes.begin(), path.start->nodes.end(), touching)) return {};
  const auto& model = setup.model();
  const auto first = model.poses(path.start->q), last = model.poses(path.end->q);
  const bool known = rates.last_dt > 0 && rates.last_du.size() == path.u_end->size();
  double driven = 0, way = 0,
         before = 0; // by tools and supports; of the surface, in this step and in the last one
  for (std::size_t t = 0; t < first.size(); ++t)
    driven = std::max(driven, pose_change(first[t], last[t], model.tools[t]->surface().length_scale()));
  for (Eigen::Index d = 0; d < path.u_end->size(); ++d)
    if (body.fixed[d]) driven = std::max(driven, std::abs((*path.u_end)[d] - (*path.u_start)[d]));
  for (const int node : setup.candidates()) {
    way = std::max(way, (body.position(*path.u_end, node) - body.position(*path.u_start, node)).norm());
    if (known)
      before = std::max(before, rates.last_du.template segment<Dim>(Eigen::Index{Dim} * node).norm());
  }
  // where its springs alone keep a motion of the body, nothing else brings it back
  const bool on_springs = on_hold && unheld(setup, *path.start, *path.u_start);
  const double least = (on_springs ? HELD_JUMP : JUMP_LENGTH) * body.spacing;
  const double expected =
      known && !on_springs ? before * rates.dt / rates.last_dt : 0; // an end turns far about a die
  if (way <= least || way <= JUMP_RATE * std::max(driven, expected)) return {};
  Failure failure(Cause::BODY_JUMP);
  failure.value = way;
  failure.allowed = driven;
  failure.flag = on_springs;
  return failure;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template double lever<Dim>(const ContactModel<Dim>&, const std::vector<Pose<Dim>>&, int);                  \
  template Failure tool_passage<Dim>(const ContactSetup<Dim>&, const SteppedPath<Dim>&);                     \
  template Failure sudden_jump<Dim>(const ContactSetup<Dim>&, const SteppedPath<Dim>&,                       \
                                    const PrescribedValues&, const StepRates&);                              \
  template Failure body_jump<Dim>(const ContactSetup<Dim>&, const SteppedPath<Dim>&, const StepRates&, bool);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
