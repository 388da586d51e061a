// Pieces of a profile as a tool's surface: ways over their joints, samples, outlines.
#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/profile_surface.hpp"
#include "geometry/segment.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double INF = std::numeric_limits<double>::infinity();

std::shared_ptr<const ArcChain> punch() {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{-4, 3}, {-4, 0}, {1, 0}, {1.5, 2}, {5, 2.5}},
                                    std::vector<double>{0, 0.8, 0.4, 0.9, 0});
}
std::shared_ptr<const ArcChain> cam() {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{0, 0}, {6, -1}, {7, 3}, {3.2, 2.2}, {1, 5}},
                                    std::vector<double>{0.5, 1.1, 0.6, 0.7, 0.9}, true);
}
/// Where pieces meet, in the order of travel, without the ends.
std::vector<double> joints(const ArcChain& chain) {
  std::vector<double> s;
  double sum = 0;
  for (const ArcPiece& piece : chain.pieces()) s.push_back(sum += piece.length);
  s.pop_back();
  return s;
}
/// The joints of a chain are in the outline, once each (two places within the rounding are one).
void expect_joints(const std::vector<SurfacePlace<2>>& outline, const std::vector<double>& joints,
                   double length) {
  for (const double joint : joints) {
    int there = 0;
    double last = -INF;
    for (const auto& place : outline)
      if (std::abs(place.hint(0) - joint) <= 1e-12 * length && place.hint(0) - last > 1e-12 * length) {
        ++there;
        last = place.hint(0);
      }
    EXPECT_EQ(there, 1) << "joint at " << joint;
  }
}

} // namespace

TEST(ProfileJoints, PiecesAreThoseOfTheProfile) {
  const ProfileSurface chain(punch()), line(std::make_shared<Segment>(Vector<2>(0, 0), Vector<2>(4, 0)));
  const auto s = joints(*punch());
  ASSERT_EQ(s.size(), 6u);
  EXPECT_EQ(chain.piece(chain.at(-1)), 0);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(chain.piece(chain.at(s[k] - 1e-9)), k);
    EXPECT_EQ(chain.piece(chain.at(s[k])), k + 1) << "at a joint the piece that begins there";
  }
  for (const double at : {-3., 0., 2., 9.}) EXPECT_EQ(line.piece(line.at(at)), 0);
}

TEST(ProfileJoints, BetweenIsAlongTheCurve) {
  const ProfileSurface circle(std::make_shared<Circle>(2.)), chain(punch());
  expect_close(circle.between(circle.at(0), circle.at(M_PI), 0.5).y, Vector<2>(0, 2), 1, 1e-15, "half way");
  for (const double f : {0., 0.2, 0.9, 1.})
    EXPECT_NEAR(chain.between(chain.at(1), chain.at(5), f).hint(0), 1 + 4 * f, 1e-15);
}

TEST(ProfileJoints, PassageForwardsAndBackwards) {
  const ProfileSurface chain(punch());
  for (const double joint : joints(*punch())) {
    const SurfacePlace<2> before = chain.at(joint - 0.03), after = chain.at(joint + 0.09);
    const double there = chain.passage(before, after), back = chain.passage(after, before);
    EXPECT_NEAR(there, 0.25, 1e-11);
    EXPECT_NEAR(back, 0.75, 1e-11);
    EXPECT_EQ(chain.piece(chain.between(before, after, there)), chain.piece(after)) << "just beyond";
    EXPECT_EQ(chain.piece(chain.between(after, before, back)), chain.piece(before)) << "just beyond";
    EXPECT_EQ(chain.passage(before, chain.at(joint - 0.01)), INF);
    EXPECT_EQ(chain.passage(after, chain.at(joint)), INF)
        << "the joint belongs to the piece that begins there";
    EXPECT_NEAR(chain.passage(before, chain.at(joint)), 1, 1e-11);
  }
}

// Over several pieces: where the first of them ends. Beyond the ends there is no joint.
TEST(ProfileJoints, PassageOverSeveralPieces) {
  const ProfileSurface chain(punch());
  const auto s = joints(*punch());
  const double a = s[0] - 0.5, b = s[3] + 0.1;
  EXPECT_NEAR(chain.passage(chain.at(a), chain.at(b)), 0.5 / (b - a), 1e-11);
  EXPECT_NEAR(chain.passage(chain.at(b), chain.at(a)), 0.1 / (b - a), 1e-11);
  const double L = punch()->length();
  EXPECT_EQ(chain.passage(chain.at(L - 0.1), chain.at(L + 2)), INF);
  EXPECT_EQ(chain.passage(chain.at(0.1), chain.at(-2)), INF);
}

TEST(ProfileJoints, PassageOverTheSeamOfAClosedProfile) {
  const ProfileSurface closed(cam());
  const double L = cam()->length();
  for (const double turns : {-1., 0., 2.}) {
    const SurfacePlace<2> before = closed.at((turns + 1) * L - 0.02),
                          after = closed.at((turns + 1) * L + 0.02);
    EXPECT_NEAR(closed.passage(before, after), 0.5, 1e-10);
    EXPECT_NEAR(closed.passage(after, before), 0.5, 1e-10);
  }
  const ProfileSurface circle(std::make_shared<Circle>(1.));
  EXPECT_EQ(circle.passage(circle.at(6), circle.at(7)), INF) << "one piece";
}

TEST(ProfileJoints, SamplesAreSpreadOverTheWhole) {
  for (const std::shared_ptr<const Profile<2>>& profile :
       {std::shared_ptr<const Profile<2>>(std::make_shared<Circle>(2.)), {punch()}, {cam()}}) {
    const ProfileSurface surface(profile);
    const double begin = profile->range().begin(0), length = profile->range().end(0) - begin;
    const auto places = surface.samples(16);
    ASSERT_EQ(places.size(), 16u);
    for (int i = 0; i < 16; ++i) {
      EXPECT_NEAR(places[i].hint(0), begin + length * i / 16, 1e-15 * 16 * length);
      EXPECT_EQ(places[i].y, profile->evaluate(places[i].hint).x);
    }
  }
}

TEST(ProfileJoints, OutlineOfAnOpenChainFromEndToEnd) {
  const ProfileSurface chain(punch());
  const double L = punch()->length();
  for (const int n : {2, 3, 10, 101}) {
    const auto places = chain.outline(n);
    SCOPED_TRACE(std::to_string(n) + " points");
    EXPECT_EQ(places.size(), static_cast<std::size_t>(n + 6)) << "and six joints";
    EXPECT_EQ(places.front().y, chain.ends()[0].y);
    EXPECT_EQ(places.back().y, chain.ends()[1].y);
    for (std::size_t i = 1; i < places.size(); ++i) {
      EXPECT_GT(places[i].hint(0), places[i - 1].hint(0));
      EXPECT_LE(places[i].hint(0) - places[i - 1].hint(0), L / (n - 1) * (1 + 1e-12));
    }
    expect_joints(places, joints(*punch()), L);
  }
}

TEST(ProfileJoints, OutlineOfAClosedChainIsClosed) {
  const ProfileSurface closed(cam());
  for (const int n : {2, 50}) {
    const auto places = closed.outline(n);
    EXPECT_EQ(places.size(), static_cast<std::size_t>(n + 9));
    expect_close(places.back().y, places.front().y, 1, 1e-14, "the first point again");
    expect_joints(places, joints(*cam()), cam()->length());
  }
  EXPECT_EQ(ProfileSurface(std::make_shared<Circle>(2.)).outline(7).size(), 7u);
}

// Joints where samples are: four quarters of a circle, and lines of equal length.
TEST(ProfileJoints, OutlineWithJointsAtTheSamples) {
  const double R = 1.5;
  const auto quarters = std::make_shared<ArcChain>(std::vector<Vector<2>>{{R, R}, {-R, R}, {-R, -R}, {R, -R}},
                                                   std::vector<double>{R, R, R, R}, true);
  const auto lines = std::make_shared<ArcChain>(
      std::vector<Vector<2>>{{0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0}, {0.4, 0}, {0.5, 0}},
      std::vector<double>(6, 0.));
  for (const auto& chain : {quarters, lines}) {
    const auto pieces = static_cast<int>(chain->pieces().size());
    for (const int n : {pieces + 1, 2 * pieces + 1}) {
      const auto places = ProfileSurface(chain).outline(n);
      EXPECT_GE(places.size(), static_cast<std::size_t>(n));
      EXPECT_LE(places.size(), static_cast<std::size_t>(n + pieces - 1));
      expect_joints(places, joints(*chain), chain->length());
    }
  }
}
