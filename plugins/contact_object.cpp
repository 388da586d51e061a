// What a contact of a script holds beside its setup: its run, its solver, its matrices.
#include "base/error.hpp"
#include "freefem_solver.hpp"
#include "matrix.hpp"
#include "mesh/mesh_match.hpp"
#include "solver/column_factor.hpp"
#include "types.hpp"

namespace burnish {

template <int Dim> ContactRun<Dim>& ContactOf<Dim>::run() {
  if (!m_run) m_run = std::make_unique<ContactRun<Dim>>(setup, options);
  return *m_run;
}

template <int Dim>
void ContactOf<Dim>::replace(std::shared_ptr<ContactSetup<Dim>> other,
                             std::unique_ptr<ContactRun<Dim>> run_of_it) {
  stiffness.reset();
  pending.clear();
  condensed = nullptr;
  step = {};
  matrices = {};
  reader = {};
  solver.clear();
  m_run = std::move(run_of_it);
  setup = std::move(other);
}

template <int Dim> bool ContactOf<Dim>::take_solver(const std::string& name, Stack stack, const char* where) {
  const std::string known = name.empty() ? name : known_solver(name, where);
  if (known != solver) {
    solver = known;
    const auto make = [=]() -> std::unique_ptr<BodySolver<Dim>> {
      return std::make_unique<ColumnFactor<Dim>>(freefem_solver(known, stack));
    };
    run().corrector().set_solver(known.empty() ? nullptr
                                               : std::function<std::unique_ptr<BodySolver<Dim>>()>(make));
  }
  return known.empty() || takes_triangle(known);
}

template <int Dim>
MaterialOf<Dim>& ContactOf<Dim>::with_material(MaterialObject& material, const char* where) const {
  auto& object = of_dimension<Dim>(material, where);
  require_same_mesh<Dim>(object.workpiece().discretization(), "the material", setup->mesh(), "the contact",
                         where);
  return object;
}

template <int Dim>
const NodeBlockMatrix<Dim>& ContactOf<Dim>::blocks(const TripletView& K, const char* where) {
  const auto& read = called(where, [&]() -> const NodeBlockMatrix<Dim>& { return reader.read(K); });
  matrices.require_of(setup->mesh(), read, where);
  return read;
}

template <int Dim> double ContactOf<Dim>::linear_seconds() const {
  if (!m_run) return 0;
  const IterationCounts& counts = m_run->iteration().counts();
  return counts.factorization_seconds + counts.condensation_seconds + counts.solve_seconds;
}

template <int Dim> const ContactRun<Dim>& ContactOf<Dim>::running(const char* where) const {
  if (!m_run) fail(where, "no state yet: call approach or begin first");
  return *m_run;
}

template struct ContactOf<2>;
template struct ContactOf<3>;

} // namespace burnish
