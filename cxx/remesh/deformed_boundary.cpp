#include "remesh/deformed_boundary.hpp"
#include "base/error.hpp"
#include "remesh/deformed_surface.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace burnish {
namespace {

Vector<2> tangent(const BoundaryArc& arc, bool end) {
  Vector<2> along = -3 * arc.x[0] + 4 * arc.x[1] - arc.x[2];
  if (end) along = arc.x[0] - 4 * arc.x[1] + 3 * arc.x[2];
  return along.normalized();
}
bool turns(const BoundaryArc& before, const BoundaryArc& after) {
  const Vector<2> a = tangent(before, true), b = tangent(after, false);
  return before.label != after.label ||
         std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b))) > SHARP_TURN;
}
double length(const BoundaryArc& arc) { return (arc.x[1] - arc.x[0]).norm() + (arc.x[2] - arc.x[1]).norm(); }

// Edges of one section between corners, straight and equally many of the wanted lengths long.
void divide(const std::vector<BoundaryArc>& section, double size, std::vector<OutlineEdge>& edges) {
  std::vector<double> number{0}; // of edges up to the end of each arc
  for (const BoundaryArc& arc : section)
    number.push_back(number.back() + length(arc) / (size > 0 ? size : arc.reference));
  const int count = std::max(1, static_cast<int>(std::lround(number.back())));
  Vector<2> from = section.front().x[0];
  std::size_t k = 0;
  for (int i = 1; i <= count; ++i) {
    const double wanted = number.back() * i / count;
    while (k + 1 < section.size() && number[k + 1] < wanted) ++k;
    const double s = std::min(1., (wanted - number[k]) / (number[k + 1] - number[k]));
    const Vector<2> to = i == count ? section.back().x[2] : on_parabola<2>(section[k].x, s);
    edges.push_back({from, to, section.front().label});
    from = to;
  }
}

// Area within the loops, of a ring its volume.
double enclosed(const std::vector<std::vector<BoundaryArc>>& loops, bool ring) {
  const std::array<std::array<double, 2>, 3> rule{
      {{0.5 - 0.5 * std::sqrt(0.6), 5. / 18}, {0.5, 8. / 18}, {0.5 + 0.5 * std::sqrt(0.6), 5. / 18}}};
  double sum = 0;
  for (const auto& loop : loops)
    for (const BoundaryArc& arc : loop)
      for (const auto& [s, weight] : rule) {
        const double x = on_parabola<2>(arc.x, s)[0];
        const Vector<2> along = (4 * s - 3) * arc.x[0] + (4 - 8 * s) * arc.x[1] + (4 * s - 1) * arc.x[2];
        sum += weight * (ring ? M_PI * x * x : x) * along[1];
      }
  return sum;
}

struct MiddleNode {
  int node;
  Vector<2> x, outward; // middle of its straight edge; normal times the length of the edge
};
std::vector<MiddleNode> middle_nodes(const Mesh<2>& mesh) {
  std::map<std::array<int, 2>, int> middle;
  for (const Facet<2>& facet : mesh.facets) middle[facet.vertex] = facet.middle[0];
  std::vector<MiddleNode> nodes;
  for (const auto& loop : boundary_loops(mesh, Eigen::VectorXd::Zero(mesh.num_dofs())))
    for (const BoundaryArc& edge : loop) {
      const Vector<2> chord = edge.x[2] - edge.x[0];
      nodes.push_back({middle[edge.vertex], edge.x[1], Vector<2>(chord[1], -chord[0])});
    }
  return nodes;
}

// Place on the arcs of a label that is nearest to the middle of an edge, itself where none is near.
Vector<2> place_of(const MiddleNode& middle, long label, const std::vector<BoundaryArc>& arcs) {
  std::pair<Vector<2>, double> best{middle.x, WITHIN * WITHIN * middle.outward.squaredNorm()};
  for (const BoundaryArc& arc : arcs) {
    const double reach = length(arc) + WITHIN * middle.outward.norm();
    if (arc.label != label || (arc.x[1] - middle.x).squaredNorm() > reach * reach) continue;
    const auto found = nearest_on_parabola<2>(arc.x, middle.x);
    if (found.second < best.second) best = found;
  }
  return best.first;
}

// What is missing of the volume goes to the mid nodes of curved edges, all by the same way along the normal.
void keep_volume(double volume, const Mesh<2>& fresh, Eigen::VectorXd& start) {
  const double missing = volume - enclosed(boundary_loops(fresh, start), fresh.axisymmetric);
  std::vector<MiddleNode> curved;
  double per_way = 0;
  for (const MiddleNode& middle : middle_nodes(fresh)) {
    const double size = middle.outward.norm();
    if (start.segment<2>(2 * middle.node).norm() <= CURVED * size) continue;
    curved.push_back(middle);
    per_way += 2. / 3 * size * (fresh.axisymmetric ? 2 * M_PI * middle.x[0] : 1);
  }
  for (const MiddleNode& middle : curved)
    start.segment<2>(2 * middle.node) += missing / per_way * middle.outward.normalized();
}

Eigen::VectorXd displacement(const Mesh<3>& old, const Eigen::VectorXd& u, const Mesh<3>& fresh) {
  return surface_displacement(old, u, fresh);
}

Eigen::VectorXd displacement(const Mesh<2>& old, const Eigen::VectorXd& u, const Mesh<2>& fresh) {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(fresh.num_dofs());
  if (fresh.nodes_per_element == 3) return start;
  std::map<int, long> label; // of the edge of a mid node
  for (const Facet<2>& facet : fresh.facets) label[facet.middle[0]] = facet.label;
  const auto loops = boundary_loops(old, u);
  std::vector<BoundaryArc> arcs;
  for (const auto& loop : loops) arcs.insert(arcs.end(), loop.begin(), loop.end());
  for (const MiddleNode& middle : middle_nodes(fresh))
    start.segment<2>(2 * middle.node) = place_of(middle, label[middle.node], arcs) - middle.x;
  keep_volume(enclosed(loops, old.axisymmetric), fresh, start);
  return start;
}

} // namespace

std::vector<std::vector<BoundaryArc>> boundary_loops(const Mesh<2>& mesh, const Eigen::VectorXd& u) {
  std::map<std::pair<int, int>, int> elements; // of every edge
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int v = 0; v < 3; ++v) {
      const int a = mesh.element(e)[v], b = mesh.element(e)[(v + 1) % 3];
      ++elements[std::minmax(a, b)];
    }
  const auto place = [&](int node) { return Vector<2>(mesh.node(node) + u.segment<2>(2 * node)); };
  std::map<int, BoundaryArc> from; // by the vertex that it begins at
  for (const Facet<2>& facet : mesh.facets) {
    const int a = facet.vertex[0], b = facet.vertex[1], m = facet.middle[0];
    if (elements[std::minmax(a, b)] != 1) continue;
    const Vector<2> middle = m >= 0 ? place(m) : Vector<2>(0.5 * (place(a) + place(b)));
    from[a] = {{place(a), middle, place(b)}, {a, b}, facet.label, (mesh.node(b) - mesh.node(a)).norm()};
  }
  std::vector<std::vector<BoundaryArc>> loops;
  while (!from.empty()) {
    loops.emplace_back();
    for (auto at = from.begin(); at != from.end(); at = from.find(loops.back().back().vertex[1])) {
      loops.back().push_back(at->second);
      from.erase(at);
    }
  }
  return loops;
}

std::vector<OutlineEdge> outline(const Mesh<2>& mesh, const Eigen::VectorXd& u, double size) {
  require(size >= 0 && std::isfinite(size), "outline", "size", size, ">= 0, 0: that of the mesh");
  std::vector<OutlineEdge> edges;
  for (std::vector<BoundaryArc>& loop : boundary_loops(mesh, u)) {
    std::size_t first = 0; // of a section
    while (first < loop.size() && !turns(loop[(first + loop.size() - 1) % loop.size()], loop[first])) ++first;
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first % loop.size()), loop.end());
    std::vector<BoundaryArc> section;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      section.push_back(loop[i]);
      if (i + 1 < loop.size() && !turns(loop[i], loop[i + 1])) continue;
      divide(section, size, edges);
      section.clear();
    }
  }
  return edges;
}

template <int Dim>
Eigen::VectorXd boundary_displacement(const Mesh<Dim>& old, const Eigen::VectorXd& u, const Mesh<Dim>& fresh,
                                      const std::vector<char>& fixed) {
  Eigen::VectorXd start = displacement(old, u, fresh);
  for (std::size_t d = 0; d < fixed.size(); ++d)
    if (fixed[d]) start[static_cast<Eigen::Index>(d)] = 0;
  return start;
}

template Eigen::VectorXd boundary_displacement<2>(const Mesh<2>&, const Eigen::VectorXd&, const Mesh<2>&,
                                                  const std::vector<char>&);
template Eigen::VectorXd boundary_displacement<3>(const Mesh<3>&, const Eigen::VectorXd&, const Mesh<3>&,
                                                  const std::vector<char>&);

} // namespace burnish
