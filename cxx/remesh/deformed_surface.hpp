#pragma once
// The surface of a deformed workpiece of tetrahedra: its faces in patches, and places on them (ALGORITHMS.md 19.2).
#include "mesh/mesh.hpp"
#include "mesh/point_tree.hpp"
#include "remesh/boundary_face.hpp"
#include "remesh/deformed_boundary.hpp"
#include <set>

namespace burnish {

/// A face of one element only, where it is now.
struct BoundaryFace {
  Facet<3> facet; ///< counter-clockwise seen from outside; label 0 where the mesh lists none
  FaceNodes x;
  int patch = 0;
};
std::vector<BoundaryFace> boundary_faces(const Mesh<3>& mesh, const Eigen::VectorXd& u);

/// A patch ends where the label changes and where the surface turns sharply. A closed one is cut in two.
class DeformedSurface {
public:
  /// @param u displacement, num_dofs [length]; @param turn from which an edge ends a patch [rad]
  DeformedSurface(const Mesh<3>& mesh, const Eigen::VectorXd& u, double turn = SHARP_TURN);
  const std::vector<BoundaryFace>& faces() const { return m_faces; }
  int num_patches() const { return static_cast<int>(m_patches.size()); }
  long label(int patch) const { return m_patches[patch].label; }
  double volume() const; ///< enclosed [length^3]
  /// Its place on a patch nearest to x, and the squared distance [length^2].
  std::pair<Vector<3>, double> nearest(const Vector<3>& x, int patch) const;
  /// The patch of a label that is nearest to x; -1: no face bears the label.
  int nearest_patch(const Vector<3>& x, long label) const;
  /// Place near x that is on all of some patches: on one of them, on the line where two meet, at a corner.
  Vector<3> common_place(Vector<3> x, const std::set<int>& patches) const;

private:
  struct Patch {
    long label = 0;
    PointTree<3> samples{std::vector<Vector<3>>()};
    std::vector<int> face_of; // the samples
  };
  void take_samples();

  std::vector<BoundaryFace> m_faces;
  std::vector<std::vector<int>> m_around; // faces that share a vertex with a face and are of its patch
  std::vector<Patch> m_patches;
  double m_extent = 0;
};

/// Displacement that takes the boundary of a new mesh to the surface of the old one, its vertices and mid nodes; mid nodes of
/// curved edges inside a patch a little further or less so that the volume is that of the old one. Zero where no face of the
/// same label is within a quarter of an edge, and of linear elements.
/// @param u of the old mesh, num_dofs [length]; @returns num_dofs of the new one [length]
Eigen::VectorXd surface_displacement(const Mesh<3>& old, const Eigen::VectorXd& u, const Mesh<3>& fresh);

} // namespace burnish
