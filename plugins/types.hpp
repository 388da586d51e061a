#pragma once
// The script types and what they hold.
#include "base/cpu_time.hpp"
#include "contact/matrix_check.hpp"
#include "kinematics/driven_tool.hpp"
#include "plugin.hpp"
#include "run/contact_motion.hpp"
#include "run/run_body.hpp"
#include "run/run_stiffness.hpp"
#include "run/seen_step.hpp"

#include <map>

namespace burnish {

struct ContactObject;
struct ToolObject {
  static constexpr const char* TYPE = "tool";
  bool added = false; // to a contact: the coordinates stay
  std::shared_ptr<DrivenTool<2>> tool;
  std::weak_ptr<ContactObject> contact; // that it was added to
};
struct MaterialObject {
  static constexpr const char* TYPE = "material";
  std::unique_ptr<RunBody<2>> body;
  std::map<std::string, double> parameters;        // numbers by name for formulas of user-defined events
  double update_seconds = 0, assembly_seconds = 0; // CPU
  std::vector<double> moduli;                      // the last that were read, while nothing has changed
  double moduli_blend = -1;                        // -1: they are out of date
  std::shared_ptr<const ::Mesh> mesh;              // FreeFEM's
  std::uint64_t fingerprint = 0;                   // of the mesh
  std::string warnings;                            // of its numbers, one line each
  Workpiece<2>& workpiece() { return body->workpiece(); }
  /// The body, to be changed: what was read of it is out of date.
  RunBody<2>& changed() {
    moduli_blend = -1;
    return *body;
  }
};
/// What the verbs of a step have seen of it.
struct StepSeen {
  bool rates = false, converged = false;
  Eigen::VectorXd u; // where it converged
};
struct ContactObject {
  static constexpr const char* TYPE = "contact";
  std::shared_ptr<ContactSetup<2>> setup;
  IterationOptions options;               // of the run, until it is begun
  std::weak_ptr<MaterialObject> material; // of its run
  Diagnosis<2> diagnosis;
  std::shared_ptr<const FrictionLaw> friction; // default of add()
  std::map<std::string, double> parameters;    // numbers by name for formulas of friction
  TripletReader<2> reader;
  std::vector<ContactEvent<2>> pending;           // found by events(), applied by accept() or acceptevents()
  std::vector<double> rhs;                        // of the last condensed matrix
  const CondensedSystem* condensed = nullptr;     // the last one, the run's
  double event_seconds = 0, condense_seconds = 0; // CPU
  StepSeen step;
  bool under_way = false; // a run of a stepcontrol goes on
  MatrixCheck matrices;
  std::unique_ptr<RunStiffness<2>> stiffness; // of the run, made when it is asked for
  /// @throws std::invalid_argument "where: ..." unless the material is on the contact's mesh
  void require_same_mesh(MaterialObject& material, const char* where);
  /// The same for a matrix of a script, which is returned by node blocks.
  const NodeBlockMatrix<2>& blocks(const TripletView& K, const char* where);
  /// Whose solver keeps the factors to come. @param solver of FreeFEM; empty: the core's
  /// @returns whether it needs a symmetric tangent
  /// @throws std::invalid_argument "where: ..." for an unknown solver
  bool take_solver(const std::string& solver, Stack stack, const char* where);
  /// The run, begun by the first call: the setup is closed then.
  ContactRun<2>& run();
  bool started() const { return m_run != nullptr; }
  /// CPU of factors, dense blocks and solves of the run.
  double linear_seconds() const;
  /// @throws std::invalid_argument "where: ..." before the first step or approach
  const ContactRun<2>& running(const char* where) const;

private:
  std::string m_solver; // of the factors
  std::unique_ptr<ContactRun<2>> m_run;
};

using ToolHandle = Handle<ToolObject>;
using MaterialHandle = Handle<MaterialObject>;
using ContactHandle = Handle<ContactObject>;

/// Reference nodes, elements and boundary edges of a [P1,P1] or [P2,P2] space on a 2D mesh; the dofs of a node must be
/// adjacent.
/// @throws std::invalid_argument for any other space
burnish::Mesh<2> mesh_of(pfes* const& space, const char* where, bool axisymmetric);

/// FreeFEM's mesh of the space, shared with the script. @throws std::invalid_argument for an empty space
std::shared_ptr<const ::Mesh> shared_mesh(pfes* const& space, const char* where);

} // namespace burnish
