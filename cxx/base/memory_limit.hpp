#pragma once
// How much memory there is for this process: a damaged file, or a fine mesh, may ask for more.
#include <algorithm>
#include <fstream>
#include <iomanip>
#include <limits>
#include <malloc.h>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <unistd.h>

namespace burnish {

/// Bytes that this process cannot get beyond those it has: memory and swap of the machine, the group of processes it is
/// in (cgroup, version 2), its own limit of address space. What others use is not counted; infinite if nothing is known.
inline double memory_left() {
  double size = 0, resident = 0, group = 0, left = std::numeric_limits<double>::infinity();
  std::ifstream("/proc/self/statm") >> size >> resident;
  const double page = static_cast<double>(sysconf(_SC_PAGESIZE));
  struct sysinfo machine;
  if (sysinfo(&machine) == 0)
    left =
        machine.mem_unit * (static_cast<double>(machine.totalram) + static_cast<double>(machine.totalswap)) -
        resident * page;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> group) left = std::min(left, group - resident * page);
  rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    left = std::min(left, static_cast<double>(limit.rlim_cur) - size * page);
  return std::max(left, 0.);
}

/// From now on blocks of 8 MB and more go back to the machine when they are freed. By itself glibc takes larger and larger ones from
/// its heap, where they stay: a sixth of the memory beside the factor of a large body. A small one would lose 4 % of its time.
inline void return_large_blocks() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 8 << 20);
#endif
}

/// The end of an error: how much that is, and what to do.
inline std::string memory_left_in_words() {
  std::ostringstream what;
  what << "this process can have " << std::fixed << std::setprecision(2) << memory_left() / 1e9
       << " GB more at most; take a coarser mesh or a larger machine";
  return what.str();
}

/// While one lives this process may take so many bytes more than it has now (std::bad_alloc beyond).
class MemoryLimit {
public:
  explicit MemoryLimit(double bytes) {
    getrlimit(RLIMIT_AS, &m_before);
    unsigned long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    if (pages == 0) return;
    rlimit limit = m_before;
    const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + static_cast<rlim_t>(bytes);
    limit.rlim_cur = std::min(m_before.rlim_cur, most);
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &m_before); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

private:
  rlimit m_before;
};

} // namespace burnish
