#include "geometry/surface_mesh.hpp"
#include "geometry/surface.hpp"

namespace burnish {
namespace {

class Rows {
public:
  Rows(SurfaceMesh& mesh, const Surface<3>& surface) : m_mesh(mesh), m_surface(surface) {}

  int add(const SurfacePlace<3>& place) {
    m_mesh.points.push_back(place.y);
    m_normals.push_back(m_surface.frame(place).n);
    return static_cast<int>(m_mesh.points.size()) - 1;
  }
  // Of points of these rows.
  void triangle(int a, int b, int c) {
    const Vector<3>&x = point(a), &y = point(b), &z = point(c);
    const Vector<3> area = (y - x).cross(z - x);
    constexpr double flat = 1e-9;
    if (area.norm() <= flat * std::max((y - x).squaredNorm(), (z - x).squaredNorm())) return;
    if (area.dot(normal(a) + normal(b) + normal(c)) < 0) std::swap(b, c);
    m_mesh.triangles.push_back({a, b, c});
  }

private:
  const Vector<3>& point(int i) const { return m_mesh.points[static_cast<std::size_t>(i)]; }
  const Vector<3>& normal(int i) const { return m_normals[static_cast<std::size_t>(i - m_first)]; }

  SurfaceMesh& m_mesh;
  const Surface<3>& m_surface;
  const int m_first = static_cast<int>(m_mesh.points.size());
  std::vector<Vector<3>> m_normals;
};

} // namespace

void add_rows(SurfaceMesh& mesh, const Surface<3>& surface,
              const std::vector<std::vector<SurfacePlace<3>>>& rows) {
  Rows all(mesh, surface);
  int first = static_cast<int>(mesh.points.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto& place : rows[i]) all.add(place);
    if (i == 0) continue;
    const int width = static_cast<int>(rows[i].size());
    for (int j = first; j + 1 < first + width; ++j) {
      all.triangle(j, j + 1, j + width + 1);
      all.triangle(j, j + width + 1, j + width);
    }
    first += width;
  }
}

} // namespace burnish
