#pragma once
// The ranks of MPI. Only for the sources of this folder, which are linked with MPI and MUMPS, and not with the core.
#include "parallel/ranks.hpp"
#define OMPI_SKIP_MPICXX 1 // the C interface alone
#include <mpi.h>

namespace burnish {

/// What all ranks are about to do; a rank that is about to do another thing has parted from the others.
enum class Meeting : int { GATHER = 1, BROADCAST, LEAST, ANALYZE, FACTORIZE, SOLVE, RELEASE };

class MpiRanks final : public Ranks {
public:
  /// Of MPI_COMM_WORLD. @param reason text of this rank's last error
  explicit MpiRanks(std::function<std::string()> reason);
  int rank() const override { return m_rank; }
  int size() const override { return m_size; }
  void gather(double* values, const std::vector<std::size_t>& start) override;
  void broadcast(void* data, std::size_t bytes, int from) override;
  long least(long value) override;
  int leave(int status) override;

  MPI_Comm data() const { return m_data; }
  /// Waits until all ranks are about to do this, of so many numbers.
  void meet(Meeting what, long size);

private:
  void complete(MPI_Request request);
  void look_for_leavers();
  [[noreturn]] void end_all(const std::string& text, int status);

  std::function<std::string()> m_reason;
  int m_rank = 0, m_size = 1;
  int m_screen = 2; // file that errors go to
  MPI_Comm m_data = MPI_COMM_NULL, m_control = MPI_COMM_NULL;
  double m_since = 0; // that a rank has left while this one waits for it; 0: none
};

/// Of this process, once there are some.
MpiRanks& the_mpi_ranks();

} // namespace burnish
