#include "kinematics/window_outline.hpp"
#include "base/error.hpp"
#include "geometry/refined_outline.hpp"

namespace burnish {
namespace {

constexpr double ROOM = 0.5;  // round the places, of their larger side
constexpr double SEEN = 2e-4; // sagitta over that side: a fifth of a pixel in a picture of a thousand
constexpr int FIRST = 65;     // places at first, before the joints

// Whether some of the curve that is as long as the chord may lie within the window.
template <int Dim> bool seen(const PictureWindow<Dim>& window, const Vector<Dim>& a, const Vector<Dim>& b) {
  const double reach = (b - a).norm();
  for (int i = 0; i < Dim; ++i)
    if (std::max(a[i], b[i]) + reach < window.low[i] || std::min(a[i], b[i]) - reach > window.high[i])
      return false;
  return true;
}

} // namespace

template <int Dim> PictureWindow<Dim> picture_window(const Eigen::VectorXd& places) {
  const Eigen::Map<const Eigen::Matrix<double, Dim, Eigen::Dynamic>> x(places.data(), Dim,
                                                                       places.size() / Dim);
  PictureWindow<Dim> window;
  window.low = x.rowwise().minCoeff();
  window.high = x.rowwise().maxCoeff();
  const double side = (window.high - window.low).maxCoeff();
  window.low.array() -= ROOM * side;
  window.high.array() += ROOM * side;
  window.sagitta = SEEN * side;
  return window;
}

template <int Dim>
std::vector<Vector<Dim>> window_outline(const Tool<Dim>& tool, const Eigen::VectorXd& q,
                                        const PictureWindow<Dim>& window) {
  require(window.sagitta > 0, "outline", "sagitta", window.sagitta, "> 0");
  const auto pose = tool.coordinates().pose(q);
  const auto in_space = [&](const Vector<Dim>& y) -> Vector<Dim> {
    return pose.origin + pose.R * (pose.size * y);
  };
  const auto allowed = [&](const Vector<Dim>& a, const Vector<Dim>& b) {
    return window.sagitta / pose.size * (seen(window, in_space(a), in_space(b)) ? 1 : FAR_OUT);
  };
  std::vector<Vector<Dim>> points;
  for (const auto& place : refined_outline<Dim>(tool.surface(), FIRST, allowed))
    points.push_back(in_space(place.y));
  return points;
}

template PictureWindow<2> picture_window<2>(const Eigen::VectorXd&);
template PictureWindow<3> picture_window<3>(const Eigen::VectorXd&);
template std::vector<Vector<2>> window_outline<2>(const Tool<2>&, const Eigen::VectorXd&,
                                                  const PictureWindow<2>&);

} // namespace burnish
