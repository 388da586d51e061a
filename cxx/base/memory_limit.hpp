#pragma once
// A damaged file may ask for more memory than the machine has.
#include <algorithm>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace burnish {

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
