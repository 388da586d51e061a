#include "geometry/refined_outline.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr int DEEPEST = 12;         // halvings of an interval
constexpr std::size_t MOST = 20000; // places

template <int Dim> class Refinement {
public:
  using Allowed = std::function<double(const Vector<Dim>&, const Vector<Dim>&)>;
  Refinement(const Surface<Dim>& surface, const Allowed& allowed) : m_surface(surface), m_allowed(allowed) {}

  std::vector<SurfacePlace<Dim>> refine(const std::vector<SurfacePlace<Dim>>& places) {
    m_places = {places.front()};
    for (std::size_t i = 1; i < places.size(); ++i) halve(places[i - 1], places[i], 0);
    return m_places;
  }

private:
  static double off_chord(const Vector<Dim>& a, const Vector<Dim>& b, const Vector<Dim>& p) {
    const Vector<Dim> chord = b - a;
    const double along =
        chord.squaredNorm() > 0 ? std::clamp(chord.dot(p - a) / chord.squaredNorm(), 0., 1.) : 0;
    return (p - a - along * chord).norm();
  }

  // Appends the places after a, up to b.
  void halve(const SurfacePlace<Dim>& a, const SurfacePlace<Dim>& b, int depth) {
    double off = 0;
    for (const double f : {0.25, 0.5, 0.75})
      off = std::max(off, off_chord(a.y, b.y, m_surface.between(a, b, f).y));
    if (off > m_allowed(a.y, b.y) && depth < DEEPEST && m_places.size() < MOST) {
      const auto middle = m_surface.between(a, b, 0.5);
      halve(a, middle, depth + 1);
      halve(middle, b, depth + 1);
      return;
    }
    m_places.push_back(b);
  }

  const Surface<Dim>& m_surface;
  const Allowed& m_allowed;
  std::vector<SurfacePlace<Dim>> m_places;
};

} // namespace

template <int Dim>
std::vector<SurfacePlace<Dim>>
refined_outline(const Surface<Dim>& surface, int first,
                const std::function<double(const Vector<Dim>&, const Vector<Dim>&)>& allowed) {
  return Refinement<Dim>(surface, allowed).refine(surface.outline(first));
}

template std::vector<SurfacePlace<2>>
refined_outline<2>(const Surface<2>&, int, const std::function<double(const Vector<2>&, const Vector<2>&)>&);

} // namespace burnish
