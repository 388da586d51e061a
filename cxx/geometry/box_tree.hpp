#pragma once
// Boxes in a binary tree: which of many parts of a surface can be nearest to a point.
#include "base/types.hpp"
#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace burnish {

class BoxTree {
public:
  BoxTree() = default;
  /// @param boxes none empty, all finite [length]
  explicit BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// Calls visit(i) for every box i no further from p than `reach`, near ones first; visit may make `reach` smaller.
  /// @param p finite [length]
  template <class Visit> void near(const Vector<3>& p, double& reach, const Visit& visit) const {
    if (m_nodes.empty()) return;
    std::array<std::pair<int, double>, 64> waiting; // of a tree of halves: deeper than any
    int count = 0;
    waiting[0] = {0, m_nodes[0].box.exteriorDistance(p)};
    for (count = 1; count > 0;) {
      const auto [at, distance] = waiting[static_cast<std::size_t>(--count)];
      if (distance > reach) continue;
      const Node& node = m_nodes[static_cast<std::size_t>(at)];
      if (node.item >= 0) {
        visit(node.item);
        continue;
      }
      std::pair<int, double> a(node.first, box(node.first).exteriorDistance(p)),
          b(node.second, box(node.second).exteriorDistance(p));
      if (a.second < b.second) std::swap(a, b);
      waiting[static_cast<std::size_t>(count++)] = a;
      waiting[static_cast<std::size_t>(count++)] = b; // the nearer one is looked at first
    }
  }
  /// About all boxes; empty if there are none.
  Eigen::AlignedBox3d box() const { return m_nodes.empty() ? Eigen::AlignedBox3d() : m_nodes[0].box; }

private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = -1, second = -1, item = -1; ///< two nodes, or a box
  };
  const Eigen::AlignedBox3d& box(int node) const { return m_nodes[static_cast<std::size_t>(node)].box; }
  int add(const std::vector<Eigen::AlignedBox3d>& boxes, std::vector<int>& items, std::size_t begin,
          std::size_t end);

  std::vector<Node> m_nodes;
};

} // namespace burnish
