#pragma once
// Nearest points of a set, in a time that grows with the logarithm of its size (k-d tree of nanoflann).
#include "base/types.hpp"
#include <memory>
#include <vector>

namespace burnish {

template <int Dim> class PointTree {
public:
  explicit PointTree(std::vector<Vector<Dim>> points);
  ~PointTree();
  PointTree(PointTree&&) noexcept;
  PointTree& operator=(PointTree&&) noexcept;
  bool empty() const;
  /// The nearest point, the one of the smallest index where several are equally near.
  /// @param except this point does not count; -1: all do
  /// @returns its index and the squared distance [length^2]; index -1 if there is none
  struct Nearest {
    int index;
    double squared_distance;
  };
  Nearest nearest(const Vector<Dim>& p, int except = -1) const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

/// Distance of the two points of a set that are furthest apart; 0 for fewer than two [length].
template <int Dim> double diameter(const std::vector<Vector<Dim>>& points);

} // namespace burnish
