#include "kinematics/outline.hpp"
#include "base/error.hpp"

namespace burnish {

namespace {

// Parameters in [a, b) at which a piece begins, after that of a, up to that of b; they are numbered along s.
void add_joints(const Profile<2>& profile, double a, double b, std::vector<double>& s) {
  const int last = profile.piece(Param<2>(b));
  for (int k = profile.piece(Param<2>(a)) + 1; k <= last; ++k) {
    double low = a, high = b;
    while (high - low > 1e-14 * (std::abs(low) + std::abs(high))) {
      const double middle = (low + high) / 2;
      if (middle <= low || middle >= high) break;
      (profile.piece(Param<2>(middle)) < k ? low : high) = middle;
    }
    if (high < b) s.push_back(high);
  }
}

} // namespace

std::vector<Vector<2>> outline(const Tool<2>& tool, const Eigen::VectorXd& q, long n) {
  require(n >= 2, "outline", "number of points", n, "at least 2");
  const Profile<2>& profile = tool.profile();
  const ParamRange<2> range = profile.range();
  const double begin = range.begin(0), end = range.end(0), step = (end - begin) / static_cast<double>(n - 1);
  std::vector<double> s;
  for (long i = 0; i + 1 < n; ++i) {
    const double a = begin + static_cast<double>(i) * step;
    s.push_back(a);
    // a closed profile begins again at its end
    add_joints(profile, a, i + 2 < n ? a + step : end - 1e-9 * (end - begin), s);
  }
  s.push_back(end);
  std::vector<Vector<2>> points;
  const auto pose = tool.coordinates().pose(q);
  for (const double at : s) points.push_back(tool.surface(pose, Param<2>(at)).x);
  return points;
}

} // namespace burnish
