#pragma once
// How the material at each node turns: what carries the last increment along (ALGORITHMS.md 4).
#include "contact/body_view.hpp"
#include "mesh/mesh.hpp"
#include <vector>

namespace burnish {

/// Rotation of the polar decomposition G = R U, by a part of its angle: 1 for R, 0.5 for its half. det G > 0.
Tensor<2> part_of_rotation(const Tensor<2>& G, double part);
Tensor<3> part_of_rotation(const Tensor<3>& G, double part);

/// The rotation in the middle of two rotations.
Tensor<2> mean_rotation(const Tensor<2>& a, const Tensor<2>& b);
Tensor<3> mean_rotation(const Tensor<3>& a, const Tensor<3>& b);

/// Per node the mean of its elements, both of straight edges; the identity at a node without elements.
template <int Dim> struct NodalGradients {
  std::vector<Tensor<Dim>> F;    ///< deformation gradient dx/dX
  std::vector<Tensor<Dim>> step; ///< that of the last increment, from where the nodes stood before it
};

/// @param u, du displacement and its last increment, Dim*num_nodes [length]
template <int Dim>
NodalGradients<Dim> nodal_gradients(const Mesh<Dim>& mesh, const BodyView<Dim>& body,
                                    const Eigen::VectorXd& u, const Eigen::VectorXd& du);

} // namespace burnish
