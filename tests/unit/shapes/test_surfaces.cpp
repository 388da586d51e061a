// The words of a script for surfaces of space: each kind, defaults, and every message.
#include "geometry/revolved.hpp"
#include "support/script_tool.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<3> ANY(0, 0);
constexpr double INF = std::numeric_limits<double>::infinity();

double gap(const Call& call, const Vector<3>& p) { return make_surface<3>(call)->foot(p, ANY).gap; }
void refuses(const Call& call, const std::string& message) {
  expect_invalid([&] { make_surface<3>(call); }, message);
}

} // namespace

TEST(ShapesInSpace, TheWordsDecideTheDimension) {
  for (const auto& call : shape_calls()) EXPECT_EQ(shape_dimension(call.arguments), 3) << call.name;
  for (const auto& call : {Call().number("circle", 1), Call().list("line", {0, 0, 1, 0}), Call(),
                           Call().list("chain", {0, 0, 0, 1, 0, 0}), Call().text("cad", "die.step")})
    EXPECT_EQ(shape_dimension(call), 2);
  // of a file alone its faces decide
  const std::string folder = "tests/support/cad/";
  for (const char* name : {"rounded.step", "ball.step"})
    EXPECT_EQ(shape_dimension(Call().text("cad", folder + name)), 3);
  for (const char* name : {"lobe.step", "circle.brep", "circle.geo"})
    EXPECT_EQ(shape_dimension(Call().text("cad", folder + name)), 2);
  EXPECT_EQ(shape_dimension(Call().text("cad", folder + "rounded.step").list("curves", {1})), 2);
  EXPECT_NEAR(make_surface<2>(Call().number("circle", 2))->foot({5, 0}, Param<2>(0.)).gap, 3, 1e-15);
}

TEST(ShapesInSpace, TheTableIsWhole) {
  for (const SurfaceKind& kind : surface_kinds()) {
    const std::string first = kind.parameters[0].name;
    EXPECT_EQ(kind.example.rfind(first + "=", 0), 0u) << kind.example;
    EXPECT_NE(shape_help().find(kind.example), std::string::npos);
    for (const Parameter& parameter : kind.parameters) {
      EXPECT_NE(shape_help().find(parameter.help), std::string::npos) << parameter.name;
      EXPECT_EQ(parameter.name.find('_'), std::string::npos) << "no name for a script";
      int types = 0;
      for (const Parameter& other : shape_parameters())
        if (other.name == parameter.name) types += other.kind == parameter.kind;
      EXPECT_EQ(types, 1) << parameter.name << " is of two types";
    }
  }
}

TEST(ShapesInSpace, EachKind) {
  EXPECT_NEAR(gap(Call().number("sphere", 2), {0, 3, 4}), 3, 1e-15);
  EXPECT_NEAR(gap(Call().number("sphere", 6).flag("inside"), {0, 3, 4}), 1, 1e-15);
  EXPECT_NEAR(gap(Call().number("cylinder", 2), {3, 4, 1e6}), 3, 1e-15);
  EXPECT_NEAR(gap(Call().number("cylinder", 2).list("axis", {7, 0, 0}), {1e3, 3, 4}), 3, 1e-12);
  const Call can = Call().number("cylinder", 2).number("length", 6).number("fillet", 0.5);
  EXPECT_NEAR(gap(can, {1, 1, 4}), 1, 1e-15) << "from z = -3 to 3";
  EXPECT_NEAR(gap(can, {0, 2, -3}), 0.5 * (std::sqrt(2.) - 1), 1e-15) << "off the rounded edge";
  const Call cone = Call().list("cone", {2, 1, 4}).number("fillet", 0.2);
  EXPECT_NEAR(gap(cone, {0, 0.5, 2.5}), 0.5, 1e-14);
  EXPECT_NEAR(gap(cone, {1.5, 0, 0}), 0, 1e-14) << "half-way up the slope";
  EXPECT_TRUE(make_surface<3>(cone)->closed());
  EXPECT_NEAR(gap(Call().list("torus", {3, 1}), {0, 5, 0}), 1, 1e-15);
  EXPECT_NEAR(gap(Call().list("plane", {0, 0, 1, 0, 0, 9}), {4, 5, 3}), 2, 1e-15);
  EXPECT_EQ(make_surface<3>(Call().list("plane", {0, 0, 1, 0, 0, 9}).number("size", 7))->length_scale(), 7);
  const Call box = Call().list("box", {2, 4, 6}).number("fillet", 0.5);
  for (const Vector<3>& p : {Vector<3>(2, 0, 0), Vector<3>(0, -3, 0), Vector<3>(0, 0, 4)})
    EXPECT_NEAR(gap(box, p), 1, 1e-15);
  EXPECT_NEAR(gap(box, {1, 2, 3}), 0.5 * (std::sqrt(3.) - 1), 1e-14);
  EXPECT_NEAR(gap(Call().text("cad", "tests/support/cad/rounded.step"), {0, 0, 3}), 1, 1e-12);
  EXPECT_NEAR(gap(Call().text("cad", "tests/support/cad/rounded.step").flag("inside"), {0, 0, 1}), 1, 1e-12);
  EXPECT_NEAR(gap(Call().text("cad", "tests/support/cad/ball.step").list("faces", {1}).number("scale", 2),
                  {0, 0, 12}),
              2, 1e-12);
  EXPECT_NEAR(gap(Call().number("circle", 2).flag("revolve"), {0, 3, 4}), 3, 1e-14);
  EXPECT_NEAR(gap(Call().list("line", {2, 1, 2, -1}).flag("revolve"), {3, 0, 0}), 1, 1e-15);
  EXPECT_NEAR(gap(Call().list("line", {0, 0, 4, 0}).flag("extrude"), {1, 2, 77}), 2, 1e-15);
  EXPECT_NEAR(gap(Call().number("circle", 2).flag("inside").flag("extrude"), {1, 0, 77}), 1, 1e-15);
  const Call bar = Call().list("line", {0, 0, 4, 0}).flag("extrude").number("length", 2);
  EXPECT_NEAR(gap(bar, {1, 3, 5}), 5, 1e-15) << "4 beyond its rim at z = 1";
  // the profile's plane turns with the axis: its x goes to -z, its y stays
  EXPECT_NEAR(gap(Call().list("line", {0, 0, 4, 0}).flag("extrude").list("axis", {1, 0, 0}), {77, 2, -1}), 2,
              1e-15);
  EXPECT_NEAR(gap(Call().list("line", {0, 0, 4, 0}).flag("extrude").list("axis", {0, 0, -3}), {1, -2, 77}), 2,
              1e-15);
}

// The tip of a cone is a ball that touches its slope.
TEST(ShapesInSpace, TheTipOfACone) {
  const double half_angle = std::atan(2. / 3), r = 0.3;
  const auto cone = make_surface<3>(Call().list("cone", {2, 0, 3}).number("fillet", r));
  EXPECT_TRUE(cone->closed());
  EXPECT_NEAR(cone->foot({0, 0, 2}, ANY).gap, 2 - (1.5 - r / std::sin(half_angle) + r), 1e-13);
  EXPECT_NEAR(cone->tightest_radius(), r, 1e-9);
  EXPECT_NEAR(cone->foot({1, 0, 0}, ANY).gap, 0, 1e-14) << "half-way up";
  const auto turned = make_surface<3>(Call().list("cone", {0, 2, 3}).number("fillet", r));
  EXPECT_NEAR(turned->foot({0, 0, -2}, ANY).gap, cone->foot({0, 0, 2}, ANY).gap, 1e-13);
}

TEST(ShapesInSpaceErrors, NoneOrSeveralOrOthersParameters) {
  const std::string surfaces =
      "sphere=R, cylinder=R, cone=[R1,R2,height], torus=[R,r], plane=[x0,y0,z0,nx,ny,nz], "
      "box=[a,b,c], revolve=true, extrude=true or faces=[1,2] with cad=\"file\"";
  expect_invalid([] { make_surface<2>(Call()); }, "cad=\"file\"; in space a surface: " + surfaces);
  refuses(Call().number("sphere", 1).number("cylinder", 1), "shape: give exactly one surface: " + surfaces);
  refuses(Call().number("sphere", 1).flag("revolve"), "shape: give exactly one surface");
  refuses(Call().number("sphere", 1).number("circle", 1), "shape: sphere= takes no circle=");
  refuses(Call().number("sphere", 1).number("fillet", 1), "shape: sphere= takes no fillet=");
  refuses(Call().list("plane", {0, 0, 0, 0, 0, 1}).flag("inside"),
          "shape: plane= takes no inside=; turn its normal");
  refuses(Call().list("box", {1, 1, 1}).list("axis", {0, 0, 1}), "shape: box= takes no axis=");
  refuses(Call().flag("revolve"), "shape: give exactly one profile");
  refuses(Call().flag("revolve").number("circle", 1).flag("closed"), "shape: circle= takes no closed=");
  refuses(Call().flag("revolve").number("circle", 1).number("length", 1), "shape: revolve= takes no length=");
  refuses(Call().flag("revolve", false).number("circle", 1), "revolve: revolve = false, expected true");
}

TEST(ShapesInSpaceErrors, Values) {
  refuses(Call().number("sphere", -1), "sphere: radius = -1, expected a finite number > 0");
  refuses(Call().number("cylinder", 0), "cylinder: radius = 0");
  refuses(Call().number("cylinder", 1).number("length", -2),
          "cylinder: length = -2, expected a finite number > 0");
  refuses(Call().number("cylinder", 1).number("fillet", 1),
          "cylinder: fillet= rounds the edges of the ends, and without length=");
  refuses(Call().list("cone", {1, 2}), "cone: number of values in cone = 2, expected 3");
  refuses(Call().list("cone", {-1, 2, 3}), "cone: value = -1, expected a finite number >= 0");
  refuses(Call().list("cone", {0, 0, 3}), "cone: larger radius = 0, expected > 0");
  refuses(Call().list("cone", {1, 2, 0}), "cone: height = 0");
  refuses(Call().list("torus", {1}), "torus: number of values in torus = 1");
  refuses(Call().list("torus", {1, 2}), "torus: radius of the tube = 2");
  refuses(Call().list("plane", {0, 0, 1}),
          "plane: number of values in plane = 3, expected 6: [x0,y0,z0,nx,ny,nz]");
  refuses(Call().list("plane", {0, 0, 0, 0, 0, 0}), "direction of the axis");
  refuses(Call().list("plane", {0, 0, 0, 0, 0, 1}).number("size", 0), "PlaneSurface: size = 0");
  refuses(Call().list("box", {1, 2}), "box: number of values in box = 2");
  refuses(Call().list("box", {1, 2, 0}), "box: side = 0");
  refuses(Call().number("cylinder", 1).list("axis", {1, 2}),
          "cylinder: number of values in axis = 2, expected 3: [x,y,z]");
  refuses(Call().number("cylinder", 1).list("axis", {0, 0, 0}), "cylinder: direction of the axis = 0 0 0");
  refuses(Call().flag("extrude").number("circle", 1).number("length", INF), "extrude: length = inf");
  refuses(Call().flag("extrude").number("circle", 1).number("fillet", 1),
          "extrude: fillet= rounds the edges of the ends");
  refuses(Call().flag("extrude").list("line", {0, 0, 1, 0}).number("length", 1).number("fillet", 1),
          "extrude: fillet= rounds the edges of a closed profile, and this one is open");
}

TEST(ShapesInSpaceErrors, SharpEdges) {
  refuses(Call().number("cylinder", 2).number("length", 3),
          "cylinder: the edge at r = 2, z = 1.5 is sharp: give it fillet = 0, expected > 0 and up to 1.5");
  refuses(Call().number("cylinder", 2).number("length", 6).number("fillet", 2.5),
          "cylinder: the edge at r = 2, z = 3 cannot have the radius fillet = 2.5, expected > 0 and up to 2");
  refuses(Call().list("box", {1, 2, 3}),
          "box: the edge at x = 0.5, y = 1 is sharp: give it fillet = 0, expected > 0 and up to 0.5");
  refuses(Call().list("cone", {2, 1, 4}),
          "cone: the edge at r = 2, z = -2 is sharp: give it fillet = 0, expected > 0 and up to 1.2");
  refuses(Call()
              .flag("extrude")
              .list("chain", {0, 0, 0.4, 4, 0, 0.4, 4, 3, 0.4, 0, 3, 0.4})
              .flag("closed")
              .number("length", 3),
          "z = 1.5 is sharp: give it fillet = 0, expected > 0 and up to 0.4");
  refuses(Call().flag("revolve").list("line", {2, 0, 0, 1}),
          "revolve: the profile meets the axis at y = 1 and not at a right angle: a tip without normal");
  refuses(Call().flag("revolve").list("chain", {2, 0, 0, 2, 1, 0, 0, 1, 0}),
          "ArcChain: point 1 at (2, 1) is a corner of 90 degrees");
}

// What the message names does fit.
TEST(ShapesInSpaceErrors, TheFilletOfTheMessageFits) {
  for (const Call& sharp :
       {Call().list("cone", {2, 1, 4}), Call().list("cone", {2, 0, 3}), Call().list("box", {1, 2, 3}),
        Call().number("circle", 1.7).flag("extrude").number("length", 9)}) {
    double most = 0;
    try {
      make_surface<3>(sharp);
      FAIL() << "has no fillet";
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      most = std::stod(text.substr(text.rfind(' ')));
    }
    EXPECT_GT(most, 0.1);
    EXPECT_NO_THROW(make_surface<3>(Call(sharp).number("fillet", most)));
    EXPECT_THROW(make_surface<3>(Call(sharp).number("fillet", 1.001 * most)), std::invalid_argument);
  }
}
