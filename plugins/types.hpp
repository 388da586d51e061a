#pragma once
// The three script types and what they hold.
#include "base/cpu_time.hpp"
#include "kinematics/driven_tool.hpp"
#include "plugin.hpp"
#include "stepping/session.hpp"
#include "workpiece/point_events.hpp"

#include <map>

namespace burnish {

struct ToolObject {
  static constexpr const char* TYPE = "tool";
  bool added = false;                       // to a contact: the coordinates stay
  std::map<std::string, double> parameters; // of the formulas
  std::shared_ptr<DrivenTool<2>> tool;
};
struct MaterialObject {
  static constexpr const char* TYPE = "material";
  std::unique_ptr<Workpiece<2>> body;
  NodeBlockMatrix<2> tangent;
  std::vector<ElementEvent<2>> pending;     // found by events(), used by acceptevents() and logevents()
  PointEvents<2> user_events;               // by the script's formulas
  std::map<std::string, double> parameters; // numbers by name for them
  double update_seconds = 0, assembly_seconds = 0; // CPU
};
struct ContactObject {
  static constexpr const char* TYPE = "contact";
  /// What the step under way has seen: the order of calls is begin, check, correct..., accept or revert.
  enum Stage { NO_STEP, BEGUN, CHECKED } stage = NO_STEP;
  std::unique_ptr<Session<2>> session;
  std::shared_ptr<const FrictionLaw> friction; // default of add()
  std::map<std::string, double> parameters;    // numbers by name for formulas of friction
  std::map<long, std::vector<Facet<2>>> edges; // by boundary label
  TripletReader<2> reader;
  std::vector<ContactEvent<2>> pending;           // found by events(), applied by accept() or switchstates()
  std::vector<double> rhs;                        // of the last condensed matrix
  double event_seconds = 0, condense_seconds = 0; // CPU
};

/// @throws std::invalid_argument "where: call ... first" unless the step has got that far
void require_stage(const ContactObject& contact, ContactObject::Stage stage, const char* where);

using ToolHandle = Handle<ToolObject>;
using MaterialHandle = Handle<MaterialObject>;
using ContactHandle = Handle<ContactObject>;

/// Reference nodes, elements and boundary edges of a [P1,P1] or [P2,P2] space on a 2D mesh; the dofs of a node must be
/// adjacent.
/// @throws std::invalid_argument for any other space
burnish::Mesh<2> mesh_of(pfes* const& space, const char* where, bool axisymmetric);

/// "complete", "article" or "none". @throws std::invalid_argument for another name
GeometricTerms terms_of(const std::string& name);

} // namespace burnish
