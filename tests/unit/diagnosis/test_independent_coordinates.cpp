// Coordinates of a tool in space that move it alike: near parallel axes, and one number too many.
#include "diagnosis/before/program_checks.hpp"
#include "support/pressed_body.hpp"
#include "support/script_tool.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// x, y, z under motion, all numbers of the rotation but one, `given`, under force.
void check(const std::string& rotation, const std::vector<double>& numbers, int given = -1) {
  Call call;
  call.text("rotation", rotation);
  const PressedPrism scene(0.3, make_coordinates<3>("plane", "cartesian", call, {}));
  ContactState<3> state = scene.contact->accepted().contact;
  const auto count = static_cast<Eigen::Index>(numbers.size());
  state.q.tail(count) = Eigen::Map<const Eigen::VectorXd>(numbers.data(), count);
  PrescribedValues prescribed{{1, 1, 1}, Eigen::VectorXd::Zero(3 + count)};
  prescribed.is_motion.resize(static_cast<std::size_t>(3 + count), 0);
  if (given >= 0) prescribed.is_motion[static_cast<std::size_t>(3 + given)] = 1;
  check_independent(*scene.setup, state, prescribed);
}

} // namespace

TEST(IndependentCoordinates, EulersAnglesNearParallelAxes) {
  const std::string euler = "z:phi x:theta z:psi", tilts = "z:phi x:theta y:psi";
  EXPECT_NO_THROW(check(euler, {0.4, 0.01, -0.6}));
  EXPECT_NO_THROW(check(tilts, {0.4, 0, -0.6}));
  expect_invalid(
      [&] {
        check(euler, {0.4, 1e-4, -0.6});
      },
      "contact.begin: coordinates \"phi\", \"psi\" of tool \"plane\" are under force, but one of them moves "
      "the "
      "tool as the others do; give one of them a motion, or, as axes of turns are parallel near \"theta\" = "
      "0.0001, take another sequence of axes, or \"cartesian\" without rotation=, whose spins have no "
      "singular "
      "pose");
  expect_invalid(
      [&] {
        check(tilts, {0.4, M_PI / 2, -0.6});
      },
      "coordinates \"phi\", \"psi\" of tool \"plane\"");
  expect_invalid([&] { check(tilts, {0.4, M_PI / 2, -0.6}); }, "parallel near \"theta\" = 1.5708");
}

TEST(IndependentCoordinates, AQuaternionHasOneNumberTooMany) {
  const std::string quaternion = "quaternion: w, a, b, c";
  for (const int given : {0, 3}) EXPECT_NO_THROW(check(quaternion, {1, 0.5, -0.5, 0.7}, given));
  EXPECT_NO_THROW(check(quaternion, {1, 0, 0, 0}, 0));
  for (const bool turned : {true, false}) { // without a turn the length, w, moves nothing yet
    try {
      check(quaternion, turned ? std::vector<double>{1, 0.5, -0.5, 0.7} : std::vector<double>{1, 0, 0, 0});
      FAIL();
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      const std::string list = turned ? R"("w", "a", "b", "c")" : R"("w", "a")";
      EXPECT_NE(text.find("coordinates " + list + " of tool \"plane\" are under force"), std::string::npos)
          << text;
      EXPECT_EQ(text.find("parallel"), std::string::npos) << "at every pose";
    }
  }
}
