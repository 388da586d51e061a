// Files of a run in space, read back: tetrahedra in VTK's order of nodes, tensors, contact surface, tools, supports, summary.
#include "material/user_law.hpp"
#include "output/contact_files.hpp"
#include "output/summary.hpp"
#include "output/workpiece_file.hpp"
#include "run/workpiece_tangent.hpp"
#include "support/pressed_body.hpp"
#include "support/vtk_reader.hpp"
#include <gtest/gtest.h>

using namespace burnish;
using namespace burnish::test;

namespace {

using Numbers = std::vector<double>;
using Indices = std::vector<std::int64_t>;

Vector<3> at(const Numbers& numbers, std::int64_t i) {
  return Eigen::Map<const Vector<3>>(numbers.data() + 3 * i);
}

/// The plane pressed by 0.1 and drawn along by (0.05, 0.025); all three nodes of the top stick.
struct Pressed : PressedPrism {
  Pressed() : PressedPrism(50) {
    contact->approach(0, "z", u);
    const Vector<3> end(0.05, 0.025, 0.9);
    for (int i = 0; i < 3; ++i) tool->prescription().move(tool->prescription().names()[i], end[i]);
    contact->begin(u, 0, 1, Stepping::IMPLICIT);
    StepStatus status = StepStatus::ITERATE;
    for (int i = 0; status != StepStatus::CONVERGED && status != StepStatus::FAILED; ++i) status = iterate(i);
    EXPECT_EQ(status, StepStatus::CONVERGED);
    body.accept();
    contact->accept(u, R, {});
  }

private:
  StepStatus iterate(int i) {
    if (body.workpiece().update(u, 1, i).status != UpdateStatus::OK) return StepStatus::FAILED;
    R = body.workpiece().internal_force();
    const StepStatus status = contact->check(u, R);
    if (status == StepStatus::REFACTORIZE && !factorize_tangent(*contact, body.workpiece(), u))
      return StepStatus::FAILED;
    if (status == StepStatus::CONVERGED || status == StepStatus::FAILED) return status;
    return contact->correct(u, R) == StepStatus::FAILED ? StepStatus::FAILED : status;
  }
};

} // namespace

TEST(FilesInSpace, QuadraticTetrahedraInTheOrderOfVtk) {
  const Discretization<3> mesh = two_tetrahedra(10);
  Eigen::VectorXd u(mesh.num_dofs());
  for (int i = 0; i < u.size(); ++i) u[i] = 0.1 * i;
  const VtkReader file([&](const std::string& path) { save_displacement(mesh, u, path); });
  EXPECT_EQ(file.array<std::uint8_t>("types"), std::vector<std::uint8_t>(2, 24));
  EXPECT_EQ(file.array<std::int64_t>("offsets"), (Indices{10, 20}));
  EXPECT_EQ(file.array<double>("Points"), mesh.X);
  EXPECT_EQ(file.array<double>("displacement"), Numbers(u.data(), u.data() + u.size()));
  // VTK's user guide: nodes 4 to 9 of VTK_QUADRATIC_TETRA lie between these
  const int ends[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  const Indices nodes = file.array<std::int64_t>("connectivity");
  for (int e = 0; e < 2; ++e)
    for (int k = 0; k < 6; ++k) {
      const std::int64_t* cell = nodes.data() + 10 * e;
      const Vector<3> middle = (at(mesh.X, cell[ends[k][0]]) + at(mesh.X, cell[ends[k][1]])) / 2;
      EXPECT_LE((at(mesh.X, cell[4 + k]) - middle).norm(), 1e-14) << e << " " << k;
    }
}

// Uniform strain: the Kirchhoff stress F S F' at all nodes, in ParaView's order, the Cauchy stress over det F.
TEST(FilesInSpace, StressTensorOfUniformStrain) {
  const Discretization<3> mesh = two_tetrahedra(10);
  const auto law = std::make_shared<KirchhoffLaw>(3, 2);
  Workpiece<3> body(mesh, law);
  Tensor<3> F;
  F << 1.1, 0.02, -0.03, 0.05, 0.9, 0.04, 0.01, 0.06, 1.05;
  Eigen::VectorXd u(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) u.segment<3>(3 * a) = (F - Tensor<3>::Identity()) * mesh.node(a);
  ASSERT_EQ(body.update(u, 1, 0).status, UpdateStatus::OK);
  body.accept();
  const VtkReader file([&](const std::string& path) { save_fields(body, path); });
  const Tensor<3> tau = F * law->second_piola(F) * F.transpose();
  const Numbers stress = file.array<double>("stress"), cauchy = file.array<double>("cauchy");
  const int rows[6] = {0, 1, 2, 0, 1, 0}, columns[6] = {0, 1, 2, 1, 2, 2};
  ASSERT_EQ(stress.size(), 6u * mesh.num_nodes);
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const double expected = tau(rows[i % 6], columns[i % 6]);
    EXPECT_NEAR(stress[i], expected, 1e-13) << i;
    EXPECT_NEAR(cauchy[i], expected / F.determinant(), 1e-13) << i;
  }
  for (const double zx : file.array<double>("stress_zx")) EXPECT_NEAR(zx, tau(2, 0), 1e-13);
  EXPECT_THROW(file.array<double>("plastic_strain_eq"), std::out_of_range);
}

// One linear triangle: the tractions, times a third of its present area each, add up to the force of the tool.
TEST(FilesInSpace, TractionsOfTheContactSurface) {
  const Pressed scene;
  const VtkReader file([&](const std::string& path) { save_surface(*scene.contact, path); });
  EXPECT_NE(file.text().find("NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"1\""),
            std::string::npos);
  EXPECT_EQ(file.array<std::int64_t>("connectivity"), (Indices{0, 1, 2}));
  EXPECT_EQ(file.array<std::int64_t>("state"), Indices(3, static_cast<std::int64_t>(NodeState::STICKING)));
  const Numbers p = file.array<double>("pressure"), shear = file.array<double>("traction_tangential"),
                traction = file.array<double>("traction");
  Vector<3> sum = Vector<3>::Zero();
  for (int i = 0; i < 3; ++i) {
    EXPECT_LE((at(file.array<double>("displacement"), i) - Vector<3>(0.05, 0.025, -0.1)).norm(), 1e-9);
    EXPECT_LE((at(traction, i) - at(shear, i) + p[i] * Vector<3>::UnitZ()).norm(), 1e-13) << i;
    EXPECT_NEAR(at(shear, i)[2], 0, 1e-13);
    sum += 0.5 / 3 * at(traction, i);
  }
  EXPECT_LE((sum - scene.tool->generalized_force()).norm() / sum.norm(), 1e-9);
  EXPECT_GT(sum.head<2>().norm(), 1e-2);
}

TEST(FilesInSpace, ToolsAndSupports) {
  const Pressed scene;
  const VtkReader tools(
      [&](const std::string& path) { save_tools(*scene.setup, scene.contact->accepted().u, path); });
  const Numbers points = tools.array<double>("Points");
  double low = 0, high = 0;
  for (std::size_t i = 0; i < points.size() / 3; ++i) {
    EXPECT_NEAR(points[3 * i + 2], 0.9, 1e-12) << i;
    low = std::min(low, points[3 * i]);
    high = std::max(high, points[3 * i]);
  }
  EXPECT_LE(low, -0.4) << "beyond the workpiece, which is 1.05 wide";
  EXPECT_GE(high, 1.4);
  const Indices triangles = tools.array<std::int64_t>("connectivity");
  EXPECT_EQ(tools.array<std::int64_t>("tool"), Indices(triangles.size() / 3, 0));
  EXPECT_LE((at(tools.array<double>("origin"), 0) - Vector<3>(0.05, 0.025, 0.9)).norm(), 1e-14);
  const VtkReader supports([&](const std::string& path) { save_supports(*scene.contact, path); });
  EXPECT_EQ(supports.array<double>("fixed"), Numbers(9, 1.));
  EXPECT_EQ(supports.array<double>("Points"), Numbers(scene.mesh.X.begin(), scene.mesh.X.begin() + 9));
}

// Resultants have six numbers, of the force and of the moment; those of supports and tool cancel.
TEST(FilesInSpace, Summary) {
  const Pressed scene;
  const Workpiece<3> body(scene.mesh, std::make_shared<UserLaw<3>>());
  const Diagnosis<3> diagnosis;
  const StepControl control(0, {});
  const Vector<3> about(1, 2, 3);
  const Json summary = run_summary(
      SummarizedRun<3>{*scene.contact, body, diagnosis, control, nullptr, {}, nullptr, "", false, about, {}});
  const Json balance = summary["balance"];
  EXPECT_EQ(balance["moment_point"], Json::parse("[1.0, 2.0, 3.0]"));
  const Numbers support = balance["support"], tool = balance["contact"]["plane"];
  ASSERT_EQ(support.size(), 6u);
  Vector<3> moment = Vector<3>::Zero();
  for (int a = 3; a < 6; ++a)
    moment += (scene.mesh.node(a) + scene.u.segment<3>(3 * a) - about).cross(scene.R.segment<3>(3 * a));
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(support[i], -tool[i], 1e-9) << i;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(tool[3 + i], moment[i], 1e-12) << i;
  EXPECT_NEAR(summary["final"]["Q_z"], scene.tool->generalized_force()[2], 1e-15);
  EXPECT_EQ(summary["final"]["sticking"], 3);
}
