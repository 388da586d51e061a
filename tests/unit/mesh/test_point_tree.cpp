// Nearest points of a set and its diameter against brute force, in the plane and in space.
#include "mesh/point_tree.hpp"
#include "unit/finite_difference.hpp"
#include <limits>
#include <random>

using namespace burnish;

namespace {

constexpr double INF = std::numeric_limits<double>::infinity();

enum class Kind { SCATTERED, LATTICE, DUPLICATES, LINE, ONE_PLACE };
constexpr Kind KINDS[] = {Kind::SCATTERED, Kind::LATTICE, Kind::DUPLICATES, Kind::LINE, Kind::ONE_PLACE};

template <int Dim> class PointTreeOf : public testing::Test {
public:
  using Points = std::vector<Vector<Dim>>;

  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(m_random); }
  int any(int n) { return static_cast<int>(m_random() % static_cast<unsigned>(n)); }
  Vector<Dim> anywhere() {
    Vector<Dim> p;
    for (int c = 0; c < Dim; ++c) p[c] = uniform();
    return p;
  }
  /// Whole numbers: sums and squares are exact, so that points can be equally near to the last bit.
  Vector<Dim> on_lattice() {
    Vector<Dim> p;
    for (int c = 0; c < Dim; ++c) p[c] = any(7) - 3;
    return p;
  }
  Points points(Kind kind, int n) {
    Points list;
    const Vector<Dim> place = anywhere(), along = anywhere();
    while (static_cast<int>(list.size()) < n)
      if (kind == Kind::SCATTERED)
        list.push_back(anywhere());
      else if (kind == Kind::LATTICE)
        list.push_back(on_lattice());
      else if (kind == Kind::DUPLICATES) // every place about four times
        list.push_back(list.empty() || any(4) == 0 ? anywhere() : list[any(static_cast<int>(list.size()))]);
      else if (kind == Kind::LINE)
        list.push_back(place + uniform() * along);
      else
        list.push_back(place);
    return list;
  }
  /// First of the nearest; -1 if there is none.
  static int nearest(const Points& list, const Vector<Dim>& p, int except) {
    int best = -1;
    double least = INF;
    for (int i = 0; i < static_cast<int>(list.size()); ++i)
      if (i != except && squared(list[i], p) < least) {
        best = i;
        least = squared(list[i], p);
      }
    return best;
  }
  static double squared(const Vector<Dim>& a, const Vector<Dim>& b) {
    double sum = 0;
    for (int c = 0; c < Dim; ++c) sum += (b[c] - a[c]) * (b[c] - a[c]);
    return sum;
  }
  static void check(const PointTree<Dim>& tree, const Points& list, const Vector<Dim>& p, int except) {
    const auto found = tree.nearest(p, except);
    const int expected = nearest(list, p, except);
    ASSERT_EQ(found.index, expected) << list.size() << " points, except " << except;
    EXPECT_EQ(found.squared_distance, expected < 0 ? INF : squared(list[expected], p));
  }
  static double widest(const Points& list) {
    double largest = 0;
    for (const auto& a : list)
      for (const auto& b : list) largest = std::max(largest, (a - b).norm());
    return largest;
  }

private:
  std::mt19937 m_random{5};
};

struct Plane : PointTreeOf<2> {};
struct Space : PointTreeOf<3> {};
template <class Dimension> struct PointTrees : Dimension {};
using Both = testing::Types<Plane, Space>;
TYPED_TEST_SUITE(PointTrees, Both);

} // namespace

TYPED_TEST(PointTrees, NearestAgainstBruteForce) {
  for (const Kind kind : KINDS)
    for (const int n : {1, 2, 3, 5, 6, 7, 11, 40, 300, 2000}) {
      SCOPED_TRACE("kind " + std::to_string(static_cast<int>(kind)));
      const auto list = this->points(kind, n);
      const PointTree tree(list);
      ASSERT_FALSE(tree.empty());
      for (int trial = 0; trial < 60; ++trial) {
        const int i = this->any(n);
        this->check(tree, list, 1.5 * this->anywhere(), -1);
        this->check(tree, list, 0.5 * this->on_lattice(), trial % 2 ? i : -1);
        this->check(tree, list, list[i], -1); // the first of those at this place
        this->check(tree, list, list[i], i);
      }
    }
}

// More points at one distance than any fixed number of neighbors: the corners of a cube from its middle, ten
// points in one place.
TYPED_TEST(PointTrees, OfManyEquallyNearTheFirst) {
  using Points = decltype(this->points(Kind::LINE, 1));
  Points cube;
  auto corner = this->anywhere();
  const int dimensions = static_cast<int>(corner.size());
  for (int k = (1 << dimensions) - 1; k >= 0; --k) {
    for (int c = 0; c < dimensions; ++c) corner[c] = (k >> c) % 2;
    cube.push_back(corner);
  }
  corner.setConstant(0.5);
  this->check(PointTree(cube), cube, corner, -1);
  this->check(PointTree(cube), cube, corner, 0);
  Points heap = this->points(Kind::ONE_PLACE, 10);
  heap.push_back(this->anywhere());
  for (int i = 0; i < 10; ++i) this->check(PointTree(heap), heap, heap[0], i);
}

TYPED_TEST(PointTrees, NoPointOrOnlyTheExcepted) {
  using Points = decltype(this->points(Kind::LINE, 1));
  PointTree none{Points()};
  EXPECT_TRUE(none.empty());
  const auto place = this->anywhere();
  EXPECT_EQ(none.nearest(place).index, -1);
  EXPECT_EQ(none.nearest(place).squared_distance, INF);
  PointTree one{Points{place}};
  EXPECT_EQ(one.nearest(place, 0).index, -1);
  EXPECT_EQ(one.nearest(place, 0).squared_distance, INF);
  EXPECT_EQ(one.nearest(place, 7).index, 0) << "no such point: all count";
  none = std::move(one);
  EXPECT_EQ(none.nearest(place).index, 0);
  const PointTree moved(std::move(none));
  EXPECT_EQ(moved.nearest(place).squared_distance, 0);
}

TYPED_TEST(PointTrees, DiameterAgainstBruteForce) {
  for (const Kind kind : KINDS)
    for (const int n : {0, 1, 2, 3, 10, 77, 400}) {
      const auto list = this->points(kind, n);
      const double expected = this->widest(list);
      EXPECT_NEAR(diameter(list), expected, 1e-15 * (1 + expected)) << n << " points";
    }
}
