#include "solver/ordered_factor.hpp"
#include "base/companion_library.hpp"
#include "parallel/ranks.hpp"
#include "solver/cholmod_factor.hpp"
#include "solver/halved_factor.hpp"

namespace burnish {

EliminationOrder elimination_order(const Graph& graph, Ordering ordering, int unknowns, int dim) {
  if (divided(unknowns, dim) && ranks().size() == 2) return order_of_halves(graph, ordering, ranks());
  return {fill_reducing_order(graph, ordering)};
}

std::unique_ptr<OrderedFactor> make_ordered_factor(int unknowns, int dim, const std::array<int, 2>& halves) {
  if (!divided(unknowns, dim)) return std::make_unique<CholmodFactor>();
  if (ranks().size() == 2) return std::make_unique<HalvedFactor>(ranks(), halves);
  constexpr const char* name = "burnish_mpi.so";
  void* const library = open_companion(name, "MPI", "libmumps-dev");
  using Make = OrderedFactor* (*)();
  return std::unique_ptr<OrderedFactor>(
      reinterpret_cast<Make>(companion_function(library, name, "burnish_mpi_factor"))());
}

} // namespace burnish
