#include "diagnosis/accepted/tool_depth.hpp"

namespace burnish {

template <int Dim>
ToolDepth<Dim> tool_depth(const Tool<Dim>& tool, const Pose<Dim>& pose, const Vector<Dim>& a,
                          const Vector<Dim>& b, const Param<Dim>& hint) {
  constexpr int secants = 3; // of the slope, which is nearly linear along an edge
  const Vector<Dim> along = b - a;
  ToolDepth<Dim> worst;
  bool first = true;
  Param<Dim> near = hint;
  const auto slope_at = [&](double s) {
    const Vector<Dim> x = a + s * along;
    const SurfaceFoot<Dim> foot = tool.foot(pose, x, near);
    near = foot.place.hint;
    const Vector<Dim> n = pose.R * tool.surface().frame(foot.place).n;
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

template ToolDepth<2> tool_depth(const Tool<2>&, const Pose<2>&, const Vector<2>&, const Vector<2>&,
                                 const Param<2>&);
template ToolDepth<3> tool_depth(const Tool<3>&, const Pose<3>&, const Vector<3>&, const Vector<3>&,
                                 const Param<3>&);

} // namespace burnish
