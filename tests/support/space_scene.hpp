#pragma once
// An elastic block of tetrahedra in space, clamped below, and one tool of any surface and coordinates.
#include "geometry/plane_surface.hpp"
#include "geometry/simple_surfaces.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "material/make_law.hpp"
#include "run/contact_run.hpp"
#include "run/run_body.hpp"
#include "run/workpiece_tangent.hpp"
#include "support/pressed_body.hpp"
#include "unit/material/in_space.hpp"
#include <gtest/gtest.h>

namespace burnish::test {

/// Cells along x, y, z of a block of these sides, its top at z = 0, all of it turned about the origin.
struct BlockOfTetrahedra {
  int nx = 4, ny = 4, nz = 2;
  double lx = 2, ly = 2, lz = 1;
  Tensor<3> turn = Tensor<3>::Identity();

  Discretization<3> mesh() const {
    Mesh<3> mesh = block_of_tetrahedra(nx, ny, nz, [&](double x, double y, double z) {
      return Vector<3>(turn * Vector<3>(lx * (x - 0.5), ly * (y - 0.5), lz * (z - 1)));
    });
    for (int e = 0; e < mesh.num_elements; ++e)
      for (int v = 0; v < 4; ++v) { // the face opposite a vertex, seen from outside
        constexpr int face[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        const int* n = mesh.element(e);
        const std::array<int, 3> corner{n[face[v][0]], n[face[v][1]], n[face[v][2]]};
        if (std::all_of(corner.begin(), corner.end(), [&](int a) { return height(mesh, a) > -1e-9; }))
          mesh.facets.push_back({corner, {-1, -1, -1}, e, 1});
      }
    return tetrahedra(mesh);
  }
  double height(const Mesh<3>& mesh, int a) const { return (turn.transpose() * mesh.node(a))[2]; }
};

inline IterationOptions tight_options_in_space() {
  IterationOptions options;
  options.tolerance = 1e-11;
  options.offset_tolerance = 1e-9;
  options.gap_tolerance = 1e-7;
  options.max_iterations = 80;
  return options;
}

struct SpaceScene {
  Discretization<3> mesh;
  std::shared_ptr<DrivenTool<3>> tool;
  std::shared_ptr<ContactSetup<3>> setup;
  std::unique_ptr<ContactRun<3>> contact;
  RunBody<3> body;
  Eigen::VectorXd u, R;

  /// Elastic of E = 1, nu = 0.3.
  SpaceScene(const BlockOfTetrahedra& block, std::shared_ptr<const Surface<3>> surface,
             std::shared_ptr<const Coordinates<3>> coordinates, double mu,
             const IterationOptions& options = tight_options_in_space())
      : mesh(block.mesh()), tool(std::make_shared<DrivenTool<3>>("tool", std::move(surface))),
        body(std::make_unique<Workpiece<3>>(
            mesh, make_law<3>({{{"E", 1}, {"nu", 0.3}, {"sigY", 1e9}, {"H", 0}}}, "test"))),
        u(Eigen::VectorXd::Zero(mesh.num_dofs())), R(u) {
    std::vector<char> fixed(mesh.num_dofs(), 0);
    for (int a = 0; a < mesh.num_nodes; ++a)
      if (block.height(mesh, a) < 1e-9 - block.lz) std::fill_n(fixed.begin() + 3 * a, 3, 1);
    setup = std::make_shared<ContactSetup<3>>(mesh, mesh.facets, fixed, std::make_shared<FaceMeasure>());
    tool->set_coordinates(std::move(coordinates));
    setup->add_tool(tool, make_coulomb(mu));
    m_options = options;
  }
  void place(const Eigen::VectorXd& q) {
    for (Eigen::Index k = 0; k < q.size(); ++k) tool->place(names()[k], q[k]);
  }
  const std::vector<std::string>& names() const { return tool->tool().coordinates().names(); }
  void start() { contact = std::make_unique<ContactRun<3>>(setup, m_options); }
  void move(const Eigen::VectorXd& q) {
    for (Eigen::Index k = 0; k < q.size(); ++k) tool->prescription().move(names()[k], q[k]);
  }

  /// One implicit step.
  void step(double t, double dt) {
    contact->begin(u, t, dt, Stepping::IMPLICIT);
    StepStatus status = StepStatus::ITERATE;
    Workpiece<3>& workpiece = body.workpiece();
    for (int it = 0; status != StepStatus::CONVERGED; ++it) {
      ASSERT_EQ(workpiece.update(u, dt, it).status, UpdateStatus::OK) << "t = " << t << ", iteration " << it;
      R = workpiece.internal_force();
      status = contact->check(u, R);
      if (status == StepStatus::REFACTORIZE) {
        ASSERT_TRUE(factorize_tangent(*contact, workpiece, u));
      }
      ASSERT_NE(status, StepStatus::FAILED) << "t = " << t << ", iteration " << it;
      if (status == StepStatus::ITERATE || status == StepStatus::REFACTORIZE) {
        ASSERT_NE(contact->correct(u, R), StepStatus::FAILED) << "t = " << t << ", iteration " << it;
      }
    }
    body.accept();
    contact->accept(u, R, {});
  }
  Vector<3> force_on_body() const { // of the tool
    Vector<3> sum = Vector<3>::Zero();
    const auto& nodes = contact->accepted().contact.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (in_contact(nodes[i].state)) sum += R.segment<3>(3 * setup->model().candidates[i]);
    return sum;
  }

private:
  IterationOptions m_options;
};

inline Eigen::VectorXd numbers(std::initializer_list<double> list) {
  return Eigen::Map<const Eigen::VectorXd>(list.begin(), static_cast<Eigen::Index>(list.size()));
}

} // namespace burnish::test
