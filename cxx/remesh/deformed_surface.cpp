#include "remesh/deformed_surface.hpp"
#include "mesh/facet_measure.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace burnish {
namespace {

constexpr int SWEEPS = 30;      // over the patches that meet in a place
constexpr double MEETS = 1e-14; // of the body: how near to all of them it is at last

using Edge = std::pair<int, int>; // its vertices, the smaller one first
using Side = std::pair<int, int>; // a face, and which of its edges
using Triple = std::array<int, 3>;

Triple sorted(Triple v) {
  std::sort(v.begin(), v.end());
  return v;
}

Edge edge_of(const BoundaryFace& face, int i) {
  const auto [a, b] = SimplexEdges<2>::ends[i];
  return std::minmax(face.facet.vertex[a], face.facet.vertex[b]);
}
Vector<3> normal_at(const BoundaryFace& face, int i) {
  Barycentric<2> l = Barycentric<2>::Zero();
  for (const int v : SimplexEdges<2>::ends[i]) l[v] = 0.5;
  const auto T = triangle_tangents(face.x, l);
  return T.col(0).cross(T.col(1)).normalized();
}
Vector<3> center(const BoundaryFace& face) { return place_on(face.x, Barycentric<2>::Constant(1. / 3)); }

// Both sides of every edge between two faces.
std::vector<std::pair<Side, Side>> neighbors(const std::vector<BoundaryFace>& faces) {
  std::map<Edge, std::vector<Side>> sides;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) sides[edge_of(faces[f], i)].emplace_back(f, i);
  std::vector<std::pair<Side, Side>> pairs;
  for (const auto& [edge, of] : sides)
    if (of.size() == 2) pairs.emplace_back(of[0], of[1]);
  return pairs;
}

// Number of the set that each is in, and how many there are.
int sets_of(const std::vector<std::pair<int, int>>& pairs, std::vector<int>& set) {
  std::iota(set.begin(), set.end(), 0);
  const auto root = [&](int i) {
    while (set[i] != i) i = set[i] = set[set[i]];
    return i;
  };
  for (const auto& [a, b] : pairs) set[std::max(root(a), root(b))] = std::min(root(a), root(b));
  int number = 0;
  for (std::size_t i = 0; i < set.size(); ++i) // the first of a set comes before the others
    set[i] = set[i] == static_cast<int>(i) ? -1 - number++ : set[set[i]];
  for (int& s : set) s = -1 - s;
  return number;
}

// Half of its patch that a face of a closed surface is in, beyond the middle along its longest extent or not; 0 of others.
std::vector<char> halves(const std::vector<BoundaryFace>& faces, const std::vector<int>& patch,
                         const std::vector<char>& closed) {
  std::vector<Eigen::AlignedBox3d> box(closed.size());
  for (std::size_t f = 0; f < faces.size(); ++f) box[patch[f]].extend(center(faces[f]));
  std::vector<char> half(faces.size(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!closed[patch[f]]) continue;
    int along = 0;
    box[patch[f]].sizes().maxCoeff(&along);
    half[f] = center(faces[f])[along] > box[patch[f]].center()[along];
  }
  return half;
}

// Patches of the faces; their number.
int divide(std::vector<BoundaryFace>& faces, double turn) {
  const auto edges = neighbors(faces);
  std::vector<std::pair<int, int>> joined;
  for (const auto& [a, b] : edges) {
    const BoundaryFace &one = faces[a.first], &other = faces[b.first];
    const double cosine = normal_at(one, a.second).dot(normal_at(other, b.second));
    if (one.facet.label == other.facet.label && cosine > std::cos(turn))
      joined.emplace_back(a.first, b.first);
  }
  std::vector<int> patch(faces.size());
  std::vector<char> closed(sets_of(joined, patch), 1);
  for (const auto& [a, b] : edges)
    if (patch[a.first] != patch[b.first]) closed[patch[a.first]] = closed[patch[b.first]] = 0;
  const std::vector<char> half = halves(faces, patch, closed);
  std::vector<std::pair<int, int>> within;
  for (const auto& [a, b] : joined)
    if (half[a] == half[b]) within.emplace_back(a, b);
  const int number = sets_of(within, patch);
  for (std::size_t f = 0; f < faces.size(); ++f) faces[f].patch = patch[f];
  return number;
}

} // namespace

std::vector<BoundaryFace> boundary_faces(const Mesh<3>& mesh, const Eigen::VectorXd& u) {
  std::map<Triple, long> label;
  for (const Facet<3>& facet : mesh.facets) label[sorted(facet.vertex)] = facet.label;
  std::map<Triple, BoundaryFace> found;
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int f = 0; f < 4; ++f) {
      BoundaryFace face;
      face.facet = facet_opposite<3>(mesh.element(e), mesh.nodes_per_element > 4, f);
      const Triple key = sorted(face.facet.vertex);
      if (found.erase(key) > 0) continue; // between two elements
      face.facet.element = e;
      const auto named = label.find(key);
      face.facet.label = named == label.end() ? 0 : named->second;
      for (const int node : nodes_of(face.facet)) face.x.push_back(mesh.node(node) + u.segment<3>(3 * node));
      found.emplace(key, std::move(face));
    }
  std::vector<BoundaryFace> faces;
  for (auto& [key, face] : found) faces.push_back(std::move(face));
  return faces;
}

DeformedSurface::DeformedSurface(const Mesh<3>& mesh, const Eigen::VectorXd& u, double turn)
    : m_faces(boundary_faces(mesh, u)) {
  m_patches.resize(divide(m_faces, turn));
  std::map<Edge, std::vector<int>> of; // patch and vertex
  for (std::size_t f = 0; f < m_faces.size(); ++f)
    for (const int v : m_faces[f].facet.vertex) of[{m_faces[f].patch, v}].push_back(static_cast<int>(f));
  for (const BoundaryFace& face : m_faces) {
    std::set<int> around;
    for (const int v : face.facet.vertex)
      around.insert(of[{face.patch, v}].begin(), of[{face.patch, v}].end());
    m_around.emplace_back(around.begin(), around.end());
  }
  Eigen::AlignedBox3d box;
  for (const BoundaryFace& face : m_faces) box.extend(face.x[0]);
  m_extent = box.diagonal().norm();
  take_samples();
}

void DeformedSurface::take_samples() {
  std::vector<std::vector<Vector<3>>> places(m_patches.size());
  for (std::size_t f = 0; f < m_faces.size(); ++f) {
    const BoundaryFace& face = m_faces[f];
    m_patches[face.patch].label = face.facet.label;
    std::vector<Vector<3>> samples = face.x;
    for (const auto& part : linear_parts<2>(static_cast<int>(face.x.size())))
      samples.emplace_back((face.x[part[0]] + face.x[part[1]] + face.x[part[2]]) / 3);
    for (const Vector<3>& x : samples) {
      places[face.patch].push_back(x);
      m_patches[face.patch].face_of.push_back(static_cast<int>(f));
    }
  }
  for (std::size_t p = 0; p < m_patches.size(); ++p)
    m_patches[p].samples = PointTree<3>(std::move(places[p]));
}

double DeformedSurface::volume() const {
  double sum = 0;
  for (const BoundaryFace& face : m_faces) sum += volume_behind(face.x);
  return sum;
}

std::pair<Vector<3>, double> DeformedSurface::nearest(const Vector<3>& x, int patch) const {
  const Patch& of = m_patches[patch];
  const int face = of.face_of[of.samples.nearest(x).index];
  auto best = nearest_on(m_faces[face].x, x);
  for (const int other : m_around[face]) {
    const auto found = nearest_on(m_faces[other].x, x);
    if (found.second < best.second) best = found;
  }
  return best;
}

int DeformedSurface::nearest_patch(const Vector<3>& x, long label) const {
  int best = -1;
  double least = 0;
  for (int p = 0; p < num_patches(); ++p) {
    if (m_patches[p].label != label) continue;
    const double squared = nearest(x, p).second;
    if (best < 0 || squared < least) best = p, least = squared;
  }
  return best;
}

Vector<3> DeformedSurface::common_place(Vector<3> x, const std::set<int>& patches) const {
  const int sweeps = patches.size() > 1 ? SWEEPS : 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const Vector<3> before = x;
    for (const int patch : patches) x = nearest(x, patch).first;
    if ((x - before).norm() < MEETS * m_extent) break;
  }
  return x;
}

} // namespace burnish
