// The library burnish_mpi.so: ranks by MPI, factors by MUMPS.
#include "parallel/companion_mpi/mpi_ranks.hpp"
#include "parallel/companion_mpi/mumps_factor.hpp"

namespace burnish {
namespace {
MpiRanks* present_mpi_ranks = nullptr;
} // namespace
MpiRanks& the_mpi_ranks() { return *present_mpi_ranks; }
} // namespace burnish

/// The caller owns what is made.
extern "C" burnish::Ranks* burnish_mpi_ranks(std::function<std::string()> reason) {
  burnish::present_mpi_ranks = new burnish::MpiRanks(std::move(reason));
  return burnish::present_mpi_ranks;
}
extern "C" burnish::OrderedFactor* burnish_mpi_factor() { return new burnish::MumpsFactor; }
