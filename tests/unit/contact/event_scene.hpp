#pragma once
// Nodes on a line under a tool that comes from above; forces and displacements are set by hand.
#include "contact/events.hpp"
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "support/profile_tool.hpp"
#include "unit/finite_difference.hpp"

namespace burnish::test {

/// Nodes at x = 0, 1, .. 5, y = 0; tools placed by (x, y, angle); the step leads from t = 10 to 12.
struct EventScene {
  static constexpr int NODES = 6;
  ContactModel<2> model;
  BodyView<2> body;
  ContactState<2> start, end;
  Eigen::VectorXd u0, u1, R0, R1;
  EventSearch tolerance{{1e-6, 1e-6, 1e-6}, 1e-3};

  EventScene() {
    model.first = {0};
    body.X = body.X.Zero(2 * NODES);
    for (int i = 0; i < NODES; ++i) {
      model.candidates.push_back(i);
      body.X[2 * i] = i;
    }
    body.fixed.assign(2 * NODES, 0);
    body.spacing = 1;
    u0 = u1 = R0 = R1 = Eigen::VectorXd::Zero(2 * NODES);
    start.nodes.resize(NODES);
  }
  /// A line facing down (s = 20 - x, n = -y), its frame at height h.
  void add_plate(double h, double mu) {
    add(std::make_shared<Segment>(Vector<2>(20, 0), Vector<2>(-20, 0)), Vector<3>(0, h, 0), mu);
  }
  void add(std::shared_ptr<const Profile<2>> profile, const Vector<3>& q, double mu) {
    const std::string name = "tool " + std::to_string(model.tools.size());
    model.tools.push_back(profile_tool(name, profile, std::make_shared<Cartesian>()));
    model.laws.emplace_back(make_coulomb(mu));
    model.first.push_back(model.first.back() + 3);
    start.q.conservativeResize(model.first.back());
    start.q.tail<3>() = q;
    end = start;
  }
  /// Puts node i in contact at both ends. @param along 1, -1: slides along or against the tangent; 0: sticks
  void touch(int i, NodeState state, double along) {
    ContactNode<2>& node = start.nodes[i];
    node.state = state;
    node.tool = 0;
    place_at(node,
             model.tools[0]->foot(model.poses(start.q)[0], body.position(u0, i), node.place.hint).place);
    node.slip_direction = along * model.tools[0]->surface().frame(node.place).E;
    end.nodes[i] = node;
  }
  /// Parameter of a node's place; moves it by ds.
  static double s(const ContactNode<2>& node) { return node.place.hint[0]; }
  static double origin(const ContactNode<2>& node) { return node.slip_origin.hint[0]; }
  void slip(ContactNode<2>& node, double ds) const { node.place = place_of(*model.tools[0], s(node) + ds); }
  /// Direction of its slip along the tangent where it is: 1, -1, or 0.
  double along(const ContactNode<2>& node) const {
    return node.slip_direction.dot(model.tools[0]->surface().frame(node.place).E.col(0));
  }
  /// Normal and tangential force of the plate on node i (N along -y, T along the plate's tangent -x).
  static void set_force(Eigen::VectorXd& R, int i, double N, double T) { R.segment<2>(2 * i) << -T, -N; }
  StepEnds<2> step() const { return {&start, &end, &u0, &u1, &R0, &R1, 10, 2}; }
  std::vector<ContactEvent<2>> earliest() const { return earliest_events(model, body, step(), tolerance); }
  /// The only event, checked for its fraction, instant, kind and node.
  ContactEvent<2> single(EventKind kind, int node, double fraction, double accuracy = 1e-12) const {
    const auto events = earliest();
    EXPECT_EQ(events.size(), 1u);
    if (events.empty()) return {};
    EXPECT_STREQ(name_of(events[0].kind), name_of(kind));
    EXPECT_EQ(events[0].node, node);
    EXPECT_EQ(events[0].candidate, node);
    EXPECT_NEAR(events[0].fraction, fraction, accuracy);
    EXPECT_NEAR(events[0].t, 10 + 2 * fraction, 2 * accuracy);
    return events[0];
  }
};

} // namespace burnish::test
