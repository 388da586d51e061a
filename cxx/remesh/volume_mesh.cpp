#include "remesh/volume_mesh.hpp"
#include "base/error.hpp"
#include "base/temporary.hpp"
#include "cad/gmsh_library.hpp"
#include "parallel/first_rank.hpp"
#include "remesh/patch_lines.hpp"
#include <cmath>
#include <map>
#include <sstream>

namespace burnish {
namespace {

constexpr const char* WHERE = "a new mesh";
constexpr double MOST_TETRAHEDRA = 5e6; // tetrahedra

// Turns of the surface that end a patch, one after the other until gmsh can parametrize all of them: a patch of a crumpled dent
// may touch itself at a vertex [rad].
constexpr std::array<double, 3> TURNS{SHARP_TURN, 2 * SHARP_TURN, 3 * SHARP_TURN};

// Volume of the tetrahedron with edges of length 1.
const double UNIT = 1 / (6 * std::sqrt(2.));

Vector<3> corner(const Mesh<3>& mesh, const Eigen::VectorXd& u, int element, int v) {
  const int node = mesh.element(element)[v];
  return mesh.node(node) + u.segment<3>(3 * node);
}
double volume_of(const std::array<Vector<3>, 4>& x) {
  return (x[1] - x[0]).dot((x[2] - x[0]).cross(x[3] - x[0])) / 6;
}

/// The arrays that burnish_gmsh_body points at.
struct GmshArrays {
  std::vector<double> x, size;
  std::vector<int> triangle, patch, line, line_patches, line_start{0};
  burnish_gmsh_body body() const {
    burnish_gmsh_body body;
    body.x = x.data();
    body.nodes = static_cast<int>(x.size() / 3);
    body.triangle = triangle.data();
    body.patch = patch.data();
    body.triangles = static_cast<int>(patch.size());
    body.line = line.data();
    body.line_start = line_start.data();
    body.line_patches = line_patches.data();
    body.lines = static_cast<int>(line_start.size()) - 1;
    body.size = size.data();
    body.tetrahedra = static_cast<int>(size.size() / 16);
    return body;
  }
};

// Quadratic faces as four triangles, lines through mid nodes, too.
void add_surface(const DeformedSurface& surface, GmshArrays& arrays) {
  std::map<int, int> number;
  for (const BoundaryFace& face : surface.faces()) {
    const std::vector<int> nodes = nodes_of(face.facet);
    for (std::size_t a = 0; a < nodes.size(); ++a)
      if (number.emplace(nodes[a], static_cast<int>(number.size())).second)
        arrays.x.insert(arrays.x.end(), face.x[a].begin(), face.x[a].end());
    for (const auto& part : linear_parts<2>(static_cast<int>(nodes.size()))) {
      for (const int a : part) arrays.triangle.push_back(number[nodes[a]]);
      arrays.patch.push_back(face.patch);
    }
  }
  for (const PatchLine& line : patch_lines(surface)) {
    for (const int node : line.nodes) arrays.line.push_back(number[node]);
    arrays.line_start.push_back(static_cast<int>(arrays.line.size()));
    arrays.line_patches.insert(arrays.line_patches.end(), line.patches.begin(), line.patches.end());
  }
}

void add_sizes(const Mesh<3>& mesh, const Eigen::VectorXd& u, const CornerSizes& sizes, GmshArrays& arrays) {
  double number = 0;
  for (int e = 0; e < mesh.num_elements; ++e) {
    std::array<Vector<3>, 4> x;
    for (int v = 0; v < 4; ++v) {
      x[v] = corner(mesh, u, e, v);
      require(sizes(v, e) > 0 && std::isfinite(sizes(v, e)), WHERE, "length of edges", sizes(v, e), "> 0");
    }
    for (int i = 0; i < 3; ++i)
      for (int v = 0; v < 4; ++v) arrays.size.push_back(x[v][i]);
    for (int v = 0; v < 4; ++v) arrays.size.push_back(sizes(v, e));
    number += std::abs(volume_of(x)) / (UNIT * std::pow(sizes.col(e).mean(), 3));
  }
  require(number < MOST_TETRAHEDRA, WHERE, "number of tetrahedra that the lengths of edges make", number,
          "below 5e6");
}

// What gmsh writes, on all ranks that of the first; @param said what it says where it fails
std::string filled(const burnish_gmsh_body& body, std::string& said) {
  std::string text;
  on_first_rank([&] {
    const TemporaryFolder folder;
    const std::string result = folder.path() + "/mesh";
    said = gmsh_fill(body, result, folder.path() + "/log");
    if (said.empty()) text = file_content(result);
  });
  share_text(said);
  share_text(text);
  return text;
}

struct GmshMesh {
  VolumeMesh mesh;
  std::vector<int> patch; // of every face
};
GmshMesh read(const std::string& text) {
  std::istringstream in(text);
  GmshMesh read;
  std::size_t nodes = 0, elements = 0, faces = 0;
  in >> nodes >> elements >> faces;
  read.mesh.node.resize(nodes);
  read.mesh.tetrahedron.resize(elements);
  read.mesh.face.resize(faces);
  read.patch.resize(faces);
  for (Vector<3>& x : read.mesh.node) in >> x[0] >> x[1] >> x[2];
  for (auto& element : read.mesh.tetrahedron)
    for (int& node : element) in >> node;
  for (std::size_t f = 0; f < faces; ++f) {
    for (int& node : read.mesh.face[f]) in >> node;
    in >> read.patch[f];
  }
  if (!in || elements == 0) fail(WHERE, "gmsh has filled the body with no tetrahedra");
  return read;
}

void turn_inverted(VolumeMesh& mesh) {
  for (auto& element : mesh.tetrahedron) {
    std::array<Vector<3>, 4> x;
    for (int v = 0; v < 4; ++v) x[v] = mesh.node[element[v]];
    if (volume_of(x) < 0) std::swap(element[2], element[3]);
  }
}

// Labels of the faces; vertices of the surface where they belong.
VolumeMesh on_surface(const DeformedSurface& surface, GmshMesh found) {
  VolumeMesh& fresh = found.mesh;
  std::vector<std::set<int>> patches(fresh.node.size());
  for (std::size_t f = 0; f < fresh.face.size(); ++f) {
    fresh.label.push_back(surface.label(found.patch[f]));
    for (const int node : fresh.face[f]) patches[node].insert(found.patch[f]);
  }
  for (std::size_t a = 0; a < patches.size(); ++a)
    fresh.node[a] = surface.common_place(fresh.node[a], patches[a]);
  turn_inverted(fresh);
  return std::move(fresh);
}

// Those of equilateral elements as large as the reference mesh's around each vertex.
CornerSizes reference_sizes(const Mesh<3>& mesh) {
  std::vector<double> sum(mesh.num_nodes, 0), number = sum;
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int v = 0; v < 4; ++v) {
      sum[mesh.element(e)[v]] += std::cbrt(signed_size(mesh, e) / UNIT);
      ++number[mesh.element(e)[v]];
    }
  CornerSizes sizes(4, mesh.num_elements);
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int v = 0; v < 4; ++v) sizes(v, e) = sum[mesh.element(e)[v]] / number[mesh.element(e)[v]];
  return sizes;
}

} // namespace

VolumeMesh volume_mesh(const Mesh<3>& mesh, const Eigen::VectorXd& u, const CornerSizes& sizes) {
  std::string first;
  for (const double turn : TURNS) {
    const DeformedSurface surface(mesh, u, turn);
    GmshArrays arrays;
    add_surface(surface, arrays);
    add_sizes(mesh, u, sizes, arrays);
    std::string said;
    const std::string text = filled(arrays.body(), said);
    if (said.empty()) return on_surface(surface, read(text));
    if (first.empty()) first = said;
  }
  fail(WHERE, "gmsh failed on the deformed workpiece: " + first);
}

// gmsh's number of tetrahedra is .6 to 1.7 of what the lengths ask for.
VolumeMesh volume_mesh(const Mesh<3>& mesh, const Eigen::VectorXd& u) {
  const CornerSizes sizes = reference_sizes(mesh);
  double wanted = 0;
  for (int e = 0; e < mesh.num_elements; ++e)
    wanted += volume_of({corner(mesh, u, e, 0), corner(mesh, u, e, 1), corner(mesh, u, e, 2),
                         corner(mesh, u, e, 3)}) /
              signed_size(mesh, e);
  const double number = static_cast<double>(volume_mesh(mesh, u, sizes).tetrahedron.size());
  return volume_mesh(mesh, u, std::cbrt(number / wanted) * sizes);
}

} // namespace burnish
