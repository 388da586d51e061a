#include "iteration/nodal_gradients.hpp"
#include <cmath>

namespace burnish {

Tensor<2> part_of_rotation(const Tensor<2>& G, double part) {
  return Eigen::Rotation2D<double>(part * std::atan2(G(1, 0) - G(0, 1), G(0, 0) + G(1, 1)))
      .toRotationMatrix();
}
Tensor<3> part_of_rotation(const Tensor<3>& G, double part) {
  const Eigen::JacobiSVD<Tensor<3>> svd(G, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::AngleAxisd turn(Tensor<3>(svd.matrixU() * svd.matrixV().transpose()));
  return Eigen::AngleAxisd(part * turn.angle(), turn.axis()).toRotationMatrix();
}

Tensor<2> mean_rotation(const Tensor<2>& a, const Tensor<2>& b) {
  Tensor<2> mean = 0.5 * (a + b);
  for (int c = 0; c < 2; ++c) mean.col(c).normalize();
  return mean;
}
Tensor<3> mean_rotation(const Tensor<3>& a, const Tensor<3>& b) {
  return part_of_rotation(Tensor<3>(a + b), 1);
}

template <int Dim>
NodalGradients<Dim> nodal_gradients(const Mesh<Dim>& mesh, const BodyView<Dim>& body,
                                    const Eigen::VectorXd& u, const Eigen::VectorXd& du) {
  const auto nodes = static_cast<std::size_t>(mesh.num_nodes);
  NodalGradients<Dim> sum{std::vector<Tensor<Dim>>(nodes, Tensor<Dim>::Zero()),
                          std::vector<Tensor<Dim>>(nodes, Tensor<Dim>::Zero())};
  std::vector<int> elements(nodes, 0);
  for (int e = 0; e < mesh.num_elements; ++e) {
    const int* n = mesh.element(e);
    Tensor<Dim> now, old, reference;
    for (int c = 0; c < Dim; ++c) {
      now.col(c) = body.position(u, n[c + 1]) - body.position(u, n[0]);
      old.col(c) = now.col(c) - (du.segment<Dim>(Dim * n[c + 1]) - du.segment<Dim>(Dim * n[0]));
      reference.col(c) = mesh.node(n[c + 1]) - mesh.node(n[0]);
    }
    const Tensor<Dim> F = now * reference.inverse(), step = now * old.inverse();
    for (int a = 0; a < mesh.nodes_per_element; ++a) {
      sum.F[n[a]] += F;
      sum.step[n[a]] += step;
      ++elements[n[a]];
    }
  }
  for (std::size_t a = 0; a < nodes; ++a)
    if (elements[a] > 0) {
      sum.F[a] /= elements[a];
      sum.step[a] /= elements[a];
    } else {
      sum.F[a] = sum.step[a] = Tensor<Dim>::Identity();
    }
  return sum;
}

template NodalGradients<2> nodal_gradients<2>(const Mesh<2>&, const BodyView<2>&, const Eigen::VectorXd&,
                                              const Eigen::VectorXd&);
template NodalGradients<3> nodal_gradients<3>(const Mesh<3>&, const BodyView<3>&, const Eigen::VectorXd&,
                                              const Eigen::VectorXd&);

} // namespace burnish
