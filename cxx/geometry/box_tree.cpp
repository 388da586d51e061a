#include "geometry/box_tree.hpp"
#include <algorithm>
#include <numeric>

namespace burnish {

BoxTree::BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes) {
  std::vector<int> items(boxes.size());
  std::iota(items.begin(), items.end(), 0);
  if (!items.empty()) add(boxes, items, 0, items.size());
}

// Halves of equal number across the direction in which the centers are spread most.
int BoxTree::add(const std::vector<Eigen::AlignedBox3d>& boxes, std::vector<int>& items, std::size_t begin,
                 std::size_t end) {
  const int at = static_cast<int>(m_nodes.size());
  m_nodes.emplace_back();
  if (end - begin == 1) {
    m_nodes.back().item = items[begin];
    m_nodes.back().box = boxes[static_cast<std::size_t>(items[begin])];
    return at;
  }
  Eigen::AlignedBox3d centers;
  for (std::size_t i = begin; i < end; ++i)
    centers.extend(boxes[static_cast<std::size_t>(items[i])].center());
  Eigen::Index axis = 0;
  centers.sizes().maxCoeff(&axis);
  const std::size_t middle = (begin + end) / 2;
  using Step = std::vector<int>::difference_type;
  std::nth_element(items.begin() + static_cast<Step>(begin), items.begin() + static_cast<Step>(middle),
                   items.begin() + static_cast<Step>(end), [&](int a, int b) {
                     return boxes[static_cast<std::size_t>(a)].center()[axis] <
                            boxes[static_cast<std::size_t>(b)].center()[axis];
                   });
  const int first = add(boxes, items, begin, middle), second = add(boxes, items, middle, end);
  Node& node = m_nodes[static_cast<std::size_t>(at)];
  node.first = first;
  node.second = second;
  node.box = box(first).merged(box(second));
  return at;
}

} // namespace burnish
