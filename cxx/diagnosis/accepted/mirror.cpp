#include "diagnosis/accepted/mirror.hpp"
#include "mesh/point_tree.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr int SAMPLES = 100;     // nodes that are compared with their images
constexpr double OUTSIDE = 0.05; // an image may lie out of the mesh, in barycentric coordinates: curved sides

template <int Dim> std::array<double, 2> extent(const Mesh<Dim>& mesh, int axis) {
  std::array<double, 2> ends{mesh.X[axis], mesh.X[axis]};
  for (int a = 0; a < mesh.num_nodes; ++a) {
    ends[0] = std::min(ends[0], mesh.node(a)[axis]);
    ends[1] = std::max(ends[1], mesh.node(a)[axis]);
  }
  return ends;
}

} // namespace

template <int Dim> double middle_of(const Mesh<Dim>& mesh, int axis) {
  const auto ends = extent(mesh, axis);
  return 0.5 * (ends[0] + ends[1]);
}

template <int Dim> double size_of(const Mesh<Dim>& mesh) {
  double size = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const auto ends = extent(mesh, axis);
    size = std::max(size, ends[1] - ends[0]);
  }
  return size;
}

template <int Dim>
Mirror<Dim>::Mirror(const Mesh<Dim>& mesh, const MeshLocator<Dim>& locator, int axis) : m_axis(axis) {
  std::vector<Vector<Dim>> places;
  for (int a = 0; a < mesh.num_nodes; ++a) places.push_back(mesh.node(a));
  const double middle = middle_of(mesh, axis);
  const PointTree<Dim> tree(places);
  const int every = std::max(1, mesh.num_nodes / SAMPLES);
  for (int a = 0; a < mesh.num_nodes && m_possible; a += every) {
    Vector<Dim> image = places[a];
    image[axis] = 2 * middle - image[axis];
    const int element = locator.find(image, tree.nearest(image).index, OUTSIDE);
    m_possible = element >= 0;
    if (!m_possible) break;
    Sample sample{a, mesh.element(element), std::vector<double>(mesh.nodes_per_element)};
    locator.shape(element, image, sample.shape.data());
    m_samples.push_back(std::move(sample));
  }
}

template <int Dim> double Mirror<Dim>::deviation(const Eigen::VectorXd& u) const {
  double largest = 0, difference = 0;
  for (const Sample& sample : m_samples) {
    Vector<Dim> here = u.segment<Dim>(Dim * sample.node), there = Vector<Dim>::Zero();
    for (std::size_t b = 0; b < sample.shape.size(); ++b)
      there += sample.shape[b] * u.segment<Dim>(Dim * sample.image[b]);
    largest = std::max({largest, here.norm(), there.norm()});
    there[m_axis] = -there[m_axis];
    difference = std::max(difference, (here - there).norm());
  }
  return largest > 0 ? difference / largest : 0;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template class Mirror<Dim>;                                                                                \
  template double middle_of<Dim>(const Mesh<Dim>&, int);                                                     \
  template double size_of<Dim>(const Mesh<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
