// Fields from the points of one mesh to places of another: linear ones exactly, smooth ones to second order, none far beyond its
// range.
#include "remesh/field_transfer.hpp"
#include "support/structured_mesh.hpp"
#include "support/tetrahedra.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>

using namespace burnish;
using namespace burnish::test;

namespace {

template <int Dim> std::vector<Vector<Dim>> points_of(const Discretization<Dim>& mesh) {
  std::vector<Vector<Dim>> points(mesh.num_points());
  for (int p = 0; p < mesh.num_points(); ++p) points[p] = Eigen::Map<const Vector<Dim>>(&mesh.point[Dim * p]);
  return points;
}
template <int Dim, class Field>
Eigen::VectorXd at(const std::vector<Vector<Dim>>& places, const Field& field) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k) values[static_cast<Eigen::Index>(k)] = field(places[k]);
  return values;
}

// Largest error of a field from n x n cells of the unit square on 7 x 5 ones.
template <class Field> double error(int n, int order, const Field& field) {
  const auto from = block_mesh(n, n, order, 1, 1).space, to = block_mesh(7, 5, order, 1, 1).space;
  const auto places = points_of<2>(to);
  const FieldTransfer<2> transfer(from, places);
  return (transfer(at<2>(points_of<2>(from), field)) - at<2>(places, field)).cwiseAbs().maxCoeff();
}

} // namespace

TEST(FieldTransfer, LinearFieldsAreExact) {
  const auto linear = [](const Vector<2>& x) { return 3 - 2 * x[0] + 5 * x[1]; };
  for (const int order : {1, 2}) EXPECT_LT(error(4, order, linear), 1e-11) << "P" << order;
}

TEST(FieldTransfer, LinearFieldsInSpaceAreExact) {
  const auto same = [](double x, double y, double z) { return Vector<3>(x, y, z); };
  const auto from = tetrahedra(quadratic_tetrahedra(block_of_tetrahedra(3, 3, 3, same))),
             to = tetrahedra(quadratic_tetrahedra(block_of_tetrahedra(2, 4, 2, same)));
  const auto linear = [](const Vector<3>& x) { return 1 + 2 * x[0] - x[1] + 4 * x[2]; };
  const auto places = points_of<3>(to);
  const Eigen::VectorXd carried = FieldTransfer<3>(from, places)(at<3>(points_of<3>(from), linear));
  EXPECT_LT((carried - at<3>(places, linear)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(FieldTransfer, SmoothFieldsAreOfSecondOrder) {
  const auto wave = [](const Vector<2>& x) { return std::sin(3 * x[0]) * std::cos(2 * x[1]); };
  for (const int order : {1, 2}) {
    const double coarse = error(16, order, wave), fine = error(32, order, wave);
    EXPECT_GT(std::log2(coarse / fine), 1.7) << "P" << order << ": " << coarse << " " << fine;
  }
}

TEST(FieldTransfer, AJumpOvershootsByHalfOfItAtMost) {
  const auto jump = [](const Vector<2>& x) { return x[0] < 0.47 ? 0. : 1.; };
  const auto from = block_mesh(9, 9, 2, 1, 1).space, to = block_mesh(23, 17, 2, 1, 1).space;
  const Eigen::VectorXd carried = FieldTransfer<2>(from, points_of<2>(to))(at<2>(points_of<2>(from), jump));
  EXPECT_GE(carried.minCoeff(), -0.5);
  EXPECT_LE(carried.maxCoeff(), 1.5);
  EXPECT_NEAR(carried.mean(), 0.53, 0.03);
}

TEST(FieldTransfer, PlacesFarOutsideAreRefused) {
  const auto from = block_mesh(4, 4, 2, 1, 1).space;
  expect_invalid([&] { FieldTransfer<2>(from, {Vector<2>(0.5, 2.5)}); },
                 "remesh: the new mesh has a place at 0.5 2.5");
}

TEST(NodalTransfer, LinearInTheMesh) {
  const auto from = block_mesh(4, 3, 2, 1, 1).space;
  Eigen::VectorXd u(from.num_dofs());
  const auto field = [](const Vector<2>& x) { return Vector<2>(x[0] - 2 * x[1], 1 + 3 * x[1]); };
  for (int a = 0; a < from.num_nodes; ++a) u.segment<2>(2 * a) = field(from.node(a));
  const std::vector<Vector<2>> to{{0.13, 0.77}, {1, 1}, {0.5, 0.01}};
  const Eigen::VectorXd carried = nodal_transfer<2>(from, u, to);
  for (std::size_t k = 0; k < to.size(); ++k)
    EXPECT_LT((carried.segment<2>(static_cast<Eigen::Index>(2 * k)) - field(to[k])).norm(), 1e-12);
}
