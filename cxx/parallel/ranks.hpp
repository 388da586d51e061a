#pragma once
// The processes that run one script together. Every rank has the whole mesh, tools, contact and state and takes all decisions; the
// numbers that it needs from others come to all alike, so that the decisions are the same.
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace burnish {

/// One rank, unless a library for more is there (companion_mpi). All ranks make the same calls in the same order; where
/// one has left, or makes another call, the process says so and ends all.
class Ranks {
public:
  virtual ~Ranks() = default;
  virtual int rank() const { return 0; } ///< 0 .. size() - 1
  virtual int size() const { return 1; }
  /// Part r of the values is known to rank r, and to all afterwards.
  /// @param start size() + 1 numbers: part r is values[start[r]] .. values[start[r + 1]]
  virtual void gather(double* /*values*/, const std::vector<std::size_t>& /*start*/) {}
  /// The bytes of one rank become those of all.
  virtual void broadcast(void* /*data*/, std::size_t /*bytes*/, int /*from*/) {}
  /// The least of the ranks' values.
  virtual long least(long value) { return value; }
  /// Called once, at the end of the process: waits until all ranks have come to theirs.
  /// @param status exit status of this rank; @returns that of all: of rank 0, else the first that is not 0
  virtual int leave(int status) { return status; }
};

/// Those of this process.
Ranks& ranks();
/// To be called once, before anything else of this folder.
void set_ranks(std::unique_ptr<Ranks> others);
/// Of the processes of MPI, which must have begun, by the library burnish_mpi.so.
/// @param reason text of this rank's last error, for the others
/// @throws std::invalid_argument if the library cannot be opened
std::unique_ptr<Ranks> mpi_ranks(std::function<std::string()> reason);

/// Whether the work of a body with so many unknowns is divided among the ranks, else every rank does all of it. From
/// 500 000 on in the plane, 20 000 in space, or from the number in the environment's BURNISH_DIVIDE_FROM.
/// @param dim of the body: 2 or 3
bool divided(long unknowns, int dim);

/// Rank 0's answer to a question about the machine (files, clocks) that ranks might answer differently.
bool first_rank_says(bool answer);

} // namespace burnish
