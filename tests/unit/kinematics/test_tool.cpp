// A point of a placed tool: all derivatives for every pair of profile and coordinates.
#include "geometry/circle.hpp"
#include "geometry/plane.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/polar.hpp"
#include "kinematics/tool_foot.hpp"
#include "support/profile_tool.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>

using namespace burnish;
using namespace burnish::test;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {
/// A tool with lengths in units of `unit`, its scales, poses and parameters to test at.
struct Sample {
  std::shared_ptr<const Tool<2>> shared;
  double length;              ///< natural length
  double param_scale;         ///< natural change of s
  Vector3d coordinate_scales; ///< natural change of each coordinate
  const Tool<2>& tool() const { return *shared; }
  SurfacePlace<2> place(double parameter) const { return place_of(*shared, parameter * param_scale); }
};

std::shared_ptr<const Coordinates<2>> cartesian() { return std::make_shared<Cartesian>(); }
std::shared_ptr<const Coordinates<2>> polar(double unit) {
  return std::make_shared<Polar>(unit * Vector<2>(3, -2));
}
std::shared_ptr<const Profile<2>> circle(double unit, bool inside = false) {
  return std::make_shared<Circle>(15 * unit, inside);
}
std::shared_ptr<const Profile<2>> segment(double unit) {
  return std::make_shared<Segment>(unit * Vector<2>(-9, 1), unit * Vector<2>(11, 6));
}

std::vector<Sample> samples(double unit) {
  const double length = 15 * unit;
  std::vector<Sample> all;
  for (const auto& [name, coordinates, scales] :
       {std::make_tuple("cartesian", cartesian(), Vector3d(length, length, 1)),
        std::make_tuple("polar", polar(unit), Vector3d(length, 1, 1))}) {
    const std::string suffix = std::string(" ") + name;
    all.push_back({profile_tool("circle" + suffix, circle(unit), coordinates), length, 1, scales});
    all.push_back(
        {profile_tool("inside circle" + suffix, circle(unit, true), coordinates), length, 1, scales});
    all.push_back({profile_tool("segment" + suffix, segment(unit), coordinates), length, length, scales});
  }
  return all;
}

/// Coordinates and parameter in units of the sample's scales.
const Vector3d POSES[] = {{3, 0, 0}, {2.5, 1.2, -0.7}, {1, -2, 5}, {-0.5, 3, 2}};
const double PARAMETERS[] = {-0.9, 0.0, 0.6, 1.3};

// Along the tangent: dx = E d(eta), dn = E B d(eta), dE = -n B d(eta).
void check_along(const Sample& sample, const VectorXd& q, const SurfacePlace<2>& place) {
  const SurfacePoint<2> point = sample.tool().point(q, place);
  const auto by_eta = [&](const auto& member) {
    const auto along = [&](double eta) {
      return member(sample.tool().point(q, sample.tool().surface().moved(place, Param<2>(eta))));
    };
    return finite_difference(along, 0, 1e-3 * sample.length);
  };
  const double L = sample.length, tolerance = 1e-9;
  expect_close(point.E, by_eta([](const SurfacePoint<2>& p) { return p.x; }), 1, tolerance, "E");
  expect_close(point.E * point.B, by_eta([](const SurfacePoint<2>& p) { return p.n; }), 1 / L, tolerance,
               "B");
  expect_close(-point.n * point.B, by_eta([](const SurfacePoint<2>& p) { return p.E; }), 1 / L, tolerance,
               "dE");
  // mixed derivative in the other order
  expect_close(point.E_q[0] * sample.coordinate_scales.asDiagonal(),
               by_eta([](const SurfacePoint<2>& p) { return p.x_q; }) * sample.coordinate_scales.asDiagonal(),
               1, tolerance, "E_q");
}

void check_by_q(const Sample& sample, const VectorXd& q, const SurfacePlace<2>& place, int k) {
  const SurfacePoint<2> point = sample.tool().point(q, place);
  const Vector3d& scales = sample.coordinate_scales;
  const auto by_q = [&](const auto& member) {
    const auto along = [&](double t) {
      VectorXd moved = q;
      moved(k) = t;
      return member(sample.tool().point(moved, place));
    };
    return finite_difference(along, q(k), 1e-3 * scales(k));
  };
  const double L = sample.length / scales(k), tolerance = 1e-9;
  expect_close(point.x_q.col(k), by_q([](const SurfacePoint<2>& p) { return p.x; }), L, tolerance, "x_q");
  expect_close(point.n_q.col(k), by_q([](const SurfacePoint<2>& p) { return p.n; }), 1 / scales(k), tolerance,
               "n_q");
  expect_close(point.E_q[0].col(k), by_q([](const SurfacePoint<2>& p) { return p.E; }), 1 / scales(k),
               tolerance, "E_q");
  const auto x_qq = by_q([](const SurfacePoint<2>& p) { return p.x_q; });
  expect_close(point.x_qq[k] * scales.asDiagonal(), x_qq * scales.asDiagonal(), L, tolerance, "x_qq");
  for (int l = 0; l < 3; ++l)
    expect_close(point.x_qq[k].col(l), point.x_qq[l].col(k), 1, 0, "symmetry of x_qq");
}
} // namespace

TEST(Tool, DerivativesAgainstFiniteDifferences) {
  for (double unit : {1e-3, 1.0})
    for (const Sample& sample : samples(unit))
      for (const Vector3d& pose : POSES)
        for (double parameter : PARAMETERS) {
          SCOPED_TRACE(sample.tool().name() + ", unit " + std::to_string(unit));
          const VectorXd q = pose.cwiseProduct(sample.coordinate_scales);
          const SurfacePlace<2> place = sample.place(parameter);
          check_along(sample, q, place);
          for (int k = 0; k < 3; ++k) check_by_q(sample, q, place, k);
        }
}

TEST(Tool, WrittenFormulasOfThePolarCircle) { // METHOD.md 2.3
  const double R = 15, r = 45, phi = 0.7, theta = -0.4, s = 2.1;
  const auto roller = profile_tool("roller", circle(1), polar(1));
  const SurfacePoint<2> point = roller->point(Vector3d(r, phi, theta), place_of(*roller, s));
  const Vector<2> e = plane_direction(phi), e_phi = left_of(e), n = plane_direction(theta + s),
                  t = left_of(n);
  const Vector<2> zero = Vector<2>::Zero();
  expect_close(point.x, Vector<2>(3, -2) + r * e + R * n, R, 1e-14, "X");
  expect_close(point.n, n, 1, 1e-14, "n");
  expect_close(point.E, t, 1, 1e-14, "E = X_s / R");
  expect_close(point.x_q.col(0), e, 1, 1e-14, "X_r");
  expect_close(point.x_q.col(1), r * e_phi, r, 1e-14, "X_phi");
  expect_close(point.x_q.col(2), R * point.E, R, 1e-14, "X_theta = X_s");
  expect_close(point.x_qq[0].col(1), e_phi, 1, 1e-14, "X_r,phi");
  expect_close(point.x_qq[1].col(1), -r * e, r, 1e-14, "X_phi,phi");
  expect_close(point.x_qq[2].col(2), -R * n, R, 1e-14, "X_theta,theta");
  expect_close(point.E_q[0].col(2), -n, 1, 1e-14, "X_theta,s / R");
  EXPECT_NEAR(point.B(0, 0), 1 / R, 1e-16) << "X_ss = -R n";
  for (const Vector<2> vanishing : {point.x_qq[0].col(0), point.x_qq[0].col(2), point.x_qq[1].col(2)})
    expect_close(vanishing, zero, 1, 0, "other second derivatives");
  expect_close(point.E_q[0].leftCols(2), Tensor<2>::Zero(), 1, 0, "X_r,s and X_phi,s");
}

TEST(Tool,
     GeneralizedForcesOfPolarCoordinates) { // signs and meaning of Q_k = X_k . F as documented in polar.hpp
  const Vector<2> pivot(3, -2), F(2, 5);
  const Vector3d q(45, 0.7, -0.4);
  const auto roller = profile_tool("roller", circle(1), polar(1));
  const SurfacePoint<2> point = roller->point(q, place_of(*roller, 2.1));
  const Vector3d Q = point.x_q.transpose() * F;
  const auto moment = [&](const Vector<2>& arm) { return left_of(arm).dot(F); };
  const Vector<2> origin = Polar(pivot).pose(q).origin;
  EXPECT_NEAR(Q(0), plane_direction(0.7).dot(F), 1e-12);
  EXPECT_NEAR(Q(1), moment(origin - pivot), 1e-12);
  EXPECT_NEAR(Q(2), moment(point.x - origin), 1e-12);
  EXPECT_NEAR(Q(1) + Q(2), moment(point.x - pivot), 1e-12);
}

TEST(Tool, PolarAndCartesianGiveTheSamePoints) {
  for (const auto& profile : {circle(1), circle(1, true), segment(1)})
    for (const Vector3d& q_polar : {Vector3d(45, 0.7, -0.4), Vector3d(20, -3, 8)}) {
      const Vector<2> e = plane_direction(q_polar(1)), origin = Vector<2>(3, -2) + q_polar(0) * e;
      const auto a = profile_tool("a", profile, polar(1)), b = profile_tool("b", profile, cartesian());
      const SurfacePoint<2> pa = a->point(q_polar, place_of(*a, 1.3));
      const SurfacePoint<2> pb = b->point(Vector3d(origin.x(), origin.y(), q_polar(2)), place_of(*b, 1.3));
      expect_close(pa.x, pb.x, 45, 1e-14, "x");
      expect_close(pa.n, pb.n, 1, 1e-14, "n");
      expect_close(pa.E, pb.E, 1, 1e-14, "E");
      // chain rule of q_cartesian(q_polar)
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
      jacobian.topLeftCorner<2, 2>() << e, q_polar(0) * left_of(e);
      expect_close(pa.x_q, pb.x_q * jacobian, 45, 1e-14, "x_q");
    }
}

TEST(Tool, ClosestPointInSpace) {
  for (const Sample& sample : samples(1e-3))
    for (const Vector3d& scaled : POSES)
      for (double distance : {-2e-3, 0.0, 2e-3}) {
        SCOPED_TRACE(sample.tool().name());
        const VectorXd q = scaled.cwiseProduct(sample.coordinate_scales);
        const Pose<2> pose = sample.tool().coordinates().pose(q);
        const SurfacePlace<2> place = sample.place(0.6);
        const SurfacePoint<2> point = sample.tool().point(pose, place);
        const auto foot = sample.tool().foot(pose, point.x + distance * point.n, place.hint);
        EXPECT_FALSE(foot.on_end);
        EXPECT_NEAR(foot.gap / sample.length, distance / sample.length, 1e-13);
        EXPECT_NEAR(foot.place.hint(0) / sample.param_scale, 0.6, 1e-13);
        expect_close(foot.place.y, place.y, sample.length, 1e-13, "place");
        expect_close(sample.tool().position(pose, place), point.x, sample.length, 0, "position");
      }
}

TEST(Tool, ClosestPointKeepsBranchAndEnds) {
  const auto roller = profile_tool("roller", circle(1), cartesian()),
             plate = profile_tool("plate", segment(1), cartesian());
  const Vector3d q(5, 6, 0.3);
  const SurfacePoint<2> point = roller->point(q, place_of(*roller, 0.5));
  const Pose<2> pose = roller->coordinates().pose(q);
  EXPECT_NEAR(roller->foot(pose, point.x, Param<2>(0.4 + 6 * M_PI)).place.hint(0), 0.5 + 6 * M_PI, 1e-13);
  const Vector<2> beyond = plate->point(q, place_of(*plate, 30.0)).x;
  const auto foot = plate->foot(pose, beyond, Param<2>(0.0));
  EXPECT_TRUE(foot.on_end);
  EXPECT_NEAR(foot.gap, 30 - plate->surface().length_scale(), 1e-13);
}

TEST(Tool, SameInMetersAndMillimeters) {
  const auto meters = samples(1e-3), millimeters = samples(1);
  for (std::size_t i = 0; i < meters.size(); ++i) {
    SCOPED_TRACE(meters[i].tool().name());
    const auto scales = meters[i].coordinate_scales, scales_mm = millimeters[i].coordinate_scales;
    const VectorXd q = POSES[1].cwiseProduct(scales), q_mm = POSES[1].cwiseProduct(scales_mm);
    const auto in_m = meters[i].tool().point(q, meters[i].place(0.6));
    const auto in_mm = millimeters[i].tool().point(q_mm, millimeters[i].place(0.6));
    expect_close(1000 * in_m.x, in_mm.x, 15, 1e-14, "x");
    expect_close(in_m.n, in_mm.n, 1, 1e-14, "n");
    expect_close(1000 * in_m.x_q * scales.asDiagonal(), in_mm.x_q * scales_mm.asDiagonal(), 45, 1e-14, "x_q");
  }
}

TEST(Tool, KeepsItsParts) {
  const auto surface = std::make_shared<ProfileSurface>(circle(1));
  const auto coordinates = cartesian();
  const Tool<2> tool("roller", surface, coordinates);
  EXPECT_EQ(tool.name(), "roller");
  EXPECT_EQ(&tool.surface(), surface.get());
  EXPECT_EQ(&tool.coordinates(), coordinates.get());
}

TEST(Tool, RefusesBadInput) {
  const double nan = std::nan("");
  expect_invalid([] { profile_tool("", circle(1), cartesian()); }, "Tool: the name is empty");
  expect_invalid([] { Tool<2>("die", nullptr, cartesian()); },
                 "Tool: tool \"die\" has no surface (null pointer)");
  expect_invalid([] { ProfileSurface(nullptr); }, "tool: no profile");
  expect_invalid([] { profile_tool("die", circle(1), nullptr); },
                 "Tool: tool \"die\" has no coordinates (null pointer)");
  const auto roller = profile_tool("roller", circle(1), polar(1));
  const SurfacePlace<2> place = place_of(*roller, 0);
  expect_invalid([&] { roller->point(VectorXd::Zero(2), place); },
                 "Tool::point of \"roller\": size of q = 2, expected 3 (r, phi, theta)");
  expect_invalid([&] { roller->point(Vector3d(1, 0, nan), place); },
                 "Tool::point of \"roller\": theta = nan, expected a finite number");
  expect_invalid([&] { place_of(*roller, nan); }, "Circle::evaluate: s = nan");
  const Pose<2> pose = roller->coordinates().pose(Vector3d(1, 0, 0));
  expect_invalid([&] { roller->foot(pose, {nan, 0}, place.hint); }, "Circle::closest_point: x = ");
}

// Gradient n and second derivatives E H E', H = (1 + gap B)^-1 B, of the gap, at points on both sides of the surface.
TEST(ToolFoot, DerivativesOfTheGap) {
  for (const double unit : {1.0, 1e-3})
    for (const Sample& sample : samples(unit))
      for (const Vector3d& pose : POSES) {
        const VectorXd q = pose.cwiseProduct(sample.coordinate_scales);
        const Tool<2>& tool = sample.tool();
        const SurfacePoint<2> on = tool.point(q, sample.place(0.3));
        for (const double outside : {-0.2, 0.0, 0.4}) {
          const double gap = outside * sample.length;
          const Vector<2> x = on.x + gap * on.n;
          const auto foot_at = [&](const Vector<2>& p) { return tool_feet<2>(tool, q, {p}).front(); };
          const ToolFoot<2> foot = foot_at(x);
          EXPECT_NEAR(foot.gap, gap, 1e-12 * sample.length);
          expect_close(foot.x, on.x, sample.length, 1e-12, "foot");
          EXPECT_FALSE(foot.on_end);
          const double H = foot.B(0, 0) / (1 + gap * foot.B(0, 0));
          for (int axis = 0; axis < 2; ++axis) {
            const Vector<2> direction = Vector<2>::Unit(axis);
            const double step = 1e-3 * sample.length;
            const double slope =
                finite_difference([&](double d) { return foot_at(x + d * direction).gap; }, 0, step);
            EXPECT_NEAR(slope, foot.n[axis], 1e-10);
            const Vector<2> turn =
                finite_difference([&](double d) { return Vector<2>(foot_at(x + d * direction).n); }, 0, step);
            expect_close(turn, Vector<2>(foot.E * H * foot.E.transpose() * direction), 1 / sample.length,
                         1e-9, "second derivatives");
          }
        }
      }
}

TEST(ToolFoot, RefusesPointsThatAreNotFinite) {
  const Sample sample = samples(1).front();
  expect_invalid([&] { tool_feet<2>(sample.tool(), VectorXd::Zero(3), {{0, NAN}}); }, "finite");
}
