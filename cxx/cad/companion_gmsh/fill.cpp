// A closed surface of triangles, meshed anew and filled with tetrahedra.
#include "cad/companion_gmsh/burnish_gmsh.h"
#include "cad/companion_gmsh/session.hpp"
#include <algorithm>
#include <cstdio>
#include <gmsh.h>
#include <map>
#include <vector>

using namespace burnish_gmsh;

namespace {

using Tags = std::vector<std::size_t>;

constexpr int OPTIMIZATIONS = 3; // of the tetrahedra, after gmsh's own

std::size_t tag(int node) { return static_cast<std::size_t>(node + 1); }

/// Entities of gmsh that get their nodes: corners, lines, patches, each node once.
class Patches {
public:
  explicit Patches(const burnish_gmsh_body& body) : m_body(body), m_placed(body.nodes, false) {
    for (int l = 0; l < body.lines; ++l) {
      add_corner(body.line[body.line_start[l]]);
      add_corner(body.line[body.line_start[l + 1] - 1]);
    }
    for (int l = 0; l < body.lines; ++l) add_line(l);
    for (int patch = 0; patch <= *std::max_element(body.patch, body.patch + body.triangles); ++patch)
      add_patch(patch);
  }

private:
  void place(int dimension, int entity, const std::vector<int>& nodes) {
    Tags tags;
    std::vector<double> x;
    for (const int node : nodes) {
      if (m_placed[node]) continue;
      m_placed[node] = true;
      tags.push_back(tag(node));
      x.insert(x.end(), m_body.x + 3 * node, m_body.x + 3 * node + 3);
    }
    gmsh::model::mesh::addNodes(dimension, entity, tags, x);
  }
  void add_corner(int node) {
    if (m_corner.count(node) > 0) return;
    const int entity = static_cast<int>(m_corner.size()) + 1;
    m_corner[node] = entity;
    gmsh::model::addDiscreteEntity(0, entity);
    place(0, entity, {node});
    gmsh::model::mesh::addElementsByType(entity, 15, {}, {tag(node)});
  }
  void add_line(int line) {
    const int *first = m_body.line + m_body.line_start[line],
              *last = m_body.line + m_body.line_start[line + 1] - 1;
    gmsh::model::addDiscreteEntity(1, line + 1, {m_corner[*first], m_corner[*last]});
    place(1, line + 1, std::vector<int>(first + 1, last));
    Tags ends;
    for (const int* node = first; node < last; ++node) ends.insert(ends.end(), {tag(node[0]), tag(node[1])});
    gmsh::model::mesh::addElementsByType(line + 1, 1, {}, ends);
  }
  void add_patch(int patch) {
    std::vector<int> lines, nodes;
    for (int k = 0; k < 2 * m_body.lines; ++k)
      if (m_body.line_patches[k] == patch) lines.push_back(k / 2 + 1);
    for (int t = 0; t < m_body.triangles; ++t)
      if (m_body.patch[t] == patch)
        nodes.insert(nodes.end(), m_body.triangle + 3 * t, m_body.triangle + 3 * t + 3);
    gmsh::model::addDiscreteEntity(2, patch + 1, lines);
    place(2, patch + 1, nodes);
    Tags corners;
    for (const int node : nodes) corners.push_back(tag(node));
    gmsh::model::mesh::addElementsByType(patch + 1, 2, {}, corners);
  }

  const burnish_gmsh_body& m_body;
  std::vector<bool> m_placed;
  std::map<int, int> m_corner; // entities
};

void add_volume() {
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  std::vector<int> shell;
  for (const auto& surface : surfaces) shell.push_back(surface.second);
  gmsh::model::geo::addVolume({gmsh::model::geo::addSurfaceLoop(shell)});
  gmsh::model::geo::synchronize();
}

// Lengths of edges by a field that is linear in tetrahedra of the present body.
void set_sizes(const burnish_gmsh_body& body) {
  double longest = 0;
  for (int e = 0; e < body.tetrahedra; ++e)
    for (int v = 12; v < 16; ++v) longest = std::max(longest, body.size[16 * e + v]);
  const int view = gmsh::view::add("size");
  gmsh::view::addListData(view, "SS", body.tetrahedra,
                          std::vector<double>(body.size, body.size + 16 * body.tetrahedra));
  const int field = gmsh::model::mesh::field::add("PostView");
  gmsh::model::mesh::field::setNumber(field, "IView", gmsh::view::getIndex(view));
  gmsh::model::mesh::field::setAsBackgroundMesh(field);
  for (const char* other : {"MeshSizeExtendFromBoundary", "MeshSizeFromPoints", "MeshSizeFromCurvature"})
    gmsh::option::setNumber(std::string("Mesh.") + other, 0);
  gmsh::option::setNumber("Mesh.MeshSizeMax", longest);
  gmsh::option::setNumber("Mesh.OptimizeThreshold", 0.5);
}

/// The mesh with its nodes numbered from 0: those that are no corner of a tetrahedron are left out.
class Result {
public:
  Result() {
    for (const std::size_t node : corners(4, -1)) m_tetrahedra.push_back(number_of(node));
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    for (const auto& surface : surfaces) {
      for (const std::size_t node : corners(2, surface.second)) m_triangles.push_back(number_of(node));
      m_patch.resize(m_triangles.size() / 3, surface.second - 1);
    }
  }
  bool write(const char* file) const {
    std::FILE* out = std::fopen(file, "w");
    if (!out) return false;
    std::fprintf(out, "%zu %zu %zu\n", m_node.size(), m_tetrahedra.size() / 4, m_patch.size());
    for (const std::size_t node : m_node) {
      std::vector<double> x, none;
      gmsh::model::mesh::getNode(node, x, none);
      std::fprintf(out, "%.17g %.17g %.17g\n", x[0], x[1], x[2]);
    }
    for (std::size_t k = 0; k < m_tetrahedra.size(); ++k)
      std::fprintf(out, "%d%c", m_tetrahedra[k], k % 4 == 3 ? '\n' : ' ');
    for (std::size_t t = 0; t < m_patch.size(); ++t)
      std::fprintf(out, "%d %d %d %d\n", m_triangles[3 * t], m_triangles[3 * t + 1], m_triangles[3 * t + 2],
                   m_patch[t]);
    return std::fclose(out) == 0;
  }

private:
  static Tags corners(int type, int entity) {
    Tags elements, nodes; // (what they hold is kept in front)
    gmsh::model::mesh::getElementsByType(type, elements, nodes, entity);
    return nodes;
  }
  int number_of(std::size_t node) {
    const auto [at, fresh] = m_number.emplace(node, static_cast<int>(m_node.size()));
    if (fresh) m_node.push_back(node);
    return at->second;
  }
  std::map<std::size_t, int> m_number;
  Tags m_node;
  std::vector<int> m_tetrahedra, m_triangles, m_patch;
};

} // namespace

const char* burnish_gmsh_fill(const burnish_gmsh_body* body, const char* result) {
  return without_exceptions([&]() -> std::string {
    start(true);
    // (gmsh's own createTopology takes an order of addresses: no two meshes are the same)
    Patches patches(*body);
    gmsh::model::mesh::createGeometry();
    add_volume();
    set_sizes(*body);
    gmsh::model::mesh::generate(3);
    // least shape in a block with a dent .07 without, .42 with them, of a barrel .36 at gmsh's threshold of .3, .55 at .5; HXT has
    // .42 and .40, but no two meshes of it are the same
    for (int pass = 0; pass < OPTIMIZATIONS; ++pass) gmsh::model::mesh::optimize("");
    if (!first_error().empty()) return last_lines();
    return Result().write(result) ? "" : "the mesh cannot be written: is the disk full?";
  });
}
