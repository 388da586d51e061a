// Rows, columns and geometric terms of one node against finite differences of its residuals at constant force.
#include "contact/linearization.hpp"
#include "unit/contact/spring_body.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const Vector<2> F(0.7, -1.1);

struct Node {
  SpringContact contact;
  explicit Node(Shape shape, Frame frame, double mu, double along, bool slides) {
    contact.add(make_tool("tool", shape, frame), mu);
    contact.touch(0, 0, 0.8, along, slides);
  }
  NodeLinearization<2> linearized(GeometricTerms terms = GeometricTerms::COMPLETE) const {
    return linearize_node<2>(contact.model, contact.state.nodes[0], 0, contact.model.poses(contact.state.q),
                             F, terms);
  }
  ContactPoint<2> point(double slip, const Eigen::VectorXd& q) const {
    ContactNode<2> node = contact.state.nodes[0];
    node.place = contact.model.tools[0]->surface().moved(node.place, Param<2>(slip));
    return contact_point(contact.model, contact.model.poses(q), node);
  }
  /// E'F + m g(N) at constant F.
  double row(double slip, const Eigen::VectorXd& q) const {
    const auto at = point(slip, q);
    return (at.surface.E.transpose() * F)[0] +
           at.m[0] * contact.model.laws[0].friction().limit(at.surface.n.dot(F), 1);
  }
  /// X_k . F at constant F.
  Eigen::VectorXd tool_rows(double slip, const Eigen::VectorXd& q) const {
    return point(slip, q).surface.x_q.transpose() * F;
  }
};

void check_node(Shape shape, Frame frame, double mu, double along) {
  const Node node(shape, frame, mu, along, true);
  const auto linear = node.linearized();
  const Eigen::VectorXd q = node.contact.state.q;
  ASSERT_TRUE(linear.sliding);
  EXPECT_NEAR((linear.W.transpose() * F + linear.constant)[0], node.row(0, q), 1e-14);
  const double h = 1e-3, tolerance = 1e-9;
  EXPECT_NEAR(linear.geo_ss(0, 0), finite_difference([&](double s) { return node.row(s, q); }, 0, h),
              tolerance);
  expect_close(Eigen::VectorXd(linear.geo_qs.transpose()),
               finite_difference([&](double s) { return node.tool_rows(s, q); }, 0, h), 1, tolerance,
               "geo_qs");
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const auto moved = [&](double t) {
      return Eigen::VectorXd(q + (t - q[k]) * Eigen::VectorXd::Unit(q.size(), k));
    };
    EXPECT_NEAR(linear.geo_sq(0, k),
                finite_difference([&](double t) { return node.row(0, moved(t)); }, q[k], h), tolerance);
    expect_close(Eigen::VectorXd(linear.geo_qq.col(k)),
                 finite_difference([&](double t) { return node.tool_rows(0, moved(t)); }, q[k], h), 1,
                 tolerance, "geo_qq");
    expect_close(Vector<2>(linear.x_q.col(k)),
                 finite_difference([&](double t) { return node.point(0, moved(t)).surface.x; }, q[k], h), 1,
                 tolerance, "x_q");
  }
}

} // namespace

TEST(Linearization, SlidingNodeAgainstFiniteDifferences) {
  for (const Shape shape : {Shape::CIRCLE, Shape::INSIDE, Shape::SEGMENT, Shape::ARC_CHAIN})
    for (const Frame frame : {Frame::CARTESIAN, Frame::POLAR, Frame::CRANK})
      for (const double along : {1., -1.}) {
        check_node(shape, frame, 0.3, along);
        check_node(shape, frame, 0, 0);
      }
}

TEST(Linearization, StickingNodeHasNoRow) {
  const auto linear = Node(Shape::CIRCLE, Frame::POLAR, 0.3, 0, false).linearized();
  EXPECT_FALSE(linear.sliding);
  EXPECT_EQ(linear.W.norm(), 0);
  EXPECT_EQ(linear.geo_ss.norm(), 0);
  EXPECT_EQ(linear.geo_sq.norm() + linear.geo_qs.norm(), 0);
  EXPECT_GE(linear.geo_qq.norm(), 1e-2) << "its place turns with the tool";
}

TEST(Linearization, TermsThatAreLeftOut) {
  const Node node(Shape::CIRCLE, Frame::POLAR, 0.3, 1, true);
  const auto complete = node.linearized(), article = node.linearized(GeometricTerms::ARTICLE),
             none = node.linearized(GeometricTerms::NONE);
  EXPECT_EQ(article.geo_ss, complete.geo_ss);
  EXPECT_EQ(article.geo_sq, complete.geo_sq);
  EXPECT_EQ(article.geo_qs.norm() + article.geo_qq.norm(), 0);
  EXPECT_EQ(none.geo_ss.norm() + none.geo_sq.norm() + none.geo_qs.norm() + none.geo_qq.norm(), 0);
  EXPECT_EQ(none.W, complete.W);
}
