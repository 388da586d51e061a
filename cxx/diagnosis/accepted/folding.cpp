// The workpiece in itself: boundary edges that cross (ALGORITHMS.md 16.3).
#include "base/sentence.hpp"
#include "diagnosis/accepted/boundary_edges.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Of the plane. In space nothing is checked: triangles against triangles would cost more than the step, and an element that
// turns over is refused anyway.
template <int Dim> class FoldingCheck final : public ObserverOf<FoldingCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_edges)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  void look_at_plane(const AcceptedStep<2>& step, FindingList& findings);
  std::vector<BoundaryEdge<2>> m_edges;
};

// A boundary edge where it is.
struct Placed {
  int a, b; // nodes
  Vector<2> from, to;
};

double cross(const Vector<2>& a, const Vector<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

// How far the ends of two edges that cross lie beyond the other one, at least, over its length; 0: they do not cross.
double crossing(const Placed& p, const Placed& q, Vector<2>& x) {
  if (p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b) return 0;
  const Vector<2> dp = p.to - p.from, dq = q.to - q.from;
  const double c = cross(dp, q.from - p.from), d = cross(dp, q.to - p.from), e = cross(dq, p.from - q.from),
               f = cross(dq, p.to - q.from);
  if (!(c * d < 0 && e * f < 0)) return 0;
  x = p.from + e / (e - f) * dp;
  const double length = std::max(dp.norm(), dq.norm());
  return std::min(std::min(std::abs(c), std::abs(d)) / dp.norm(),
                  std::min(std::abs(e), std::abs(f)) / dq.norm()) /
         length;
}

template <int Dim> void FoldingCheck<Dim>::look_at_plane(const AcceptedStep<2>& step, FindingList& findings) {
  constexpr double touching = 1e-2; // of an edge: crossings that do not count
  if (m_edges.empty()) m_edges = boundary_edges(step.mesh());
  std::vector<Placed> edges;
  edges.reserve(m_edges.size());
  Vector<2> low = step.body().position(step.u, m_edges[0].a), high = low;
  for (const BoundaryEdge<2>& edge : m_edges) {
    edges.push_back(
        {edge.a, edge.b, step.body().position(step.u, edge.a), step.body().position(step.u, edge.b)});
    low = low.cwiseMin(edges.back().from);
    high = high.cwiseMax(edges.back().from);
  }
  // sweep along the longer side of the body
  const int k = high[0] - low[0] > high[1] - low[1] ? 0 : 1;
  const auto begin = [&](const Placed& p) { return std::min(p.from[k], p.to[k]); };
  const auto end = [&](const Placed& p) { return std::max(p.from[k], p.to[k]); };
  std::sort(edges.begin(), edges.end(), [&](const Placed& p, const Placed& q) {
    return begin(p) != begin(q) ? begin(p) < begin(q) : p.a < q.a;
  });
  double worst = 0;
  Vector<2> place = low, x = low;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double last = end(edges[i]), lowest = std::min(edges[i].from[1 - k], edges[i].to[1 - k]),
                 highest = std::max(edges[i].from[1 - k], edges[i].to[1 - k]);
    for (std::size_t j = i + 1; j < edges.size() && begin(edges[j]) < last; ++j) {
      if (std::min(edges[j].from[1 - k], edges[j].to[1 - k]) > highest ||
          std::max(edges[j].from[1 - k], edges[j].to[1 - k]) < lowest)
        continue;
      const double depth = crossing(edges[i], edges[j], x);
      if (depth <= worst) continue;
      worst = depth;
      place = x;
    }
  }
  findings.largest("folding", worst);
  if (!(worst > touching)) return;
  Finding* finding = findings.report("folding", "", Severity::UNTRUSTED, worst, step.t);
  if (!finding) return;
  finding->value = worst;
  finding->bound = touching;
  finding->place = step.place_of(place);
  finding->text = sentence("the workpiece overlaps itself: two boundary edges cross", step.at(place),
                           ", and a body does not touch itself here; end the run earlier");
}

template <int Dim> void FoldingCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  if constexpr (Dim == 2) look_at_plane(step, findings);
}

} // namespace

BURNISH_OBSERVER(folding_check, FoldingCheck)

} // namespace burnish
