#pragma once
// A workpiece, a contact and one tool, as a script holds them, for tests that take whole steps.
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/polar.hpp"
#include "material/j2/law.hpp"
#include "run/contact_motion.hpp"
#include "run/run_body.hpp"
#include "run/seen_step.hpp"
#include "support/profile_tool.hpp"
#include "support/structured_mesh.hpp"

namespace burnish::test {

struct Scene {
  std::shared_ptr<ContactSetup<2>> setup;
  std::shared_ptr<DrivenTool<2>> tool; ///< the one added last
  RunBody<2> body;
  Diagnosis<2> diagnosis;
  NodeBlockMatrix<2> tangent;
  Eigen::VectorXd u, R;

  Scene(const ContactMesh& mesh, const J2Parameters& material, const IterationOptions& options = {},
        const UpdateOptions& update = {})
      : setup(std::make_shared<ContactSetup<2>>(mesh.space, mesh.surface, mesh.fixed,
                                                std::make_shared<EdgeMeasure>(mesh.space.axisymmetric))),
        body(std::make_unique<Workpiece<2>>(mesh.space, j2_law<2>(material), update)),
        tangent(body.workpiece().pattern()), u(Eigen::VectorXd::Zero(mesh.space.num_dofs())), R(u),
        m_options(options) {}
  void add_tool(std::shared_ptr<const Profile<2>> profile, std::shared_ptr<const Coordinates<2>> coordinates,
                double mu) {
    tool = driven_tool("tool", std::move(profile), std::move(coordinates));
    setup->add_tool(tool, make_coulomb(mu));
  }
  void place(const std::vector<double>& q) {
    for (std::size_t k = 0; k < q.size(); ++k) tool->place(tool->prescription().names()[k], q[k]);
  }
  Workpiece<2>& workpiece() { return body.workpiece(); }
  /// Why the last step failed.
  std::string why() { return reason<2>(contact(), diagnosis, &workpiece()); }
  /// The first call closes the setup.
  ContactRun<2>& contact() {
    if (!m_contact) m_contact = std::make_unique<ContactRun<2>>(setup, m_options);
    return *m_contact;
  }

private:
  IterationOptions m_options;
  std::unique_ptr<ContactRun<2>> m_contact;
};

/// Elastic steel-like body: the yield stress is out of reach. Unit modulus G.
inline J2Parameters elastic_material() { return J2Parameters::from_shear(1, 0.3, 1e3, 0); }

} // namespace burnish::test
