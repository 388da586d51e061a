#include "parallel/ranks.hpp"
#include "base/companion_library.hpp"
#include <cstdlib>

namespace burnish {
namespace {

constexpr const char* MPI_LIBRARY = "burnish_mpi.so";
// Unknowns: below, exchanging takes what dividing saves (edp/manual/processes.md).
constexpr long DIVIDE_PLANE_FROM = 500000, DIVIDE_SPACE_FROM = 20000;

// Never destroyed: the end of the process asks for it.
std::unique_ptr<Ranks>& present_ranks() {
  static auto* const those = new std::unique_ptr<Ranks>(std::make_unique<Ranks>());
  return *those;
}

/// @returns -1 unless there is such a number
long asked_divide_from() {
  const char* const given = std::getenv("BURNISH_DIVIDE_FROM");
  return given && *given ? std::atol(given) : -1;
}

} // namespace

Ranks& ranks() { return *present_ranks(); }
void set_ranks(std::unique_ptr<Ranks> others) { present_ranks() = std::move(others); }

std::unique_ptr<Ranks> mpi_ranks(std::function<std::string()> reason) {
  using Make = Ranks* (*)(std::function<std::string()>);
  void* const library = open_companion(MPI_LIBRARY, "MPI", "libmumps-dev");
  const auto make = reinterpret_cast<Make>(companion_function(library, MPI_LIBRARY, "burnish_mpi_ranks"));
  return std::unique_ptr<Ranks>(make(std::move(reason)));
}

bool divided(long unknowns, int dim) {
  static const long asked = asked_divide_from();
  const long usual = dim == 2 ? DIVIDE_PLANE_FROM : DIVIDE_SPACE_FROM;
  return ranks().size() > 1 && unknowns >= (asked >= 0 ? asked : usual);
}

bool first_rank_says(bool answer) {
  char said = answer;
  ranks().broadcast(&said, 1, 0);
  return said != 0;
}

} // namespace burnish
