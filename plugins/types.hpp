#pragma once
// The script types and what they hold. A tool, contact or material is of the plane or of space, which its shape or its fespace
// decides; one script type is both.
#include "base/cpu_time.hpp"
#include "base/error.hpp"
#include "contact/matrix_check.hpp"
#include "kinematics/driven_tool.hpp"
#include "plugin.hpp"
#include "run/contact_motion.hpp"
#include "run/run_body.hpp"
#include "run/run_stiffness.hpp"
#include "run/seen_step.hpp"

#include <functional>
#include <map>
#include <set>

namespace burnish {

/// FreeFEM's meshes and spaces by dimension.
template <int Dim> struct Freefem;
template <> struct Freefem<2> {
  using Mesh = ::Mesh;
  using Space = FESpace;
  using Fespace = pfes;
};
template <> struct Freefem<3> {
  using Mesh = ::Mesh3;
  using Space = FESpace3;
  using Fespace = pfes3;
};

struct OfDimension {
  const int dimension; // 2 or 3
  explicit OfDimension(int dim) : dimension(dim) {}
  virtual ~OfDimension() = default;
};
inline const char* name_of_dimension(int dimension) { return dimension == 2 ? "the plane" : "space"; }

template <int> struct ToolOf;
template <int> struct MaterialOf;
template <int> struct ContactOf;
struct ContactObject;

struct ToolObject : OfDimension {
  static constexpr const char* TYPE = "tool";
  template <int Dim> using Of = ToolOf<Dim>;
  using OfDimension::OfDimension;
  bool added = false;                   // to a contact: the coordinates stay
  std::weak_ptr<ContactObject> contact; // that it was added to
};
template <int Dim> struct ToolOf final : ToolObject {
  static constexpr int DIM = Dim;
  ToolOf() : ToolObject(Dim) {}
  std::shared_ptr<DrivenTool<Dim>> tool;
};

/// Names of tools that the script has moved or loaded, and that no contact has so far: C.add forgotten.
std::set<std::string>& tools_of_no_contact();

struct MaterialObject : OfDimension {
  static constexpr const char* TYPE = "material";
  template <int Dim> using Of = MaterialOf<Dim>;
  using OfDimension::OfDimension;
  std::map<std::string, double> parameters;        // numbers by name for formulas of user-defined events
  double update_seconds = 0, assembly_seconds = 0; // CPU
  std::vector<double> moduli;                      // the last that were read, while nothing has changed
  double moduli_blend = -1;                        // -1: they are out of date
  std::uint64_t fingerprint = 0;                   // of the mesh
  std::string warnings;                            // of its numbers, one line each
};
template <int Dim> struct MaterialOf final : MaterialObject {
  static constexpr int DIM = Dim;
  MaterialOf() : MaterialObject(Dim) {}
  std::unique_ptr<RunBody<Dim>> body;
  std::shared_ptr<const typename Freefem<Dim>::Mesh> mesh; // FreeFEM's
  Workpiece<Dim>& workpiece() { return body->workpiece(); }
  const Workpiece<Dim>& workpiece() const { return body->workpiece(); }
  /// The body, to be changed: what was read of it is out of date.
  RunBody<Dim>& changed() {
    moduli_blend = -1;
    return *body;
  }
};

/// What the verbs of a step have seen of it.
struct StepSeen {
  bool rates = false, converged = false;
  Eigen::VectorXd u; // where it converged
};
struct ContactObject : OfDimension {
  static constexpr const char* TYPE = "contact";
  template <int Dim> using Of = ContactOf<Dim>;
  using OfDimension::OfDimension;
  IterationOptions options;                       // of the run, until it is begun
  std::weak_ptr<MaterialObject> material;         // of its run
  std::shared_ptr<const FrictionLaw> friction;    // default of add()
  std::map<std::string, double> parameters;       // numbers by name for formulas of friction
  std::vector<double> rhs;                        // of the last condensed matrix
  const CondensedSystem* condensed = nullptr;     // the last one, the run's
  double event_seconds = 0, condense_seconds = 0; // CPU
  StepSeen step;
  bool under_way = false; // a run of a stepcontrol goes on
  MatrixCheck matrices;
  std::string solver;                      // of the factors
  std::vector<std::function<void()>> runs; // what ends those of stepcontrols that refer to the run
  /// Before the run is replaced: no stepcontrol refers to it any more.
  void end_runs() {
    for (const auto& end : runs) end();
    runs.clear();
  }
};
template <int Dim> struct ContactOf final : ContactObject {
  static constexpr int DIM = Dim;
  ContactOf() : ContactObject(Dim) {}
  std::shared_ptr<ContactSetup<Dim>> setup;
  Diagnosis<Dim> diagnosis;
  TripletReader<Dim> reader;
  std::vector<ContactEvent<Dim>> pending;       // found by events(), applied by accept() or acceptevents()
  std::unique_ptr<RunStiffness<Dim>> stiffness; // of the run, made when it is asked for
  /// The material as one of this dimension. @throws std::invalid_argument "where: ..." unless it is on the contact's mesh
  MaterialOf<Dim>& with_material(MaterialObject& material, const char* where) const;
  /// The same for a matrix of a script, which is returned by node blocks.
  const NodeBlockMatrix<Dim>& blocks(const TripletView& K, const char* where);
  /// Whose solver keeps the factors to come. @param name of FreeFEM's; empty: the core's
  /// @returns whether it needs a symmetric tangent
  /// @throws std::invalid_argument "where: ..." for an unknown solver
  bool take_solver(const std::string& name, Stack stack, const char* where);
  /// The run, begun by the first call: the setup is closed then.
  ContactRun<Dim>& run();
  bool started() const { return m_run != nullptr; }
  /// Another problem and its run in place of this one; nothing may refer to the run.
  void replace(std::shared_ptr<ContactSetup<Dim>> other, std::unique_ptr<ContactRun<Dim>> run_of_it);
  /// CPU of factors, dense blocks and solves of the run.
  double linear_seconds() const;
  /// @throws std::invalid_argument "where: ..." before the first step or approach
  const ContactRun<Dim>& running(const char* where) const;

private:
  std::unique_ptr<ContactRun<Dim>> m_run;
};

/// Dimension of a ToolOf, MaterialOf or ContactOf by the type of a reference to it.
template <class Reference> constexpr int dim_of = std::decay_t<Reference>::DIM;

/// f of the object as one of its dimension.
template <class Object, class F> auto visit(Object& object, F&& f) {
  if (object.dimension == 2) return f(static_cast<typename Object::template Of<2>&>(object));
  return f(static_cast<typename Object::template Of<3>&>(object));
}
/// f of what the script variable holds, within the error frame.
template <class Object, class F> auto on(const Handle<Object>* handle, F&& f) {
  return guarded([&] { return visit(handle->get(), f); });
}
/// The object as one of this dimension. @param advice what to do else, ends the message
/// @throws std::invalid_argument "where: ..." if it is of the other one
template <int Dim, class Object>
auto& of_dimension(Object& object, const char* where, const char* advice = "") {
  if (object.dimension != Dim)
    fail(where, std::string("a ") + Object::TYPE + " of " + name_of_dimension(object.dimension) +
                    ", expected one of " + name_of_dimension(Dim) + advice);
  return static_cast<typename Object::template Of<Dim>&>(object);
}

using ToolHandle = Handle<ToolObject>;
using MaterialHandle = Handle<MaterialObject>;
using ContactHandle = Handle<ContactObject>;

/// Reference nodes, elements and boundary facets of a space of P1 or P2 in every component on triangles or tetrahedra; the dofs
/// of a node must be adjacent.
/// @throws std::invalid_argument for any other space, and for an axisymmetric one in space
template <int Dim>
burnish::Mesh<Dim> mesh_of(typename Freefem<Dim>::Fespace* const& space, const char* where,
                           bool axisymmetric);
inline Discretization<2> discretized(burnish::Mesh<2> mesh) { return triangles(std::move(mesh)); }
inline Discretization<3> discretized(burnish::Mesh<3> mesh) { return tetrahedra(std::move(mesh)); }

/// FreeFEM's mesh of the space, shared with the script. @throws std::invalid_argument for an empty space
template <int Dim>
std::shared_ptr<const typename Freefem<Dim>::Mesh> shared_mesh(typename Freefem<Dim>::Fespace* const& space,
                                                               const char* where);

/// @throws std::invalid_argument for the axis 2 of a contact of the plane
template <int Dim, int axis> void require_axis() {
  if (axis >= Dim) fail("contact", "z is a coordinate in space, the contact is of the plane");
}

} // namespace burnish
