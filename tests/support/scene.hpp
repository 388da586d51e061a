#pragma once
// A workpiece, a session and one tool, as a script holds them, for tests that take whole steps.
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/polar.hpp"
#include "material/j2/law.hpp"
#include "stepping/session.hpp"
#include "support/structured_mesh.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish::test {

struct Scene {
  std::shared_ptr<DrivenTool<2>> tool;
  Workpiece<2> workpiece;
  Session<2> session;
  NodeBlockMatrix<2> tangent;
  Eigen::VectorXd u, R;

  Scene(const ContactMesh& mesh, const J2Parameters& material, const StepOptions& options = {},
        const UpdateOptions& update = {})
      : workpiece(mesh.space, j2_law<2>(material), update),
        session(mesh.space, mesh.surface, mesh.fixed, options), tangent(workpiece.pattern()),
        u(Eigen::VectorXd::Zero(mesh.space.num_dofs())), R(u) {}
  void add_tool(std::shared_ptr<const Profile<2>> profile, std::shared_ptr<const Coordinates<2>> coordinates,
                double mu) {
    tool = std::make_shared<DrivenTool<2>>("tool", std::move(profile));
    tool->set_coordinates(std::move(coordinates));
    session.add_tool(tool, make_coulomb(mu));
  }
  void place(const std::vector<double>& q) {
    for (std::size_t k = 0; k < q.size(); ++k) tool->place(tool->prescription().names()[k], q[k]);
  }
};

/// Elastic steel-like body: the yield stress is out of reach. Unit modulus G.
inline J2Parameters elastic_material() { return J2Parameters::from_shear(1, 0.3, 1e3, 0); }

} // namespace burnish::test
