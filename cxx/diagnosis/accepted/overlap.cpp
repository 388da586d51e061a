// Tools in the workpiece: between the nodes of an edge, and at edges that no label lets them touch (ALGORITHMS.md 16.3).
#include "base/sentence.hpp"
#include "contact/contact_archive.hpp"
#include "diagnosis/accepted/boundary_edges.hpp"
#include "diagnosis/accepted/tool_depth.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr Bounds EDGE_DEPTH{0.1, 0.5}; // depth of a tool between two contact nodes over their distance
constexpr double OVERLAP =
    0.05; // depth of a tool in an edge that it does not touch, over the edge: untrusted

template <int Dim> class OverlapCheck final : public ObserverOf<OverlapCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_edges, m_place, m_candidate, m_tools)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  // A node that is far from a tool is not asked again before both could have met.
  struct Distance {
    double known = -1; // when it was asked last; < 0: never [length]
    Vector<Dim> x = Vector<Dim>::Zero();
    double moved = 0; // of the tool until then
    Param<Dim> hint = Param<Dim>::Zero();
    BURNISH_FIELDS(known, x, moved, hint)
  };
  struct Watched {
    Vector<Dim> origin;
    Tensor<Dim> R;
    double reach = 0;               // largest distance of its points from its origin [length]
    double moved = 0;               // way that no point of it has exceeded so far [length]
    std::vector<Distance> distance; // per node of the boundary
    BURNISH_FIELDS(origin, R, reach, moved, distance)
  };
  void start(const AcceptedStep<Dim>& step);
  void move(const AcceptedStep<Dim>& step, int tool);
  double distance(const AcceptedStep<Dim>& step, int tool, int node);
  void look_at_tool(const AcceptedStep<Dim>& step, FindingList& findings, int tool);

  std::vector<BoundaryEdge<Dim>> m_edges;
  std::vector<int> m_place;     // of a node among those of the boundary
  std::vector<int> m_candidate; // of a node, -1: none
  std::vector<Watched> m_tools;
};

// Worst of the edges of one kind.
template <int Dim> struct Worst {
  double ratio = 0, depth = 0;
  ToolDepth<Dim> at;
};

struct Verdict {
  const char* check;
  Severity severity;
  double bound;
  const char* what;
};

template <int Dim>
void report(const AcceptedStep<Dim>& step, int tool, const Verdict& verdict, const Worst<Dim>& worst,
            FindingList& findings) {
  Finding* finding =
      findings.report(verdict.check, step.tool_name(tool), verdict.severity, worst.ratio, step.t);
  if (!finding) return;
  finding->value = worst.ratio;
  finding->bound = verdict.bound;
  finding->place = step.place_of(worst.at.x);
  finding->text = sentence("tool \"", step.tool_name(tool), "\" ", verdict.what, " by ", worst.depth, ", ",
                           worst.ratio, " of the edge there", step.at(worst.at.x));
}

template <int Dim> void OverlapCheck<Dim>::start(const AcceptedStep<Dim>& step) {
  constexpr int samples = 64;
  m_edges = boundary_edges(step.mesh());
  m_place.assign(static_cast<std::size_t>(step.mesh().num_nodes), -1);
  int places = 0;
  for (const BoundaryEdge<Dim>& edge : m_edges)
    for (const int node : {edge.a, edge.b})
      if (m_place[node] < 0) m_place[node] = places++;
  m_candidate = candidate_of_node(step.model().candidates, step.mesh().num_nodes);
  for (std::size_t tool = 0; tool < step.model().tools.size(); ++tool) {
    Watched watched;
    watched.origin = step.poses[tool].origin;
    watched.R = step.poses[tool].size * step.poses[tool].R;
    for (const SurfacePlace<Dim>& place : step.model().tools[tool]->surface().samples(samples))
      watched.reach = std::max(watched.reach, place.y.norm());
    watched.distance.resize(static_cast<std::size_t>(places));
    m_tools.push_back(std::move(watched));
  }
}

template <int Dim> void OverlapCheck<Dim>::move(const AcceptedStep<Dim>& step, int tool) {
  Watched& watched = m_tools[tool];
  const Pose<Dim>& pose = step.poses[tool];
  watched.moved +=
      (pose.origin - watched.origin).norm() + (pose.size * pose.R - watched.R).norm() * watched.reach;
  watched.origin = pose.origin;
  watched.R = pose.size * pose.R;
}

// Of a node from a tool's surface, or less.
template <int Dim> double OverlapCheck<Dim>::distance(const AcceptedStep<Dim>& step, int tool, int node) {
  Watched& watched = m_tools[tool];
  Distance& last = watched.distance[m_place[node]];
  const Vector<Dim> x = step.body().position(step.u, node);
  if (last.known >= 0) {
    const double left = last.known - (x - last.x).norm() - (watched.moved - last.moved);
    if (left > 0.5 * last.known) return left;
  }
  const SurfaceFoot<Dim> foot = step.model().tools[tool]->foot(step.poses[tool], x, last.hint);
  last = {std::abs(foot.gap), x, watched.moved, foot.place.hint};
  return last.known;
}

template <int Dim>
void OverlapCheck<Dim>::look_at_tool(const AcceptedStep<Dim>& step, FindingList& findings, int tool) {
  Worst<Dim> between, overlap;
  for (const BoundaryEdge<Dim>& edge : m_edges) {
    const Vector<Dim> a = step.body().position(step.u, edge.a), b = step.body().position(step.u, edge.b);
    const double length = (b - a).norm();
    if (std::min(distance(step, tool, edge.a), distance(step, tool, edge.b)) > length) continue;
    const ToolDepth<Dim> depth = tool_depth(*step.model().tools[tool], step.poses[tool], a, b,
                                            m_tools[tool].distance[m_place[edge.a]].hint);
    const Vector<Dim> out = outward(step.body(), step.u, edge);
    // a face of the body behind an open tool, or beyond its end, is no overlap
    if (!(depth.depth > 0) || depth.on_end || depth.n.dot(out) >= 0) continue;
    const int i = m_candidate[edge.a], j = m_candidate[edge.b];
    const bool may = i >= 0 && j >= 0 && step.model().may_touch(i, tool) && step.model().may_touch(j, tool);
    Worst<Dim>& worst = may ? between : overlap;
    if (depth.depth / length > worst.ratio) worst = {depth.depth / length, depth.depth, depth};
  }
  findings.largest("edge depth", between.ratio);
  findings.largest("overlap", overlap.ratio);
  if (between.ratio > EDGE_DEPTH.noted) {
    const bool far = between.ratio > EDGE_DEPTH.far;
    report(step, tool,
           {"edge depth", far ? Severity::UNTRUSTED : Severity::WARNING,
            far ? EDGE_DEPTH.far : EDGE_DEPTH.noted, "reaches into the workpiece between two contact nodes"},
           between, findings);
  }
  if (overlap.ratio > OVERLAP)
    report(step, tool,
           {"overlap", Severity::UNTRUSTED, OVERLAP,
            "overlaps the workpiece where it may not touch it (no contact label, or held nodes)"},
           overlap, findings);
}

template <int Dim> void OverlapCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  if (m_tools.empty()) start(step);
  for (int tool = 0; tool < static_cast<int>(m_tools.size()); ++tool) {
    move(step, tool);
    look_at_tool(step, findings, tool);
  }
}

} // namespace

BURNISH_OBSERVER(overlap_check, OverlapCheck)

} // namespace burnish
