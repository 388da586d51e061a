#include "parallel/companion_mpi/mpi_ranks.hpp"
#include <algorithm>
#include <climits>
#include <cstring>
#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

namespace burnish {
namespace {

constexpr int LEFT = 1; // tag of the message of a rank that leaves
constexpr double GRACE =
    2; // [s] that a wait for a rank that has left goes on: its last numbers may be on their way
constexpr int BAD_INPUT = 20;            // exit status of ranks that have parted
constexpr long BUSY_TURNS = 2000;        // of a wait before it sleeps between looks
constexpr int NAP = 50;                  // [us]
constexpr std::size_t PORTION = 1 << 30; // bytes of one message

struct Leaving {
  int status;
  char reason[1000];
};

} // namespace

MpiRanks::MpiRanks(std::function<std::string()> reason) : m_reason(std::move(reason)) {
  MPI_Comm_dup(MPI_COMM_WORLD, &m_data);
  MPI_Comm_dup(MPI_COMM_WORLD, &m_control);
  MPI_Comm_rank(m_data, &m_rank);
  MPI_Comm_size(m_data, &m_size);
  m_screen = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
}

void MpiRanks::end_all(const std::string& text, int status) {
  std::string line = "burnish: " + text + "; all processes are ended\n";
  const std::string own = m_reason();
  if (!own.empty()) line += "burnish: process " + std::to_string(m_rank) + ": " + own + "\n";
  if (write(m_screen, line.data(), line.size()) < 0) status = BAD_INPUT;
  MPI_Abort(MPI_COMM_WORLD, status);
  _exit(status);
}

// Whether a rank for which this one waits will never come.
void MpiRanks::look_for_leavers() {
  int there = 0;
  MPI_Status from;
  MPI_Iprobe(MPI_ANY_SOURCE, LEFT, m_control, &there, &from);
  if (!there) return;
  if (m_since == 0) m_since = MPI_Wtime();
  if (MPI_Wtime() - m_since < GRACE) return;
  Leaving leaving{};
  MPI_Recv(&leaving, sizeof leaving, MPI_BYTE, from.MPI_SOURCE, LEFT, m_control, MPI_STATUS_IGNORE);
  const std::string why = leaving.reason;
  end_all("process " + std::to_string(from.MPI_SOURCE) + " has ended alone, with status " +
              std::to_string(leaving.status) + (why.empty() ? "" : ": " + why),
          leaving.status != 0 ? leaving.status : BAD_INPUT);
}

void MpiRanks::complete(MPI_Request request) {
  int done = 0;
  for (long turn = 0; !done; ++turn) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) break;
    if (turn % 64 == 63) sched_yield();
    if (turn < BUSY_TURNS) continue;
    look_for_leavers();
    usleep(NAP);
  }
  m_since = 0;
}

void MpiRanks::meet(Meeting what, long size) {
  long mine[4] = {static_cast<long>(what), -static_cast<long>(what), size, -size}, all[4];
  MPI_Request request;
  MPI_Iallreduce(mine, all, 4, MPI_LONG, MPI_MAX, m_data, &request);
  complete(request);
  if (all[0] != -all[1] || all[2] != -all[3])
    end_all("the processes have parted: process " + std::to_string(m_rank) +
                " does not do the same as the others any more",
            BAD_INPUT);
}

void MpiRanks::gather(double* values, const std::vector<std::size_t>& start) {
  meet(Meeting::GATHER, static_cast<long>(start.back()));
  std::vector<MPI_Request> requests;
  for (int r = 0; r < m_size; ++r) {
    const std::size_t most = PORTION / sizeof(double);
    for (std::size_t from = start[r]; from < start[r + 1]; from += most) {
      requests.emplace_back();
      MPI_Ibcast(values + from, static_cast<int>(std::min(most, start[r + 1] - from)), MPI_DOUBLE, r, m_data,
                 &requests.back());
    }
  }
  for (const MPI_Request request : requests) complete(request);
}

void MpiRanks::broadcast(void* data, std::size_t bytes, int from) {
  meet(Meeting::BROADCAST, from);
  for (std::size_t sent = 0; sent < bytes; sent += PORTION) {
    MPI_Request request;
    MPI_Ibcast(static_cast<char*>(data) + sent, static_cast<int>(std::min(PORTION, bytes - sent)), MPI_BYTE,
               from, m_data, &request);
    complete(request);
  }
}

long MpiRanks::least(long value) {
  meet(Meeting::LEAST, 0);
  long all = value;
  MPI_Request request;
  MPI_Iallreduce(&value, &all, 1, MPI_LONG, MPI_MIN, m_data, &request);
  complete(request);
  return all;
}

int MpiRanks::leave(int status) {
  Leaving mine{status, {}};
  m_reason().copy(mine.reason, sizeof mine.reason - 1);
  std::vector<MPI_Request> requests(m_size, MPI_REQUEST_NULL);
  for (int r = 0; r < m_size; ++r)
    if (r != m_rank) MPI_Isend(&mine, sizeof mine, MPI_BYTE, r, LEFT, m_control, &requests[r]);
  std::vector<int> statuses(m_size, status);
  for (int r = 0; r < m_size; ++r) {
    if (r == m_rank) continue;
    Leaving other{};
    MPI_Request request;
    MPI_Irecv(&other, sizeof other, MPI_BYTE, r, LEFT, m_control, &request);
    for (int done = 0; !done; MPI_Test(&request, &done, MPI_STATUS_IGNORE)) usleep(NAP);
    statuses[r] = other.status;
  }
  MPI_Waitall(m_size, requests.data(), MPI_STATUSES_IGNORE);
  MPI_Finalize();
  for (const int of_rank : statuses)
    if (of_rank != 0) return of_rank;
  return 0;
}

} // namespace burnish
