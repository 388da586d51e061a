#include "kinematics/window_outline.hpp"
#include "base/error.hpp"

namespace burnish {
namespace {

constexpr double ROOM = 0.5;        // round the places, of their larger side
constexpr double SEEN = 2e-4;       // sagitta over that side: a fifth of a pixel in a picture of a thousand
constexpr int FIRST = 65;           // places at first, before the joints
constexpr int DEEPEST = 12;         // halvings of an interval
constexpr std::size_t MOST = 20000; // points

template <int Dim> class Sampler {
public:
  Sampler(const Tool<Dim>& tool, const Eigen::VectorXd& q, const PictureWindow<Dim>& window)
      : m_tool(tool), m_pose(tool.coordinates().pose(q)), m_window(window) {}

  std::vector<Vector<Dim>> sample() {
    const auto places = m_tool.surface().outline(FIRST);
    m_points = {at(places.front())};
    for (std::size_t i = 1; i < places.size(); ++i) halve(places[i - 1], places[i], 0);
    return m_points;
  }

private:
  Vector<Dim> at(const SurfacePlace<Dim>& place) const { return m_tool.position(m_pose, place); }

  // Whether some of the curve that is as long as the chord may lie within the window.
  bool seen(const Vector<Dim>& a, const Vector<Dim>& b) const {
    const double reach = (b - a).norm();
    for (int i = 0; i < Dim; ++i)
      if (std::max(a[i], b[i]) + reach < m_window.low[i] || std::min(a[i], b[i]) - reach > m_window.high[i])
        return false;
    return true;
  }

  static double off_chord(const Vector<Dim>& a, const Vector<Dim>& b, const Vector<Dim>& p) {
    const Vector<Dim> chord = b - a;
    const double along =
        chord.squaredNorm() > 0 ? std::clamp(chord.dot(p - a) / chord.squaredNorm(), 0., 1.) : 0;
    return (p - a - along * chord).norm();
  }

  // Appends the points after a, up to b.
  void halve(const SurfacePlace<Dim>& a, const SurfacePlace<Dim>& b, int depth) {
    const Surface<Dim>& surface = m_tool.surface();
    const Vector<Dim> x = at(a), y = at(b);
    double off = 0;
    for (const double f : {0.25, 0.5, 0.75})
      off = std::max(off, off_chord(x, y, at(surface.between(a, b, f))));
    const double allowed = m_window.sagitta * (seen(x, y) ? 1 : FAR_OUT);
    if (off > allowed && depth < DEEPEST && m_points.size() < MOST) {
      const auto middle = surface.between(a, b, 0.5);
      halve(a, middle, depth + 1);
      halve(middle, b, depth + 1);
      return;
    }
    m_points.push_back(y);
  }

  const Tool<Dim>& m_tool;
  const Pose<Dim> m_pose;
  const PictureWindow<Dim>& m_window;
  std::vector<Vector<Dim>> m_points;
};

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
  return Sampler<Dim>(tool, q, window).sample();
}

template PictureWindow<2> picture_window<2>(const Eigen::VectorXd&);
template PictureWindow<3> picture_window<3>(const Eigen::VectorXd&);
template std::vector<Vector<2>> window_outline<2>(const Tool<2>&, const Eigen::VectorXd&,
                                                  const PictureWindow<2>&);

} // namespace burnish
