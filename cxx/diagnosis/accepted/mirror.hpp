#pragma once
// Whether a displacement is its own mirror image about the middle of the body (ALGORITHMS.md 17).
#include "mesh/mesh_locator.hpp"

namespace burnish {

template <int Dim> class Mirror {
public:
  /// About the middle of the body's extent along one axis.
  /// @param locator of the mesh, used here only
  Mirror(const Mesh<Dim>& mesh, const MeshLocator<Dim>& locator, int axis);
  /// Every sampled node has its image in the mesh.
  bool possible() const { return m_possible; }
  /// Largest difference of mirrored displacements over the largest displacement of the samples; 0 if nothing moves.
  /// @param u num_dofs [length]
  double deviation(const Eigen::VectorXd& u) const;

private:
  struct Sample {
    int node = -1;
    const int* image = nullptr; // nodes of the element that holds the image
    std::vector<double> shape;  // there
  };
  int m_axis;
  bool m_possible = true;
  std::vector<Sample> m_samples;
};

/// Middle of the mesh along an axis, and its size along the longest one [length].
template <int Dim> double middle_of(const Mesh<Dim>& mesh, int axis);
template <int Dim> double size_of(const Mesh<Dim>& mesh);

} // namespace burnish
