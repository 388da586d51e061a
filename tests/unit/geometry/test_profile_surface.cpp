// Profiles as tools' surfaces: foot, frame, motions and slips along the curve, pieces and joints, ends.
#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/profile_surface.hpp"
#include "geometry/segment.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double INF = std::numeric_limits<double>::infinity();
const Param<2> ANY(0.0);

struct Case {
  std::string name;
  ProfileSurface surface;
  std::vector<double> s; ///< parameters on the profile, away from joints
  double scale;          ///< of the parameter
};

/// Down its side, a fillet, the flat, a concave fillet, a step up to the right.
std::shared_ptr<const ArcChain> punch() {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{-4, 3}, {-4, 0}, {1, 0}, {1.5, 2}, {5, 2.5}},
                                    std::vector<double>{0, 0.8, 0.4, 0.9, 0});
}
std::shared_ptr<const ArcChain> cam(bool inside = false) {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{0, 0}, {6, -1}, {7, 3}, {3.2, 2.2}, {1, 5}},
                                    std::vector<double>{0.5, 1.1, 0.6, 0.7, 0.9}, true, inside);
}
std::vector<double> joints(const ArcChain& chain) {
  std::vector<double> s{0};
  for (const ArcPiece& piece : chain.pieces()) s.push_back(s.back() + piece.length);
  return s;
}
std::vector<double> middles(const ArcChain& chain) {
  const auto s = joints(chain);
  std::vector<double> middle;
  for (std::size_t i = 0; i + 1 < s.size(); ++i) middle.push_back(0.4 * s[i] + 0.6 * s[i + 1]);
  return middle;
}

std::vector<Case> cases() {
  return {{"circle", ProfileSurface(std::make_shared<Circle>(3.)), {-4, 0, 0.7, 9}, 1},
          {"hollow", ProfileSurface(std::make_shared<Circle>(3., true)), {-4, 0, 0.7, 9}, 1},
          {"segment",
           ProfileSurface(std::make_shared<Segment>(Vector<2>(-1, 2), Vector<2>(3, 5))),
           {0.3, 2, 4.5},
           5},
          {"punch", ProfileSurface(punch()), middles(*punch()), 1},
          {"cam", ProfileSurface(cam()), middles(*cam()), 1},
          {"cam inside", ProfileSurface(cam(true)), middles(*cam(true)), 1}};
}

} // namespace

TEST(ProfileSurface, FootIsThatOfTheProfile) {
  for (const Case& c : cases())
    for (const double s : c.s)
      for (const double distance : {-0.05, 0., 0.05}) {
        SCOPED_TRACE(c.name + " s = " + std::to_string(s));
        const SurfacePlace<2> place = c.surface.at(s);
        const auto foot = c.surface.foot(place.y + distance * c.surface.frame(place).n, place.hint);
        EXPECT_NEAR(foot.gap, distance, 1e-14);
        EXPECT_NEAR(foot.place.hint(0), s, 1e-13);
        expect_close(foot.place.y, place.y, 1, 1e-13, "foot");
        EXPECT_FALSE(foot.on_end);
      }
}

// E = dy/d(eta), dn = E B d(eta); unit vectors, the normal across.
TEST(ProfileSurface, FrameAgainstFiniteDifferencesAlongItsOwnMotion) {
  for (const Case& c : cases())
    for (const double s : c.s) {
      SCOPED_TRACE(c.name + " s = " + std::to_string(s));
      const SurfacePlace<2> place = c.surface.at(s);
      const auto frame = c.surface.frame(place);
      const auto moved = [&](double eta) { return c.surface.moved(place, Param<2>(eta)); };
      const Vector<2> y_eta = finite_difference([&](double eta) { return moved(eta).y; }, 0, 1e-3);
      const Vector<2> n_eta =
          finite_difference([&](double eta) { return Vector<2>(c.surface.frame(moved(eta)).n); }, 0, 1e-3);
      expect_close(frame.E, y_eta, 1, 1e-10, "E");
      expect_close(Vector<2>(frame.E * frame.B), n_eta, 1, 1e-9, "dn");
      EXPECT_NEAR(frame.E.norm(), 1, 1e-15);
      EXPECT_NEAR(frame.n.norm(), 1, 1e-15);
      EXPECT_NEAR(frame.E.col(0).dot(frame.n), 0, 1e-15);
    }
}

TEST(ProfileSurface, CurvatureOfARoller) {
  EXPECT_NEAR(ProfileSurface(std::make_shared<Circle>(4.)).frame({{4, 0}, ANY}).B(0), 0.25, 1e-15);
  EXPECT_NEAR(ProfileSurface(std::make_shared<Circle>(4., true)).frame({{4, 0}, ANY}).B(0), -0.25, 1e-15);
}

TEST(ProfileSurface, SlipIsTheMotionThatLedThere) {
  for (const Case& c : cases())
    for (const double s : c.s)
      for (const double eta : {-1.7, -0.01, 0., 1e-6, 0.3, 2.6}) { // over joints and beyond ends too
        SCOPED_TRACE(c.name + " s = " + std::to_string(s) + " eta = " + std::to_string(eta));
        const SurfacePlace<2> from = c.surface.at(s), to = c.surface.moved(from, Param<2>(eta));
        EXPECT_NEAR(c.surface.slip(from, to)(0), eta, 1e-14);
        const SurfacePlace<2> back = c.surface.moved(to, -c.surface.slip(from, to));
        EXPECT_NEAR(back.hint(0), s, 1e-14 * (1 + std::abs(s)));
        expect_close(back.y, from.y, 1, 1e-13, "there and back");
      }
}

// One turn around a closed profile leads to the same point and is a slip of its length.
TEST(ProfileSurface, SlipCountsTurns) {
  const ProfileSurface circle(std::make_shared<Circle>(3.)), closed(cam());
  for (const auto& [surface, length] :
       {std::make_pair(&circle, 6 * M_PI), std::make_pair(&closed, cam()->length())}) {
    const SurfacePlace<2> from = surface->at(0.2), to = surface->moved(from, Param<2>(length));
    expect_close(to.y, from.y, 1, 1e-13, "the same point");
    EXPECT_NEAR(surface->slip(from, to)(0), length, 1e-13);
  }
}

TEST(ProfileSurface, BeyondTheEndsItGoesOn) {
  const Vector<2> a(-1, 2), along(0.8, 0.6);
  const ProfileSurface line(std::make_shared<Segment>(a, a + 5 * along)), chain(punch());
  const SurfacePlace<2> over = line.moved(line.at(4.5), Param<2>(2.));
  expect_close(over.y, Vector<2>(a + 6.5 * along), 1, 1e-15, "over the end");
  expect_close(line.frame(over).n, Vector<2>(-0.6, 0.8), 1, 1e-15, "normal");
  expect_close(chain.moved(chain.at(0.5), Param<2>(-1.)).y, Vector<2>(-4, 3.5), 1, 1e-15, "up the side");
  const auto foot = line.foot(over.y, over.hint); // but a foot is on the profile
  EXPECT_TRUE(foot.on_end);
  EXPECT_NEAR(foot.gap, 1.5, 1e-14);
  expect_close(foot.place.y, Vector<2>(a + 5 * along), 1, 1e-15, "the end");
}

TEST(ProfileSurface, EndsAndTheDistanceToThem) {
  const ProfileSurface line(std::make_shared<Segment>(Vector<2>(1, 0), Vector<2>(5, 0))), chain(punch());
  ASSERT_EQ(line.ends().size(), 2u);
  EXPECT_EQ(line.ends()[0].y, Vector<2>(1, 0));
  EXPECT_EQ(line.ends()[1].y, Vector<2>(5, 0));
  EXPECT_FALSE(line.closed());
  EXPECT_NEAR(line.distance_to_end(line.at(1.5)), 1.5, 1e-15);
  EXPECT_NEAR(line.distance_to_end(line.at(3.75)), 0.25, 1e-15);
  EXPECT_EQ(line.distance_to_end(line.ends()[1]), 0);
  expect_close(chain.ends()[1].y, Vector<2>(5, 2.5), 1, 1e-14, "last corner");
  for (const ProfileSurface& closed : {ProfileSurface(std::make_shared<Circle>(3.)), ProfileSurface(cam())}) {
    EXPECT_TRUE(closed.closed());
    EXPECT_TRUE(closed.ends().empty());
    EXPECT_EQ(closed.distance_to_end(closed.at(0)), INF);
  }
}

TEST(ProfileSurface, LengthsOfTheProfile) {
  const ProfileSurface chain(punch());
  EXPECT_EQ(chain.length_scale(), punch()->length());
  EXPECT_EQ(chain.tightest_radius(), punch()->tightest_radius());
  EXPECT_EQ(ProfileSurface(std::make_shared<Circle>(3.)).tightest_radius(), 3);
  EXPECT_EQ(&chain.profile(), &chain.profile());
  expect_invalid([] { ProfileSurface(nullptr); }, "tool: no profile");
}
