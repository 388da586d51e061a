#include "diagnosis/accepted/tool_depth.hpp"

namespace burnish {

ToolDepth tool_depth(const Tool<2>& tool, const Pose<2>& pose, const Vector<2>& a, const Vector<2>& b,
                     const Param<2>& hint) {
  constexpr int secants = 3; // of the slope, which is nearly linear along an edge
  const Vector<2> along = b - a;
  ToolDepth worst;
  bool first = true;
  Param<2> near = hint;
  const auto slope_at = [&](double s) {
    const Vector<2> x = a + s * along;
    const SurfaceFoot<2> foot = tool.foot(pose, x, near);
    near = foot.place.hint;
    const Vector<2> n = pose.R * tool.surface().frame(foot.place).n;
    if (first || -foot.gap > worst.depth) worst = {-foot.gap, x, n, foot.on_end};
    first = false;
    return n.dot(along);
  };
  double left = 0, right = 1, from = slope_at(0), to = slope_at(1);
  for (int i = 0; i < secants && from < 0 && to > 0; ++i) {
    const double s = left - from * (right - left) / (to - from), slope = slope_at(s);
    (slope < 0 ? left : right) = s;
    (slope < 0 ? from : to) = slope;
  }
  return worst;
}

} // namespace burnish
