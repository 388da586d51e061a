#pragma once
// A plane that slides in space and a small elastic body below it.
#include "geometry/plane_surface.hpp"
#include "kinematics/driven_tool.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "run/contact_run.hpp"
#include "run/run_body.hpp"
#include "support/kirchhoff_law.hpp"
#include "support/tetrahedra.hpp"

namespace burnish::test {

/// A prism of three tetrahedra, clamped below, its top triangle under the plane.
inline Discretization<3> prism() {
  Mesh<3> mesh = linear_tetrahedra({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1},
                                   {0, 1, 2, 3, 1, 2, 3, 4, 2, 3, 4, 5});
  mesh.facets = {{{3, 4, 5}, {-1, -1, -1}, 2, 1}};
  return tetrahedra(mesh);
}

struct PressedPrism {
  Discretization<3> mesh = prism();
  std::vector<char> fixed = std::vector<char>(18, 0);
  std::shared_ptr<DrivenTool<3>> tool = std::make_shared<DrivenTool<3>>(
      "plane", std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, -1), 1));
  std::shared_ptr<ContactSetup<3>> setup;
  std::unique_ptr<ContactRun<3>> contact;
  RunBody<3> body{std::make_unique<Workpiece<3>>(mesh, std::make_shared<KirchhoffLaw>(3, 2))};
  NodeBlockMatrix<3> K = body.workpiece().pattern();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(18), R = u;

  static std::shared_ptr<const Coordinates<3>> place() {
    return std::make_shared<FormulaCoordinates<3>>("plane", std::vector<std::string>{"x", "y", "z"},
                                                   SpaceFormulas{"x", "y", "z"});
  }
  explicit PressedPrism(double mu, std::shared_ptr<const Coordinates<3>> coordinates = place()) {
    std::fill(fixed.begin(), fixed.begin() + 9, 1);
    IterationOptions options;
    options.tolerance = 1e-11;
    options.offset_tolerance = 1e-10;
    options.gap_tolerance = 1e-9;
    options.max_iterations = 60;
    setup = std::make_shared<ContactSetup<3>>(mesh, mesh.facets, fixed, std::make_shared<FaceMeasure>());
    tool->set_coordinates(std::move(coordinates));
    tool->place("z", 1.1);
    setup->add_tool(tool, make_coulomb(mu));
    contact = std::make_unique<ContactRun<3>>(setup, options);
  }
};

} // namespace burnish::test
