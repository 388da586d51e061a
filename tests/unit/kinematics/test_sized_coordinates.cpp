// Tools that grow: pose and points against differences, feet, parameters that follow t, and what is refused.
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/sized_coordinates.hpp"
#include "kinematics/tool_foot.hpp"
#include "support/profile_tool.hpp"
#include "support/script_tool.hpp"
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"
#include "unit/kinematics/pose_derivatives.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

using Names = std::vector<std::string>;
std::shared_ptr<const Coordinates<2>> in_plane() {
  return make_coordinates<2>("roll", "polar",
                             Call().list("pivot", {0.3, -0.2}).text("size", "R^2*(1+phi/9)/c"), {{"c", 2.}});
}
std::shared_ptr<const Coordinates<3>> in_space() {
  return make_coordinates<3>("ball", "h, tilt, a",
                             Call()
                                 .text("x", "a")
                                 .text("y", "h")
                                 .text("z", "h*tilt")
                                 .text("rotation", "x:tilt")
                                 .text("size", "exp(R)*(1+a^2)"),
                             {});
}
const Eigen::VectorXd PLANE_Q = Eigen::Vector4d(1.2, 0.7, -0.4, 1.3);
const Eigen::VectorXd SPACE_Q = Eigen::Vector4d(0.6, -1.3, 0.4, 0.2);

// All derivatives of a point by the coordinates and along the tool, METHOD.md (2.5), (2.18).
template <int Dim>
void check_point(const Tool<Dim>& tool, const Eigen::VectorXd& q, const SurfacePlace<Dim>& place) {
  using P = const SurfacePoint<Dim>&;
  const SurfacePoint<Dim> point = tool.point(q, place);
  const auto check = [&](const auto& at, const auto& member, const auto& derivative, const char* what) {
    const auto expected = finite_difference([&](double t) { return member(at(t)); }, 0, 1e-3);
    expect_close(derivative, expected, 1, 1e-8, what);
  };
  for (int k = 0; k < q.size(); ++k) {
    const auto by_q = [&](double t) {
      Eigen::VectorXd moved = q;
      moved[k] += t;
      return tool.point(moved, place);
    };
    check(
        by_q, [](P p) { return p.x; }, Vector<Dim>(point.x_q.col(k)), "X_k");
    check(
        by_q, [](P p) { return p.n; }, Vector<Dim>(point.n_q.col(k)), "n_k");
    for (int a = 0; a < Dim - 1; ++a)
      check(
          by_q, [a](P p) { return Vector<Dim>(p.E.col(a)); }, Vector<Dim>(point.E_q[a].col(k)), "E_k");
    for (int l = 0; l < q.size(); ++l)
      check(
          by_q, [l](P p) { return Vector<Dim>(p.x_q.col(l)); }, Vector<Dim>(point.x_qq[l].col(k)), "X_kl");
  }
  for (int a = 0; a < Dim - 1; ++a) {
    const auto along = [&](double t) {
      const Param<Dim> eta = t / point.size * Param<Dim>::Unit(a);
      return tool.point(q, tool.surface().moved(place, eta));
    };
    check(
        along, [](P p) { return p.x; }, Vector<Dim>(point.E.col(a)), "E");
    check(
        along, [](P p) { return p.n; }, Vector<Dim>(point.E * point.B.col(a)), "B");
    const PerCoordinate<Dim> turned = point.E_q[a] + point.E.col(a) * point.growth;
    check(
        along, [](P p) { return p.x_q; }, turned, "X_k along the tool");
  }
}

} // namespace

TEST(SizedCoordinates, PoseAgainstDifferences) {
  check_pose_derivatives(*in_plane(), PLANE_Q);
  check_pose_derivatives(*in_space(), SPACE_Q);
  const auto coordinates = in_plane();
  const Pose<2> pose = coordinates->pose(PLANE_Q);
  EXPECT_NEAR(pose.size, 1.3 * 1.3 * (1 + 0.7 / 9) / 2, 1e-15);
  for (int k = 0; k < 4; ++k) {
    const auto moved = [&](double t) { return coordinates->pose(PLANE_Q + t * Eigen::VectorXd::Unit(4, k)); };
    EXPECT_NEAR(finite_difference([&](double t) { return moved(t).size; }, 0, 1e-3), pose.size_q[k], 1e-10);
    for (int l = 0; l < 4; ++l)
      EXPECT_NEAR(finite_difference([&](double t) { return moved(t).size_q[l]; }, 0, 1e-3),
                  pose.size_qq(k, l), 1e-10);
  }
}

TEST(SizedCoordinates, NamesOfTheSizeComeLast) {
  EXPECT_EQ(in_plane()->names(), (Names{"r", "phi", "theta", "R"}));
  EXPECT_EQ(in_space()->names(), (Names{"h", "tilt", "a", "R"}));
  const auto own = make_coordinates<2>("roll", "s, b",
                                       Call().text("x", "b").text("y", "L*b").text("size", "s*L"), {}, {"L"});
  EXPECT_EQ(own->names(), (Names{"b", "L", "s"}));
}

TEST(SizedCoordinates, PointsAgainstDifferences) {
  const auto circle = profile_tool("circle", std::make_shared<Circle>(1.5, true), in_plane());
  check_point(*circle, PLANE_Q, place_of(*circle, 0.6));
  const auto line =
      profile_tool("line", std::make_shared<Segment>(Vector<2>(-2, 1), Vector<2>(1, 0.5)), in_plane());
  check_point(*line, PLANE_Q, place_of(*line, 0.9));
  for (const auto& [name, surface] : surfaces(skew_axis())) {
    SCOPED_TRACE(name);
    check_point(Tool<3>(name, surface, in_space()), SPACE_Q, smooth_places(*surface, 40, 0.05).at(2));
  }
}

TEST(SizedCoordinates, FeetAndGapsAreThoseOfTheSize) {
  const auto roll = make_coordinates<2>("roll", "cartesian", Call().text("size", "R"), {});
  const auto grown = profile_tool("roll", std::make_shared<Circle>(1.), roll);
  const auto same =
      profile_tool("roll", std::make_shared<Circle>(3.), make_coordinates<2>("roll", "cartesian", {}, {}));
  const Eigen::Vector3d place(1, 2, 0.3);
  const auto a =
      tool_feet(*grown, (Eigen::VectorXd(4) << place, 3).finished(), {Vector<2>(4, 7), Vector<2>(1, 1)});
  const auto b = tool_feet(*same, place, {Vector<2>(4, 7), Vector<2>(1, 1)});
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(a[i].gap, b[i].gap, 1e-14);
    expect_close(a[i].x, b[i].x, 1, 1e-14, "foot");
    EXPECT_NEAR(a[i].B(0, 0), 1. / 3, 1e-15);
  }
}

TEST(SizedCoordinates, ParametersThatFollowTime) {
  DrivenTool<2> roll("roll", std::make_shared<ProfileSurface>(std::make_shared<Circle>(1.)));
  roll.set_parameter("v", 0.1);
  roll.set_parameter("R", "5 + v*t");
  roll.set_coordinates(
      make_coordinates<2>("roll", "cartesian", Call().text("size", "R"), roll.parameters(), {"R"}));
  EXPECT_EQ(roll.q(), (Eigen::VectorXd(4) << 0, 0, 0, 5).finished());
  const double t = 2;
  ASSERT_TRUE(roll.prescription().is_motion(3));
  EXPECT_EQ(roll.prescription().formula(3)->value(&t), 5 + 0.1 * 2);
  expect_invalid([&] { roll.set_parameter("S", "t"); }, "\"S\" = \"t\" comes too late");
  expect_invalid([&] { roll.move("y", "5*z"); }, "motion \"y\" of tool \"roll\" \"5*z\"");
}

TEST(SizedCoordinates, BadInput) {
  expect_invalid([] { make_coordinates<2>("roll", "cartesian", Call().text("size", "2"), {}); },
                 "size of tool \"roll\" \"2\" depends on no coordinate");
  expect_invalid([] { make_coordinates<2>("roll", "cartesian", Call().text("size", "2*"), {}); },
                 "size of tool \"roll\" \"2*\"");
  expect_invalid([] { make_coordinates<2>("roll", "cartesian", {}, {}, {"R"}); },
                 "parameter \"R\" of tool \"roll\" follows t, but no formula of its coordinates names it");
  const auto roll = make_coordinates<2>("roll", "cartesian", Call().text("size", "2 - R"), {});
  EXPECT_THROW(roll->pose(Eigen::Vector4d(0, 0, 0, 2)), FormulaDomainError);
  expect_invalid([&] { roll->pose(Eigen::Vector4d(0, 1, 0, 2.5)); },
                 "size of tool \"roll\" \"2 - R\" is -0.5 at x = 0, y = 1, angle = 0, R = 2.5, expected > 0");
  DrivenTool<2> tool("roll", std::make_shared<ProfileSurface>(std::make_shared<Circle>(1.)));
  tool.set_parameter("c", 3);
  expect_invalid([&] { tool.set_parameter("c", "t"); }, "it is a number already");
  expect_invalid([&] { tool.set_parameter("R", "5 +* t"); }, "motion \"R\" of tool \"roll\"");
  expect_invalid([&] { tool.set_parameter("R", "5 + s"); }, "motion \"R\" of tool \"roll\"");
}
