// Every tool that a script can write in space, each shape in each kind of coordinates: derivatives of a contact node's rows by
// differences, duality of the generalized forces.
#include "contact/linearization.hpp"
#include "support/script_tool.hpp"
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// A node on a tool without friction, and the work F.x of a constant force there: its second derivatives are the geometric
/// terms (METHOD.md 3.2).
struct Node {
  ContactModel<3> model;
  ContactNode<3> node;
  Eigen::VectorXd q;
  Vector<3> F{0.7, -1.3, 0.4};

  Node(std::shared_ptr<const Surface<3>> surface, const CoordinatesCall& call) {
    model.tools = {std::make_shared<Tool<3>>("tool", surface, coordinates_of(call))};
    model.laws.emplace_back(std::make_shared<NoFriction>());
    model.candidates = {0};
    model.first = {0, static_cast<int>(call.q.size())};
    q = Eigen::Map<const Eigen::VectorXd>(call.q.data(), static_cast<Eigen::Index>(call.q.size()));
    node.tool = 0;
    node.state = NodeState::SLIDING;
    place_at(node, smooth_places(*surface, 40, 0.05).at(2));
  }
  const Tool<3>& tool() const { return *model.tools[0]; }
  SurfacePoint<3> point(const Param<3>& eta, const Eigen::VectorXd& dq) const {
    return tool().point(Eigen::VectorXd(q + dq), tool().surface().moved(node.place, eta));
  }
  Eigen::VectorXd at_rest() const { return Eigen::VectorXd::Zero(q.size()); }
  NodeLinearization<3> linearized() const {
    return linearize_node<3>(model, node, 0, model.poses(q), F, GeometricTerms::COMPLETE);
  }
};

/// Second derivative of the work along a slip, of five places.
double second_along(const Node& sample, const Param<3>& way) {
  const double h = 1e-3;
  const auto work = [&](double t) { return sample.point(t * h * way, sample.at_rest()).x.dot(sample.F); };
  return (16 * (work(1) + work(-1)) - work(2) - work(-2) - 30 * work(0)) / (12 * h * h);
}

void check_blocks(const Node& sample) {
  const NodeLinearization<3> rows = sample.linearized();
  const SurfacePoint<3> here = sample.point(Param<3>::Zero(), sample.at_rest());
  expect_close(rows.W, here.E, 1, 1e-15, "W");
  const auto position = [&](const Param<3>& eta) { return sample.point(eta, sample.at_rest()).x; };
  const double h = 1e-3;
  for (int a = 0; a < 2; ++a) {
    const Param<3> along = Param<3>::Unit(a);
    expect_close(Vector<3>(here.E.col(a)),
                 finite_difference([&](double t) { return position(t * along); }, 0, h), 1, 1e-9,
                 "dx by slip");
    const auto work_q = [&](double t) {
      return Eigen::VectorXd(sample.point(t * along, sample.at_rest()).x_q.transpose() * sample.F);
    };
    expect_close(Eigen::VectorXd(rows.geo_qs.row(a).transpose()), finite_difference(work_q, 0, h), 5, 1e-7,
                 "q-slip");
    for (int b = 0; b < 2; ++b) {
      const Param<3> sum = along + Param<3>::Unit(b), difference = along - Param<3>::Unit(b);
      const double mixed = (second_along(sample, sum) - second_along(sample, difference)) / 4;
      EXPECT_NEAR(rows.geo_ss(a, b), mixed, 1e-7 * (1 + here.B.norm())) << "slip-slip";
    }
  }
  for (Eigen::Index k = 0; k < sample.q.size(); ++k) {
    const auto moved = [&](double t) {
      return sample.point(Param<3>::Zero(), t * Eigen::VectorXd::Unit(sample.q.size(), k));
    };
    const auto row = [&](double t) { return Param<3>(moved(t).E.transpose() * sample.F); };
    expect_close(Param<3>(rows.geo_sq.col(k)), finite_difference(row, 0, h), 5, 1e-7, "slip-q");
    const auto force = [&](double t) { return Eigen::VectorXd(moved(t).x_q.transpose() * sample.F); };
    expect_close(Eigen::VectorXd(rows.geo_qq.col(k)), finite_difference(force, 0, h), 5, 1e-7, "q-q");
    expect_close(Vector<3>(here.x_q.col(k)), finite_difference([&](double t) { return moved(t).x; }, 0, h), 5,
                 1e-9, "dx by q");
  }
}

// Q_k = o_k . f + d_k . M about the frame's origin (METHOD.md (2.14)), to rounding of the terms.
void check_duality(const Node& sample) {
  const Pose<3> pose = sample.model.poses(sample.q)[0];
  const SurfacePoint<3> here = sample.point(Param<3>::Zero(), sample.at_rest());
  const Vector<3> moment = (here.x - pose.origin).cross(sample.F);
  for (std::size_t k = 0; k < pose.R_q.size(); ++k) {
    const Tensor<3> spin = pose.R_q[k] * pose.R.transpose();
    const Vector<3> axis(spin(2, 1), spin(0, 2), spin(1, 0));
    const double size =
        sample.F.norm() * (pose.origin_q[k].norm() + axis.norm() * (here.x - pose.origin).norm());
    EXPECT_NEAR(here.x_q.col(static_cast<Eigen::Index>(k)).dot(sample.F),
                pose.origin_q[k].dot(sample.F) + axis.dot(moment), 1e-14 * size);
  }
}

} // namespace

TEST(AnyToolInSpace, EveryBlockAgainstDifferences) {
  for (const auto& shape : shape_calls())
    for (const auto& call : coordinates_calls()) {
      SCOPED_TRACE(shape.name + " in " + call.name);
      check_blocks(Node(make_surface<3>(shape.arguments), call));
    }
}

TEST(AnyToolInSpace, ForcesAreMomentsAboutAxes) {
  for (const auto& shape : shape_calls())
    for (const auto& call : coordinates_calls()) {
      SCOPED_TRACE(shape.name + " in " + call.name);
      check_duality(Node(make_surface<3>(shape.arguments), call));
    }
}
