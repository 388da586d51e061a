// Random arc chains: refused with a clear error, or a smooth chain whose closest points are right.
#include "geometry/arc_chain.hpp"
#include "long/fuzz.hpp"
#include <map>

using namespace burnish;
using namespace burnish::test;

namespace {

struct Drawing {
  std::vector<Vector<2>> points;
  std::vector<double> radii;
  bool closed, inside = false;
};

double rounded(double value, int digits) {
  if (value == 0) return 0;
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return std::stod(text.str());
}

/// Anything: mostly refused.
Drawing scribble(Random& random) {
  Drawing d{{}, {}, random.chance(0.5)};
  const int n = random.whole(1, 7);
  const double size = random.decades(-6, 6);
  for (int i = 0; i < n; ++i) {
    d.points.push_back(random.point(size));
    if (i > 0 && random.chance(0.1))
      d.points.back() = d.points[static_cast<std::size_t>(random.whole(0, i - 1))];
    if (random.chance(0.05)) d.points.back() = d.points.back().array().round();
    d.radii.push_back(random.chance(0.1) ? 0 : size * random.decades(-4, 1));
    const double odd[] = {-1, std::nan(""), HUGE_VAL, 1e300, 1e-300};
    if (random.chance(0.02)) d.radii.back() = odd[random.whole(0, 4)];
    if (!d.closed && (i == 0 || i == n - 1) && random.chance(0.9)) d.radii.back() = 0;
  }
  return d;
}

/// Corners about a center, or along a zigzag, some of them almost straight; fillets take a part of their room
/// or all of it, typed with so many digits.
Drawing sensible(Random& random) {
  Drawing d{{}, {}, random.chance(0.5)};
  const int n = random.whole(3, 12), digits = random.whole(4, 17);
  const double size = random.decades(-6, 6), flat = random.chance(0.3) ? random.decades(-14, -2) : 0;
  const double turn = (random.chance(0.5) ? -2 : 2) * M_PI / n;
  const Vector<2> away = random.chance(0.3) ? random.point(100 * size) : Vector<2>(0, 0);
  for (int i = 0; i < n; ++i) {
    const double angle = turn * (i + random.between(-0.3, 0.3)), r = size * random.between(0.5, 1);
    Vector<2> x = d.closed ? r * Vector<2>(std::cos(angle), std::sin(angle))
                           : size * Vector<2>(i + random.between(-0.3, 0.3), random.between(-1, 1));
    if (flat > 0 && !d.closed) x.y() *= flat;
    d.points.emplace_back(away + x);
    for (double& component : d.points.back()) component = rounded(component, digits);
  }
  std::vector<double> part(n), edge(n);
  const bool full = random.chance(0.4);
  for (double& p : part) p = full ? 0.5 : random.between(0.02, 0.5);
  for (int i = 0; i < n; ++i) edge[i] = (d.points[(i + 1) % n] - d.points[i]).norm();
  for (int i = 0; i < n; ++i) {
    const Vector<2> in = d.points[i] - d.points[(i + n - 1) % n], out = d.points[(i + 1) % n] - d.points[i];
    const double half = std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out))) / 2;
    const double most = part[i] * std::min(edge[(i + n - 1) % n], edge[i]) / std::tan(std::max(half, 1e-15));
    const bool end = !d.closed && (i == 0 || i == n - 1);
    d.radii.push_back(end ? 0 : rounded(std::min(most, 1e9 * size), digits));
  }
  d.inside = false;
  return d;
}

/// Lines and arcs as a polygon with chords of 3 degrees, independently of the core.
std::vector<Vector<2>> polygon(const Drawing& d, double size) {
  std::vector<Vector<2>> line;
  const std::size_t n = d.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector<2>&before = d.points[(i + n - 1) % n], &here = d.points[i], &after = d.points[(i + 1) % n];
    const Vector<2> in = (here - before).normalized(), out = (after - here).normalized();
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    if ((!d.closed && (i == 0 || i == n - 1)) || std::abs(turn) < 1e-9) {
      line.push_back(here);
      continue;
    }
    const double R = d.radii[i] * (turn > 0 ? 1 : -1), cut = R * std::tan(turn / 2);
    for (int k = 0; k <= 60; ++k) {
      const double a = turn * k / 60;
      const Vector<2> left(-in.y(), in.x());
      line.push_back(here - cut * in + R * (std::sin(a) * in + 2 * std::pow(std::sin(a / 2), 2) * left));
    }
  }
  if (d.closed) line.push_back(line.front());
  const auto same = [&](const Vector<2>& a, const Vector<2>& b) { return (a - b).norm() <= 1e-12 * size; };
  line.erase(std::unique(line.begin(), line.end(), same), line.end());
  return line;
}

/// True if it crosses itself; touching: if it comes as close to itself as the chords to their arcs.
bool meets_itself(const Drawing& d, bool touching) {
  double size = 0, longest = 0;
  for (const auto& x : d.points) size = std::max(size, (x - d.points[0]).norm());
  for (const double R : d.radii) longest = std::max(longest, R);
  const double sag = 1e-3 * std::min(longest, size) + 2e-9 * size; // of a chord of 3 degrees
  return polygon_meets_itself(polygon(d, size), d.closed, touching ? sag : 0, 1e-6 * size);
}

void check_chain(const ArcChain& chain, Random& random) {
  const auto& pieces = chain.pieces();
  const double size = Sampled(chain, 100).extent(), far = pieces[0].start.norm();
  double s = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ASSERT_GT(pieces[i].length, 0);
    ASSERT_EQ(chain.piece(Param<2>(s + 0.5 * pieces[i].length)), static_cast<int>(i));
    s += pieces[i].length;
    if (i + 1 == pieces.size() && !chain.closed()) break;
    const ArcPiece& next = pieces[(i + 1) % pieces.size()];
    ASSERT_LE((pieces[i].point(pieces[i].length) - next.start).norm(), 2e-12 * (size + far));
    const Vector<2> t = pieces[i].direction(pieces[i].length);
    ASSERT_LE((t - next.tangent).norm(), 2e-9); // smaller turns count as straight
  }
  ASSERT_NEAR(s, chain.length(), 1e-13 * s);
  for (int k = 0; k < 20; ++k) {
    const auto at = chain.evaluate(Param<2>(chain.length() * random.between(-0.2, 1.2)));
    ASSERT_NEAR(at.x_s.norm(), 1, 1e-12);
    ASSERT_NEAR(at.n.dot(Vector<2>(at.x_s)), 0, 1e-12);
  }
}

/// Counts what became of the drawings, by the first words of the refusals.
using Counts = std::map<std::string, int>;

void try_drawing(const Drawing& d, Random& random, Counts& counts) {
  std::ostringstream text;
  text.precision(17);
  text << (d.closed ? "closed" : "open");
  for (std::size_t i = 0; i < d.points.size(); ++i)
    text << ", " << d.points[i].x() << "," << d.points[i].y() << "," << d.radii[i];
  SCOPED_TRACE(text.str());
  try {
    const ArcChain chain(d.points, d.radii, d.closed, false);
    ++counts["accepted"];
    check_chain(chain, random);
    ASSERT_FALSE(meets_itself(d, false));
    if (!::testing::Test::HasFatalFailure()) check_closest_points(chain, random, 30, 3e-12, 0);
  } catch (const std::invalid_argument& error) {
    const std::string said = error.what();
    ASSERT_EQ(said.find("ArcChain: "), 0u) << said;
    ASSERT_EQ(said.find('\n'), std::string::npos) << said;
    for (const char* reason :
         {"corner", "no room", "crosses", "the same", "turns back", "number of points", "radius"})
      if (said.find(reason) != std::string::npos) {
        ++counts[reason];
        ASSERT_TRUE(reason != std::string("crosses") || meets_itself(d, true)) << said;
        return;
      }
    FAIL() << said;
  }
}

double number_after(const std::string& text, const std::string& words) {
  const std::size_t place = text.find(words);
  return place == std::string::npos ? std::nan("")
                                    : std::strtod(text.c_str() + place + words.size(), nullptr);
}

/// Does what the messages say until they say something else; returns the last of them, empty: accepted.
std::string follow_advice(Drawing d) {
  for (std::size_t round = 0; round <= 4 * d.points.size(); ++round) {
    try {
      ArcChain(d.points, d.radii, d.closed);
      return "";
    } catch (const std::invalid_argument& error) {
      const std::string said = error.what();
      const double most = number_after(said, "up to ");
      const std::size_t times = said.find(" times the radii"), point = said.find("point ");
      if (said.find("is a corner") != std::string::npos && most > 0)
        d.radii[std::stoul(said.substr(point + 6))] = most;
      else if (times != std::string::npos)
        for (double& R : d.radii) R *= std::strtod(said.c_str() + said.rfind(' ', times - 1), nullptr);
      else
        return said;
    }
  }
  return "endless";
}

} // namespace

TEST(FuzzArcChain, AdviceHelps) {
  Random random(3);
  Counts counts;
  for (int i = 0; i < 20000; ++i) {
    const Drawing d = random.chance(0.5) ? scribble(random) : sensible(random);
    const std::string said = follow_advice(d);
    ASSERT_NE(said, "endless");
    ASSERT_EQ(said.find("no room for"), std::string::npos) << said;
    ++counts[said.empty() ? "accepted" : "refused for another reason"];
  }
  for (const auto& [what, n] : counts) std::cout << "  " << n << " " << what << "\n";
  EXPECT_GE(counts["accepted"], 5000);
}

namespace {

template <typename Drawer> void try_drawings(Drawer draw, unsigned seed, int number, int least_accepted) {
  Random random(seed);
  Counts counts;
  for (int i = 0; i < number && !testing::Test::HasFailure(); ++i) try_drawing(draw(random), random, counts);
  for (const auto& [what, n] : counts) std::cout << "  " << n << " " << what << "\n";
  EXPECT_GE(counts["accepted"], least_accepted);
}

} // namespace

TEST(FuzzArcChain, Scribbles) { try_drawings(scribble, 1, 20000, 500); }
TEST(FuzzArcChain, SensibleDrawings) { try_drawings(sensible, 2, 3000, 1000); }
