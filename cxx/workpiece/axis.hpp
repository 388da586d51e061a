#pragma once
// The nodes on the axis of an axisymmetric mesh: they must not leave it.
#include "mesh/mesh.hpp"

namespace burnish {

template <int Dim> class AxisNodes {
public:
  /// None unless the mesh is axisymmetric.
  explicit AxisNodes(const Mesh<Dim>& mesh);
  /// @throws std::invalid_argument "where: ..." where u_r of such a node is not 0 but for rounding (names it)
  void check(const Eigen::VectorXd& displacement, const char* where) const;

private:
  std::vector<int> m_nodes;
  double m_rounding = 0; // of coordinates [length]
};

} // namespace burnish
