#include "diagnosis/accepted/tool_overlap.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// The outline of one tool against the surface of another.
struct Approach {
  double gap = std::numeric_limits<double>::infinity();     ///< smallest, at a foot that is no end [length]
  double nearest = std::numeric_limits<double>::infinity(); ///< distance of a place from the surface [length]
  bool crosses = false;
  Vector<2> x = Vector<2>::Zero(), foot = Vector<2>::Zero(); ///< of the smallest gap [length]
};

class OutlineApproach {
public:
  OutlineApproach(const PlacedTool& of, const PlacedTool& to) : m_of(of), m_to(to) {}

  Approach find() {
    const auto& places = *m_of.outline;
    double before = 0;
    int worst = -1;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double smallest = m_found.gap, gap = ask(places[i]);
      m_found.nearest = std::min(m_found.nearest, std::abs(gap));
      if (m_found.gap < smallest) worst = static_cast<int>(i);
      // a gap changes by no more than the way, unless it jumps past the end of an open tool
      if (i > 0 && (gap < 0) != (before < 0) && std::abs(gap - before) <= 1.5 * m_of.spacing)
        m_found.crosses = true;
      before = gap;
    }
    if (worst >= 0 && m_found.gap < m_of.spacing) refine(worst);
    return m_found;
  }

private:
  double ask(const SurfacePlace<2>& place) {
    const Vector<2> x = m_of.tool->position(*m_of.pose, place);
    const SurfaceFoot<2> foot = m_to.tool->foot(*m_to.pose, x, m_hint);
    m_hint = foot.place.hint;
    if (!foot.on_end && foot.gap < m_found.gap) {
      m_found.gap = foot.gap;
      m_found.x = x;
      m_found.foot = m_to.tool->position(*m_to.pose, foot.place);
    }
    return foot.gap;
  }

  // Golden section between the neighbors of the deepest place; what lies in between may cross where no place does.
  void refine(int i) {
    constexpr int times = 16;
    constexpr double golden = 0.6180339887498949;
    const auto& places = *m_of.outline;
    const SurfacePlace<2>&from = places[std::max(i - 1, 0)],
          &to = places[std::min<std::size_t>(i + 1, places.size() - 1)];
    const bool outside = m_found.gap >= 0;
    double left = 0, right = 1;
    const auto at = [&](double f) { return ask(m_of.tool->surface().between(from, to, f)); };
    double f = 1 - golden, g = golden, at_f = at(f), at_g = at(g);
    for (int k = 0; k < times; ++k) {
      if (at_f < at_g) {
        right = g, g = f, at_g = at_f;
        f = right - golden * (right - left), at_f = at(f);
      } else {
        left = f, f = g, at_f = at_g;
        g = left + golden * (right - left), at_g = at(g);
      }
    }
    if (outside && m_found.gap < 0) m_found.crosses = true;
  }

  const PlacedTool &m_of, &m_to;
  Param<2> m_hint = Param<2>::Zero();
  Approach m_found;
};

// Depth of a point in a tool; negative: it is outside, or beyond an end.
double depth_of(const Vector<2>& x, const PlacedTool& in) {
  const SurfaceFoot<2> foot = in.tool->foot(*in.pose, x, Param<2>::Zero());
  return foot.on_end ? -std::abs(foot.gap) : -foot.gap;
}

} // namespace

ToolOverlap tool_overlap(const PlacedTool& a, const PlacedTool& b) {
  const Approach ab = OutlineApproach(a, b).find(), ba = OutlineApproach(b, a).find();
  ToolOverlap overlap;
  overlap.clear = std::max({0., ab.nearest - a.spacing / 2, ba.nearest - b.spacing / 2});
  if (ab.crosses || ba.crosses) {
    // feet of one outline are points of the other one, which its places may have missed
    const double in_b = std::max(-ab.gap, depth_of(ba.foot, b)),
                 in_a = std::max(-ba.gap, depth_of(ab.foot, a));
    overlap.depth = std::max(0., std::min(in_a, in_b));
  } else if (a.tool->surface().closed() && b.tool->surface().closed()) {
    overlap.depth = std::max({0., -ab.gap, -ba.gap}); // one inside the other one
  }
  // where lines cross, the less deep one is the nearer one
  const bool first = ab.gap < 0 && (ba.gap >= 0 || ab.gap >= ba.gap);
  overlap.x = first ? (ab.x + ab.foot) / 2 : (ba.x + ba.foot) / 2;
  return overlap;
}

} // namespace burnish
