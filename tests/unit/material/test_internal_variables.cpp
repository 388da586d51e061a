#include "material/internal_variables.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using burnish::test::expect_invalid;

namespace {
const std::vector<InternalVariable> LIST = {{"plastic_strain_eq", "ep", "-", TensorKind::SCALAR, 0},
                                            {"back_stress", "", "stress", TensorKind::SYMMETRIC, 0},
                                            {"integrity", "D", "-", TensorKind::SCALAR, 1}};
}

TEST(InternalVariables, PlacesAndInitialValues) {
  const InternalVariables<2> plane(LIST);
  const InternalVariables<3> space(LIST);
  EXPECT_EQ(plane.size(), 6);
  EXPECT_EQ(space.size(), 8);
  EXPECT_EQ(plane.offset(plane.find("back_stress")), 1);
  EXPECT_EQ(plane.offset(plane.find("integrity")), 5);
  EXPECT_EQ(space.offset(space.find("integrity")), 7);
  EXPECT_EQ(plane.find("damage"), -1);
  EXPECT_EQ(plane.initial(), std::vector<double>({0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(plane.names(), "plastic_strain_eq, back_stress, integrity");
  EXPECT_EQ(InternalVariables<2>().names(), "none");
  EXPECT_EQ(InternalVariables<2>().size(), 0);
}

TEST(InternalVariables, Errors) {
  expect_invalid(
      [] {
        InternalVariables<2>({{"", "", "-"}});
      },
      "InternalVariables: name = , expected a name, and each once");
  expect_invalid(
      [] {
        InternalVariables<2>({{"damage", "D", "-"}, {"damage", "", "-"}});
      },
      "InternalVariables: name = damage, expected a name, and each once");
}
