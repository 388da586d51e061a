// Stiffness of a tool at the accepted state: how the forces that its drives exert change with its coordinates.
//   t.stiffness(c1, c2)   dQ/dq, change of the force on c1 per change of c2, both positive along the growing coordinate. c2 is moved;
//       every other coordinate, of all tools, goes on as it is driven: under motion it stays, under force it follows at that force,
//       whose own change the result is where c1 is one of them. Contact states stay, points that flow flow on: the slope of a step that goes
//       on like the last one. 0 without contact; nan where the other coordinates have no answer, at a limit load. A factorization
//       each time | force/length, force, force*length
//     c1        name of the coordinate whose force is asked for
//     c2        name of the coordinate that is moved
//     elastic=   true: no point flows, the stiffness at the start of unloading | | false
//     tangent=   matrix of a law of the script at the accepted state, symmetric | force/length | the material's own
//     > rcColumn("stiffness", roller.stiffness("y", "y"));
//     ! belongs to no contact
//     ! no step has been accepted yet
//     ! a step is under way
//     ! the law is the script's, expected tangent=
//     ! no material has been seen in a run of this contact
//     ! elastic= and tangent= exclude each other
//     ! follows others, expected one that they follow
#include "base/error.hpp"
#include "matrix.hpp"
#include "named.hpp"
#include "solver/block_symmetry.hpp"
#include "types.hpp"

namespace burnish {
namespace {

constexpr const char* WHERE = "tool.stiffness";

struct StiffnessTag {};
struct Stiffness {
  static const int n = 2;
  static basicAC_F0::name_and_type names[n];
  static double call(const Named& a, Method<ToolHandle, StiffnessTag> m, string* c1, string* c2) {
    return visit(m->get(), [&](auto& object) {
      constexpr int Dim = dim_of<decltype(object)>;
      const DrivenTool<Dim>& tool = *object.tool;
      const std::shared_ptr<ContactObject> added = object.contact.lock();
      if (!added)
        fail(WHERE, "tool \"" + tool.name() + "\" belongs to no contact, expected one that was added");
      auto& contact = of_dimension<Dim>(*added, WHERE);
      if (!contact.started()) fail(WHERE, "no step has been accepted yet, expected an accepted state");
      if (!contact.stiffness) contact.stiffness = std::make_unique<RunStiffness<Dim>>(WHERE, contact.run());
      const int k = contact.stiffness->coordinate(tool, *c1), l = contact.stiffness->coordinate(tool, *c2);
      contact.stiffness->require_accepted();
      return all(a, contact)(k, l);
    });
  }

private:
  template <int Dim> static Eigen::MatrixXd all(const Named& a, ContactOf<Dim>& contact) {
    const bool elastic = a.boolean("elastic", false);
    if (a.has("tangent")) {
      if (elastic) fail(WHERE, "elastic= and tangent= exclude each other: the matrix is what it is");
      const long size = contact.setup->mesh().num_dofs();
      const auto& blocks =
          contact.blocks(view_of(a.value<Matrice_Creuse<double>*>("tangent"), size, WHERE), WHERE);
      require_symmetric(blocks, LARGEST_ASYMMETRY, WHERE);
      return contact.stiffness->driven(blocks);
    }
    const std::shared_ptr<MaterialObject> material = contact.material.lock();
    if (!material)
      fail(WHERE,
           "no material has been seen in a run of this contact, expected tangent=, the tangent of the body");
    return contact.stiffness->driven(of_dimension<Dim>(*material, WHERE).workpiece(), elastic);
  }
};
basicAC_F0::name_and_type Stiffness::names[] = {{"elastic", &typeid(bool)},
                                                {"tangent", &typeid(Matrice_Creuse<double>*)}};

} // namespace

void register_tool_stiffness() {
  add_method<ToolHandle, StiffnessTag>("stiffness", [] {
    return new NamedOperator<Stiffness, double, Method<ToolHandle, StiffnessTag>, string*, string*>;
  });
}

} // namespace burnish
