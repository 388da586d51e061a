#include "mesh/point_tree.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

namespace burnish {

template <int Dim> struct PointTree<Dim>::Impl {
  struct Cloud {
    std::vector<Vector<Dim>> points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t component) const { return points[i][component]; }
    template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
  };
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, Dim>;

  Cloud cloud;
  Tree tree;
  explicit Impl(std::vector<Vector<Dim>> points)
      : cloud{std::move(points)}, tree(Dim, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10)) {}
};

template <int Dim>
PointTree<Dim>::PointTree(std::vector<Vector<Dim>> points)
    : m_impl(std::make_unique<Impl>(std::move(points))) {
  if (!empty()) m_impl->tree.buildIndex();
}
template <int Dim> PointTree<Dim>::~PointTree() = default;
template <int Dim> PointTree<Dim>::PointTree(PointTree&&) noexcept = default;
template <int Dim> PointTree<Dim>& PointTree<Dim>::operator=(PointTree&&) noexcept = default;

template <int Dim> bool PointTree<Dim>::empty() const { return m_impl->cloud.points.empty(); }

namespace {

// What nanoflann asks of a set of results: here the first of all that are equally near.
template <class Nearest> struct FirstNearest {
  int except;
  Nearest best{-1, std::numeric_limits<double>::infinity()};

  bool addPoint(double squared, std::uint32_t point) {
    const int i = static_cast<int>(point);
    const bool before = squared == best.squared_distance && i < best.index;
    if (i != except && (squared < best.squared_distance || before)) best = {i, squared};
    return true; // go on
  }
  // Points below it are offered: those as near as the best one too, in spite of rounding in the tree.
  double worstDist() const {
    constexpr double rounding = 1e-14;
    return std::max((1 + rounding) * best.squared_distance, std::numeric_limits<double>::min());
  }
  bool full() const { return best.index >= 0; }
};

} // namespace

template <int Dim>
typename PointTree<Dim>::Nearest PointTree<Dim>::nearest(const Vector<Dim>& p, int except) const {
  FirstNearest<Nearest> result{except};
  if (!empty()) m_impl->tree.findNeighbors(result, p.data(), {});
  return result.best;
}

// The two ends are far from the middle: points by their distance from it, until no pair can be further apart.
template <int Dim> double diameter(const std::vector<Vector<Dim>>& points) {
  if (points.size() < 2) return 0;
  Vector<Dim> low = points[0], high = points[0];
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector<Dim> middle = 0.5 * (low + high);
  std::vector<std::pair<double, const Vector<Dim>*>> far;
  for (const auto& p : points) far.emplace_back((p - middle).norm(), &p);
  std::sort(far.begin(), far.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  double largest = 0;
  for (std::size_t i = 0; i + 1 < far.size(); ++i)
    for (std::size_t j = i + 1; j < far.size(); ++j) {
      if (far[i].first + far[j].first <= largest) {
        if (j == i + 1) return largest;
        break;
      }
      largest = std::max(largest, (*far[i].second - *far[j].second).norm());
    }
  return largest;
}

template class PointTree<2>;
template class PointTree<3>;
template double diameter<2>(const std::vector<Vector<2>>&);
template double diameter<3>(const std::vector<Vector<3>>&);

} // namespace burnish
